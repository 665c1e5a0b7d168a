// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/closed_roots.hpp"

#include "algebra/number/error.hpp"
#include "expand/ring/power_product.hpp"
#include "model/text/canonical.hpp"
#include "model/text/zero_test.hpp"

#include <fmt/format.h>

#include <optional>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

ex root_of(const ex& e) { return GiNaC::sqrt(e); }

// The factors of a rational function: (base, exponent), numbers among them.
std::vector<std::pair<ex, int>> powers_of(const ex& e) {
    const ex fraction = e.normal().numer_denom();
    std::vector<std::pair<ex, int>> factors;
    for (const int side : {0, 1}) {
        GiNaC::exmap atoms; // pi and roots, kept as symbols
        const ex polynomial = fraction.op(static_cast<std::size_t>(side)).to_polynomial(atoms);
        const ex factored = GiNaC::factor(polynomial);
        for (const ex& f : factors_of(factored)) {
            const bool power = GiNaC::is_a<GiNaC::power>(f) && f.op(1).info(GiNaC::info_flags::posint);
            const int exponent = power ? GiNaC::ex_to<numeric>(f.op(1)).to_int() : 1;
            factors.emplace_back((power ? f.op(0) : f).subs(atoms, GiNaC::subs_options::no_pattern),
                                 side == 0 ? exponent : -exponent);
        }
    }
    return factors;
}

class ClosedRoots {
public:
    ClosedRoots(const System& system, const BlockName& name) : system_(system), name_(name) {}

    std::vector<EigenRoot> of(const std::vector<ex>& lower) const {
        if (lower.size() == 1) return {{{{1, 0}}, {(-lower[0]).normal(), 0}}};
        if (lower.size() == 2) return of_quadratic(lower[1], lower[0]);
        return of_biquadratic(lower[2], lower[0]);
    }

private:
    enum class Sign { negative, zero, positive };

    [[nodiscard]] Sign sign_of(const ex& e) const {
        if (provably_positive(e, system_)) return Sign::positive;
        if (provably_positive((-e).expand(), system_)) return Sign::negative;
        if (vanishes(e) == Zero::yes) return Sign::zero;
        refuse(Reason::undecided,
               {"signs that decide whether eigenvalues are real are proved",
                fmt::format("{} for {}", spell(e), name_.variables), how_to_make_positive(e), name_.place});
    }

    // |f| for a factor of known sign.
    [[nodiscard]] std::optional<ex> absolute(const ex& f) const {
        if (provably_positive(f, system_)) return f;
        if (provably_positive((-f).expand(), system_)) return (-f).expand();
        return std::nullopt;
    }

    struct Root { // outside * sqrt(inside), outside > 0
        ex outside, inside;
    };

    // sqrt(q) of a positive q, squares taken out.
    [[nodiscard]] Root extracted(const ex& q) const {
        Root root{1, 1};
        for (const auto& [base, exponent] : powers_of(q)) {
            if (GiNaC::is_a<numeric>(base)) {
                root = with_number(root, GiNaC::pow(base, exponent));
                continue;
            }
            const auto positive = absolute(base);
            const int whole = positive ? (exponent - (exponent & 1)) / 2 : 0;
            if (positive) root.outside *= GiNaC::pow(*positive, whole);
            root.inside *= GiNaC::pow(base, exponent - 2 * whole);
        }
        return {root.outside, root.inside.expand()};
    }

    // A rational number c: the largest square of a divisor is taken out, by trial.
    static Root with_number(Root root, const ex& c) {
        numeric inside = GiNaC::ex_to<numeric>(c).numer() * GiNaC::ex_to<numeric>(c).denom();
        root.outside /= GiNaC::ex_to<numeric>(c).denom();
        const numeric whole = GiNaC::isqrt(GiNaC::abs(inside));
        if ((whole * whole).is_equal(GiNaC::abs(inside))) {
            root.outside *= whole;
            inside = inside.is_negative() ? -1 : 1;
        }
        for (int p = 2; p < 100; ++p)
            while (GiNaC::irem(inside, p * p).is_zero()) {
                inside = GiNaC::iquo(inside, p * p);
                root.outside *= p;
            }
        root.inside *= inside;
        return root;
    }

    [[nodiscard]] std::vector<EigenRoot> of_quadratic(const ex& b, const ex& c) const {
        const ex middle = (-b / 2).normal();
        const ex square = (c - b * b / 4).normal();
        if (sign_of(square) == Sign::positive) {
            const ex omega = root_of(square);
            return {of_value({middle, omega}, 2)};
        }
        const ex root = root_of((-square).normal());
        return {of_value({middle - root, 0}, 2), of_value({middle + root, 0}, 2)};
    }

    static EigenRoot of_value(const Complex& value, std::size_t degree) {
        EigenRoot root{{{1, 0}}, value};
        while (root.powers.size() < degree) root.powers.push_back(root.powers.back() * value);
        return root;
    }

    // lambda^2 = square, known in fewer roots than lambda.
    static EigenRoot of_square(const Complex& value, const Complex& square) {
        return {{{1, 0}, value, square, square * value}, value};
    }

    [[nodiscard]] std::vector<EigenRoot> of_biquadratic(const ex& b, const ex& c) const {
        const ex q = (b * b / 4 - c).normal();
        if (sign_of(q) != Sign::positive) return quadruple(b, c, (-q).normal());
        const bool down = sign_of(b) == Sign::negative;
        const ex h = down ? (-b / 2).normal() : (b / 2).normal();
        const bool alike = sign_of(c) == Sign::positive;
        const Squares s = squares_of(h, q, c, alike);
        std::vector<EigenRoot> roots;
        // lambda^2 = -big for b >= 0; the other square has the same sign if c > 0
        add(roots, s.small, s.small_root, alike == down);
        add(roots, s.big, s.big_root, down);
        return roots;
    }

    struct Squares {
        ex big, big_root, small, small_root; // big, small > 0
    };

    // The roots of x^2 - 2 h x + c, their absolute values: h >= 0, q = h^2 - c > 0.
    [[nodiscard]] Squares squares_of(const ex& h, const ex& q, const ex& c, bool alike) const {
        if (alike)
            if (const auto nested = denested(h, c)) return *nested;
        const Root root = extracted(q);
        const ex ratio = (h / root.outside).normal().numer_denom(); // h = outside * P/Q
        // GiNaC may return P/Q or -P/-Q.
        const int turn = provably_positive(-root.outside / ratio.op(1), system_) ? -1 : 1;
        const ex above = turn * ratio.op(0), below = turn * ratio.op(1);
        const ex common = (root.outside / below).normal();
        const ex sqrt_q = root.outside * root_of(root.inside);
        const bool factors = provably_positive(common, system_);
        const ex big = factors ? common * (above + below * root_of(root.inside)) : h + sqrt_q;
        const ex rest = alike ? c : ex(-c);
        return {big, root_of(big), alike ? h - sqrt_q : sqrt_q - h, root_of(rest) / root_of(big)};
    }

    // c = n^2: sqrt(h +- sqrt(q)) = alpha +- beta with alpha^2 = (h + n)/2, beta^2 = (h - n)/2.
    [[nodiscard]] std::optional<Squares> denested(const ex& h, const ex& c) const {
        ex n = 1;
        for (const auto& [base, exponent] : powers_of(c)) {
            const ex part = GiNaC::is_a<numeric>(base) ? root_of(GiNaC::pow(base, exponent)) : base;
            if (GiNaC::is_a<numeric>(base) ? !part.info(GiNaC::info_flags::rational) : (exponent & 1) != 0)
                return std::nullopt;
            n *= GiNaC::is_a<numeric>(base) ? part : GiNaC::pow(base, exponent / 2);
        }
        const auto positive = absolute(n);
        if (!positive) return std::nullopt;
        const ex up = ((h + *positive) / 2).normal(), down = ((h - *positive) / 2).normal();
        if (!provably_positive(up, system_) || !provably_positive(down, system_)) return std::nullopt;
        const ex ratio = (up / down).normal(), beta = root_of(down);
        if (GiNaC::is_a<numeric>(ratio)) { // of one symbolic root
            const ex root = root_of(ratio), product = 2 * down * root;
            return Squares{h + product, beta * (root + 1), h - product, beta * (root - 1)};
        }
        const ex alpha = root_of(up), product = 2 * alpha * beta;
        if (!provably_positive(alpha - beta, system_)) return std::nullopt;
        return Squares{h + product, alpha + beta, h - product, alpha - beta};
    }

    // lambda^2 = square (growing) or -square.
    static void add(std::vector<EigenRoot>& roots, const ex& square, const ex& root, bool growing) {
        if (growing) {
            roots.push_back(of_square({-root, 0}, {square, 0}));
            roots.push_back(of_square({root, 0}, {square, 0}));
        } else {
            roots.push_back(of_square({0, root}, {-square, 0}));
        }
    }

    // lambda = +-alpha + i beta: lambda^2 = -b/2 +- i sqrt(p), |lambda|^2 = sqrt(c).
    [[nodiscard]] std::vector<EigenRoot> quadruple(const ex& b, const ex& c, const ex& p) const {
        const Root n = extracted(c);
        const ex modulus = n.outside * root_of(n.inside), root = root_of(p);
        const bool down = sign_of(b) == Sign::negative;
        const ex large = root_of(((down ? ex(-b) : b) / 2 + modulus) / 2), small = root / 2 / large;
        const ex alpha = down ? large : small, beta = down ? small : large;
        const ex re = (-b / 2).normal();
        return {of_square({-alpha, beta}, {re, -root}), of_square({alpha, beta}, {re, root})};
    }

    const System& system_;
    const BlockName& name_;
};

} // namespace

std::vector<EigenRoot> closed_roots(const std::vector<ex>& lower, const System& system,
                                    const BlockName& name) {
    return ClosedRoots(system, name).of(lower);
}

} // namespace resonform
