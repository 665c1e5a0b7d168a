// SPDX-License-Identifier: GPL-3.0-or-later
// Is a polynomial zero as a function? Yes by algebra, no by balls, else unknown.
#include "algebra/ring/enclosure.hpp"
#include "algebra/ring/ring.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace resonform {
namespace {

// Independent of each other and of all other generators: p is zero exactly when all its coefficients over
// these are (i separates real from imaginary part; a phase is free by its constant theta_0).
bool is_free(GeneratorKind kind) {
    return kind == GeneratorKind::imaginary || kind == GeneratorKind::fast || kind == GeneratorKind::small ||
           kind == GeneratorKind::constant || kind == GeneratorKind::phase;
}

// Sample points of the domain: small rationals from a fixed sequence, so that answers repeat.
class Points {
public:
    // One value for each generator, of this order of magnitude, or nothing if the point lies outside the
    // domain.
    std::optional<std::vector<RealBall>> next(const Ring& ring, std::int64_t bits, const Rational& magnitude);

private:
    std::optional<RealBall> value_of(const Ring& ring, const Generator& g, const BallOf& before,
                                     std::int64_t bits);
    Rational any(bool positive) {
        const bool negative = !positive && integer() > 30;
        const Rational size = magnitude_ * fraction();
        return negative ? -size : size;
    }
    Rational fraction() { return Rational(integer()) / Rational(integer()); }
    int integer() { // 1 ... 60
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<int>((state_ >> 33) % 60) + 1;
    }
    std::uint64_t state_ = 20;
    Rational magnitude_ = 1;
    std::vector<std::pair<const Generator*, RealBall>> named_; // of this point, with their arguments
};

// A named function is any function: its values at different places, and those of its derivatives, are
// whatever one likes.
std::optional<RealBall> Points::value_of(const Ring& ring, const Generator& g, const BallOf& before,
                                         std::int64_t bits) {
    auto value = enclose(ring, g, before, bits);
    if (value || g.kind == GeneratorKind::root) return value;
    if (g.kind == GeneratorKind::function) {
        const RealBall u = enclose(ring, g.of.argument, before, bits).re();
        if (!u.is_finite()) return std::nullopt;
        for (const auto& [other, argument] : named_)
            if (other->of.symbol == g.of.symbol && other->of.derivative == g.of.derivative &&
                argument.overlaps(u))
                return std::nullopt; // perhaps the same place
        named_.emplace_back(&g, u);
    }
    return RealBall(any(g.positive), bits);
}

std::optional<std::vector<RealBall>> Points::next(const Ring& ring, std::int64_t bits,
                                                  const Rational& magnitude) {
    std::vector<RealBall> point;
    magnitude_ = magnitude;
    named_.clear();
    const BallOf before = [&](GeneratorId id) -> auto& { return point[static_cast<std::size_t>(id)]; };
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        const std::optional<RealBall> here = value_of(ring, g, before, bits);
        if (!here || !here->is_finite() || (g.positive && !here->is_positive()) ||
            (g.invertible && here->contains_zero()))
            return std::nullopt;
        point.push_back(*here);
    }
    return point;
}

bool holds_primitive(const Ring& ring, const Polynomial& p) {
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        if (ring.generator(id).kind != GeneratorKind::primitive) continue;
        for (const Term& t : p.terms()) {
            if (ring.exponent(t.monomial, id) != 0) return true;
        }
    }
    return false;
}

// Whether one of the real coefficients is proved non-zero somewhere in the domain.
bool proved_nonzero(const Ring& ring, const std::vector<std::pair<Monomial, Polynomial>>& coefficients) {
    constexpr int tries = 40;
    const Rational magnitudes[] = {1, Rational(1) / 20, Rational(1) / 400}; // domains may be narrow
    Points points;
    for (int n = 0; n < tries; ++n) {
        const std::int64_t bits = 64 << (n / 10); // 64 to 512
        const auto point = points.next(ring, bits, magnitudes[n % 3]);
        if (!point) continue;
        const BallOf at_point = [&](GeneratorId id) -> auto& {
            return (*point)[static_cast<std::size_t>(id)];
        };
        for (const auto& coefficient : coefficients) {
            if (holds_primitive(ring, coefficient.second)) continue;
            const RealBall here = enclose(ring, coefficient.second, at_point, bits).re();
            if (here.is_finite() && here.sign() != 0) return true;
        }
    }
    return false;
}

// Multiplies by the power of `lead` that makes its least exponent zero, so that its rule applies. The factor
// itself must not be rewritten first.
Polynomial cleared_of(const Ring& ring, const Polynomial& p, GeneratorId lead) {
    const int least = p.empty() ? 0 : std::min(0, ring.lowest_exponent(p, lead));
    if (least == 0) return p;
    return ring.multiply(p, Polynomial(ring.monomial(lead, -least), Rational(1)));
}

} // namespace

bool Ring::is_canonical() const {
    const bool independent =
        std::all_of(generators_.begin(), generators_.end(), [](const Generator& g) { return g.independent; });
    return independent && related_ &&
           std::none_of(relations_.begin(), relations_.end(),
                        [&](const Relation& r) { return !r.total && generator(r.lead).invertible; });
}

bool Ring::is_algebraic(GeneratorId id) const {
    const Generator& g = generator(id);
    if (g.kind == GeneratorKind::primitive) return true;
    if (g.kind == GeneratorKind::function && g.of.function != Function::named) return true;
    if (g.kind == GeneratorKind::root && g.index == 1) return false;
    return std::any_of(relations_.begin(), relations_.end(), [&](const Relation& r) {
        return r.lead == id && (r.degree > 1 || (!r.total && g.invertible));
    });
}

// Roots that were not eliminated: with sigma^-1 left, sigma^k and its radicand differ in form. Later
// roots first, as their radicands may hold earlier ones.
Polynomial Ring::cleared(const Polynomial& p) const {
    Polynomial form = reduce(p);
    for (std::size_t k = relations_.size(); k-- > 0;) {
        const Relation& relation = relations_[k];
        if (!relation.total && generator(relation.lead).invertible)
            form = cleared_of(*this, form, relation.lead);
    }
    return form;
}

Zero Ring::is_zero(const Polynomial& p) const {
    const Polynomial form = cleared(p);
    if (form.empty()) return Zero::yes;
    std::vector<GeneratorId> outer;
    for (GeneratorId id = 0; id < size(); ++id) {
        if (is_free(generator(id).kind)) outer.push_back(id);
    }
    return proved_nonzero(*this, collect(form, outer)) ? Zero::no : Zero::unknown;
}

} // namespace resonform
