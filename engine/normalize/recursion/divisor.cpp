// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/divisor.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/real_ball.hpp"
#include "expand/ring/power_product.hpp"
#include "model/text/canonical.hpp"
#include "model/text/enclosure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace resonform {

const char* to_string(DivisorVerdict verdict) {
    switch (verdict) {
    case DivisorVerdict::removed: return "removed";
    case DivisorVerdict::kept_exact: return "kept exact";
    case DivisorVerdict::kept_near: return "kept near";
    case DivisorVerdict::ambiguous: return "ambiguous";
    }
    return "ambiguous";
}

namespace {

// Is |D|^2 smaller than near^2? nullopt: they agree within 10^-12 near^2 or the radius of the ball, and a
// certificate with rounded frequencies might decide otherwise. Exact equality is settled in is_near().
std::optional<bool> is_below(const RealBall& square, const Rational& near, std::int64_t bits) {
    RealBall excess = square;
    arb_sub(excess.get(), excess.get(), RealBall(near * near, bits).get(), bits);
    const bool below = excess.sign() < 0;
    arb_add_error(excess.get(), RealBall(near * near * power_of_ten(-12), bits).get());
    return excess.sign() == 0 ? std::nullopt : std::optional(below);
}

std::string size_for_message(const RealBall& square, const Rational& near) {
    RealBall size;
    arb_sqrtpos(size.get(), square.get(), std::numeric_limits<double>::digits + 10);
    return fmt::format(", |D| = {:.17g}, near = {:.17g}", nearest_double(size), cln::double_approx(near));
}

// 1/(a + i b) = numerator/norm, with the norm a^2 + b^2, or a or b where the other vanishes. reciprocal():
// nullopt where the ring has no inverse of the norm.
struct ComplexDivisor {
    Polynomial numerator, norm;
};

std::optional<Polynomial> reciprocal(const RingDomain&, const Ring& ring, const ComplexDivisor& c) {
    const auto inverse = ring.inverse(c.norm);
    return inverse ? std::optional(ring.multiply(c.numerator, *inverse)) : std::nullopt;
}

std::optional<GraphPart> reciprocal(const GraphDomain& domain, const Ring&, const ComplexDivisor& c) {
    const GraphPart numerator = domain.constant(c.numerator);
    const GraphPart inverse = domain.arithmetic().constant(domain.reciprocal(c.norm));
    return domain.dot({{1, &numerator, &inverse}});
}

// The name of its variable if no other mode belongs to this variable, else its own name.
std::string name_of_mode(const GradedField& field, std::size_t m) {
    const std::size_t variable = field.modes[m].variable;
    const auto modes = std::count_if(field.modes.begin(), field.modes.end(),
                                     [&](const Mode& mode) { return mode.variable == variable; });
    return modes > 1 ? field.modes[m].name : field.system().variables[variable].name;
}

} // namespace

template <class Domain>
DivisorTable<Domain>::DivisorTable(const GradedField& field, Domain domain, int mode)
    : field_(field), domain_(std::move(domain)), mode_(mode) {}

template <class Domain> auto DivisorTable<Domain>::of(const Monomial& monomial) -> const Divisor<Part>& {
    const Multiples multiples = multiples_of(monomial);
    const auto known = known_.find(multiples);
    if (known != known_.end()) return known->second;
    return known_.emplace(multiples, make({monomial, multiples})).first->second;
}

// Multiples of zero growths and frequencies are set to 0, so that equal divisors share one entry.
template <class Domain> auto DivisorTable<Domain>::multiples_of(const Monomial& monomial) const -> Multiples {
    const Ring& ring = *field_.ring;
    Multiples multiples;
    for (std::size_t m = 0; m < field_.modes.size(); ++m) {
        const Mode& mode = field_.modes[m];
        const int own = static_cast<int>(m) == mode_ ? 1 : 0;
        const int alpha = ring.exponent(monomial, mode.z) - own;
        const int conjugate = mode.is_real() ? 0 : ring.exponent(monomial, mode.zbar);
        multiples.push_back(mode.is_damped() ? alpha + conjugate : 0);
        multiples.push_back(mode.is_real() ? 0 : alpha - conjugate);
    }
    for (const AngleVariable& angle : field_.angles)
        multiples.push_back(angle.frequency.empty() ? 0 : ring.exponent(monomial, angle.phase));
    return multiples;
}

template <class Domain> auto DivisorTable<Domain>::make(const Asked& asked) -> Divisor<Part> {
    const Ring& ring = *field_.ring;
    const Multiples& multiples = asked.multiples;
    Polynomial growth, frequency;
    for (std::size_t m = 0; m < field_.modes.size(); ++m) {
        growth = growth + Rational(multiples[2 * m]) * field_.modes[m].growth;
        frequency = frequency + Rational(multiples[2 * m + 1]) * field_.modes[m].omega;
    }
    for (std::size_t a = 0; a < field_.angles.size(); ++a)
        frequency = frequency + Rational(multiples[2 * field_.modes.size() + a]) * field_.angles[a].frequency;
    if (ring.vanishes(frequency) && ring.vanishes(growth)) return {{}, DivisorVerdict::kept_exact, {}};
    return judged(growth, frequency, asked);
}

template <class Domain>
auto DivisorTable<Domain>::judged(const Polynomial& growth, const Polynomial& frequency, const Asked& asked)
    -> Divisor<Part> {
    const Ring& ring = *field_.ring;
    const Polynomial i = ring.imaginary();
    const Polynomial value = growth + ring.multiply(i, frequency);
    const bool real = ring.vanishes(frequency), imaginary = ring.vanishes(growth);
    if (is_near(asked)) return {value, DivisorVerdict::kept_near, {}};
    const Polynomial norm = real        ? growth
                            : imaginary ? frequency
                                        : ring.multiply(growth, growth) + ring.multiply(frequency, frequency);
    const bool nonzero = ring.inverse(norm) || (!real && ring.is_zero(frequency) == Zero::no) ||
                         (!imaginary && ring.is_zero(growth) == Zero::no);
    if (nonzero) {
        const Polynomial numerator = real        ? ring.one()
                                     : imaginary ? -i
                                                 : growth - ring.multiply(i, frequency);
        const std::optional<Part> inverse = reciprocal(domain_, ring, {numerator, norm});
        if (!inverse) missing_.push_back(norm);
        return {value, DivisorVerdict::removed, inverse.value_or(Part())};
    }
    refuse(Reason::undecided,
           {"a divisor is proved to be zero or to be non-zero before anything is divided by it",
            spell(asked),
            "write the frequencies so that their relation is plain, or give parameters numeric values",
            {}});
}

template <>
Divisor<NumberPart> DivisorTable<NumberDomain>::judged(const Polynomial& growth, const Polynomial& frequency,
                                                       const Asked& asked) {
    const std::int64_t bits = domain_.bits();
    const Polynomial value = growth + field_.ring->multiply(field_.ring->imaginary(), frequency);
    const ComplexBall d = domain_.value(value);
    if (const Rational& near = field_.system().near; !cln::zerop(near)) {
        RealBall square;
        arb_addmul(square.get(), d.re().get(), d.re().get(), bits);
        arb_addmul(square.get(), d.im().get(), d.im().get(), bits);
        const std::optional<bool> below = is_below(square, near, bits);
        if (!below) throw UndecidedDivisor{spell(asked) + size_for_message(square, near), true};
        if (*below) return {value, DivisorVerdict::kept_near, {}};
    }
    const auto inverse = domain_.inverse(domain_.constant(d));
    if (!inverse) throw UndecidedDivisor{spell(asked), false};
    return {value, DivisorVerdict::removed, *inverse};
}

template <class Domain> bool DivisorTable<Domain>::is_near(const Asked& asked) const {
    const Rational& near = field_.system().near;
    if (cln::zerop(near)) return false;
    const Multiples& multiples = asked.multiples;
    GiNaC::ex growth = 0, frequency = 0;
    for (std::size_t m = 0; m < field_.modes.size(); ++m) {
        growth += multiples[2 * m] * field_.basis.modes[m].eigenvalue.re;
        frequency += multiples[2 * m + 1] * field_.basis.modes[m].eigenvalue.im;
    }
    for (std::size_t a = 0; a < field_.angles.size(); ++a)
        frequency += multiples[2 * field_.modes.size() + a] * field_.angles[a].law;
    const GiNaC::ex square = (growth * growth + frequency * frequency).expand();
    if ((square - to_ginac(near * near)).expand().is_zero()) return true;
    if (!is_constant(square)) return false;
    RealBall size;
    for (std::int64_t bits = 64; bits <= 512; bits *= 2) {
        const std::optional<RealBall> here = enclose(square, {}, bits);
        if (!here) break;
        size = *here;
        if (const std::optional<bool> below = is_below(size, near, bits)) return *below;
    }
    refuse(Reason::undecided, {"a divisor is larger or smaller than near, by more than rounding errors",
                               spell(asked) + size_for_message(size, near),
                               "change near in [normal_form] a little",
                               {}});
}

template <class Domain> std::string DivisorTable<Domain>::spell(const Asked& asked) const {
    std::string growth, frequency;
    const auto add = [](std::string& text, int k, const std::string& name) {
        if (k == 0) return;
        text += text.empty() ? (k < 0 ? "-" : "") : (k < 0 ? " - " : " + ");
        text += (std::abs(k) == 1 ? "" : fmt::format("{}*", std::abs(k))) + name;
    };
    const Multiples& multiples = asked.multiples;
    for (std::size_t m = 0; m < field_.modes.size(); ++m) {
        const std::string name = name_of_mode(field_, m);
        add(growth, multiples[2 * m], "growth_" + name);
        add(frequency, multiples[2 * m + 1], "omega_" + name);
    }
    for (std::size_t a = 0; a < field_.angles.size(); ++a)
        add(frequency, multiples[2 * field_.modes.size() + a], "omega_" + field_.angles[a].name);
    if (!frequency.empty()) frequency = "i*(" + frequency + ")";
    const std::string of =
        mode_ < 0 ? ""
                  : " of " + field_.modes[static_cast<std::size_t>(mode_)].name; // else the place says it
    return fmt::format("D({}){} = {}{}{}", spell(asked.monomial), of, growth,
                       growth.empty() || frequency.empty() ? "" : " + ", frequency);
}

template <class Domain> std::string DivisorTable<Domain>::spell(const Monomial& monomial) const {
    const Ring& ring = *field_.ring;
    std::string text;
    for (const GeneratorId id : field_.outer()) {
        const int k = ring.exponent(monomial, id);
        if (k == 0) continue;
        const Generator& g = ring.generator(id);
        text += text.empty() ? "" : "*";
        text += g.kind == GeneratorKind::phase ? fmt::format("exp({}*i*{})", k, g.name)
                : k == 1                       ? g.name
                                               : fmt::format("{}^{}", g.name, k);
    }
    return text.empty() ? "1" : text;
}

template class DivisorTable<RingDomain>;
template class DivisorTable<GraphDomain>;
template class DivisorTable<NumberDomain>;

} // namespace resonform
