// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/drift_path.hpp"

#include "algebra/ring/constant.hpp"
#include "solve/quadrature.hpp"

#include <utility>

namespace resonform {

namespace {

class PathFinder {
public:
    PathFinder(const Solution& solution, std::size_t over, std::size_t of)
        : solution_(solution), ring_(*solution.ring), over_(over), of_(of),
          clock_(solution.slow.empty() ? *solution.slow_time : solution.slow.front().generator),
          x_(moved(over)), y_(moved(of)), x_rate_(rate(x_)), y_rate_(rate(y_)) {}

    [[nodiscard]] std::optional<DriftPath> find() const {
        if (x_rate_.empty() || y_rate_.empty()) return std::nullopt;
        const auto slope = quotient_in_ring(ring_, y_rate_, x_rate_); // dy/dx
        if (!slope) return std::nullopt;
        if (is_constant(ring_, *slope)) return straight(*slope);
        return exponential(*slope);
    }

private:
    // Without its constant.
    [[nodiscard]] Polynomial moved(std::size_t drift) const {
        const DriftSolution& d = solution_.drift[drift];
        return d.value.part(0) - ring_.gen(d.constant);
    }
    [[nodiscard]] Polynomial rate(const Polynomial& p) const { return ring_.derivative(p, clock_); }

    [[nodiscard]] std::optional<DriftPath> straight(const Polynomial& slope) const {
        DriftPath path{over_, of_, y_ - ring_.multiply(slope, x_), slope, ring_.one(), {}, {}};
        if (!is_constant(ring_, path.offset)) return std::nullopt;
        return path;
    }

    // x = scale log(argument), and y is a solution of scale^2 y'' = y - offset as a function of x, so that
    // y - offset + scale y' = 2 rising e^(x/scale), y - offset - scale y' = 2 falling e^(-x/scale).
    [[nodiscard]] std::optional<DriftPath> exponential(const Polynomial& slope) const {
        const auto logarithm = single_logarithm();
        const auto bend = quotient_in_ring(ring_, rate(slope), x_rate_);
        if (!logarithm || !bend) return std::nullopt;
        const auto& [scale, argument] = *logarithm;
        DriftPath path{over_, of_, {}, {}, scale, {}, {}};
        path.offset = y_ - ring_.multiply(ring_.multiply(scale, scale), *bend);
        if (!is_constant(ring_, path.offset)) return std::nullopt;
        const Polynomial rest = Rational(1) / 2 * (y_ - path.offset),
                         turned = Rational(1) / 2 * ring_.multiply(scale, slope);
        const auto rising = quotient_in_ring(ring_, rest + turned, argument);
        if (!rising) return std::nullopt;
        path.rising = *rising;
        path.falling = ring_.multiply(rest - turned, argument);
        if (!is_constant(ring_, path.rising) || !is_constant(ring_, path.falling)) return std::nullopt;
        return path;
    }

    // x as scale*log(argument), with a scale that can be divided by.
    [[nodiscard]] std::optional<std::pair<Polynomial, Polynomial>> single_logarithm() const {
        for (const Primitive& primitive : solution_.primitives) {
            if (primitive.kind != PrimitiveKind::logarithm) continue;
            const auto scale =
                quotient_in_ring(ring_, x_rate_, ring_.derivative(ring_.gen(primitive.id), clock_));
            if (scale && is_constant(ring_, *scale) && ring_.inverse(*scale) &&
                x_ == ring_.multiply(*scale, ring_.gen(primitive.id)))
                return std::pair(*scale, primitive.argument);
        }
        return std::nullopt;
    }

    const Solution& solution_;
    const Ring& ring_;
    std::size_t over_, of_;
    GeneratorId clock_;
    Polynomial x_, y_, x_rate_, y_rate_;
};

} // namespace

std::optional<DriftPath> drift_path(const Solution& solution) {
    if (solution.flow || solution.drift.size() != 2) return std::nullopt;
    if (auto path = PathFinder(solution, 0, 1).find()) return path;
    return PathFinder(solution, 1, 0).find();
}

} // namespace resonform
