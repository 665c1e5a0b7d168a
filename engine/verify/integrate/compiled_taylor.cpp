// SPDX-License-Identifier: GPL-3.0-or-later
// The Taylor-series integrator over a compiled jet, in double: steps, step lengths, dense output.
#include "verify/integrate/breakpoints.hpp"
#include "verify/integrate/compiled_tape.hpp"
#include "verify/integrate/step_budget.hpp"
#include "verify/integrate/tape_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

// For the pendulum about the fastest at every tolerance from 1e-4 to 1e-13: 16 and 20 take up to a sixth
// longer, 10 takes twice as long at 1e-8.
constexpr int jet_order = 18;

class Taylor : public Integrator {
public:
    Taylor(const CompiledTape& tape, const Start& start)
        : tape_(tape), start_(start), rows_(tape.rows()), inverse_scale_(start.state.size()) {}

    Run run(const std::vector<double>& times, std::vector<std::vector<double>>& values) override {
        Run run;
        for (std::size_t i = 0; i < start_.state.size(); ++i) row(i)[0] = start_.state[i];
        double t = 0;
        for (std::size_t next = 0; next < times.size();) {
            tape_.expand(jet_order, rows_.data());
            if (run.steps == 0) first_scales();
            const double h = std::min(step(), 2 * (times.back() - t) + 1), end = t + h;
            if (!(end > t)) { // also where a coefficient is not finite
                run.failure = fmt::format("the steps end near t = {:.6g}", t);
                break;
            }
            if (rival_budget.is_spent(++run.steps, end, times.back())) {
                run.failure = fmt::format("more than {} steps", rival_budget.most);
                break;
            }
            for (; next < times.size() && times[next] <= end; ++next)
                for (std::size_t k = 0; k < start_.wanted.size(); ++k)
                    values[k][next] = value(start_.wanted[k], times[next] - t);
            for (std::size_t i = 0; i < start_.state.size(); ++i) row(i)[0] = value(i, end - t);
            t = end;
        }
        run.evaluations = run.steps;
        return run;
    }

private:
    double* row(std::size_t state) { return rows_.data() + state * jet_stride + jet_pad; }

    double value(std::size_t state, double h) {
        const double* c = row(state);
        double sum = c[jet_order];
        for (int k = jet_order - 1; k >= 0; --k) sum = sum * h + c[k];
        return sum;
    }

    // A state may start at zero: then its first coefficients, over the time on which the solution changes,
    // say how large it is about to be.
    void first_scales() {
        double time_scale = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < start_.state.size(); ++i) {
            const double* c = row(i);
            const double low = std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2])});
            if (low > 0 && c[jet_order] != 0)
                time_scale = std::min(time_scale, std::pow(low / std::abs(c[jet_order]), 1.0 / jet_order));
        }
        if (!std::isfinite(time_scale)) time_scale = 1;
        for (std::size_t i = 0; i < start_.state.size(); ++i) {
            double scale = 0, power = 1;
            for (int k = 0; k < jet_order && (k < 3 || scale == 0); ++k, power *= time_scale)
                scale = std::max(scale, std::abs(row(i)[k]) * power);
            inverse_scale_[i] = scale > 0 ? 1 / scale : 0;
        }
    }

    // The longest step with |c_k| h^k <= tolerance*scale for the last two k, in every state; the scale is the
    // largest value so far.
    double step() {
        double last = 0, before = 0, sum = 0;
        for (std::size_t i = 0; i < start_.state.size(); ++i) {
            const double* c = row(i);
            const double size = std::abs(c[0]);
            if (size * inverse_scale_[i] > 1) inverse_scale_[i] = 1 / size;
            last = std::max(last, std::abs(c[jet_order]) * inverse_scale_[i]);
            before = std::max(before, std::abs(c[jet_order - 1]) * inverse_scale_[i]);
            sum += c[jet_order] + c[jet_order - 1];
        }
        if (!std::isfinite(sum)) return sum - sum; // no number, as the maxima need not be
        const auto longest = [this](double coefficient, int k) {
            return coefficient == 0 ? std::numeric_limits<double>::infinity()
                                    : std::pow(start_.tolerance / coefficient, 1.0 / k);
        };
        double h = std::min(longest(last, jet_order), longest(before, jet_order - 1));
        for (const Tape::Data& data : tape_.data())
            h = within_piece(*data.samples, row(static_cast<std::size_t>(data.state)), jet_order, h);
        return h;
    }

    const CompiledTape& tape_;
    Start start_;
    std::vector<double> rows_, inverse_scale_;
};

} // namespace

std::unique_ptr<Integrator> make_taylor(const CompiledTape& tape, const Start& start) {
    return std::make_unique<Taylor>(tape, start);
}

} // namespace resonform
