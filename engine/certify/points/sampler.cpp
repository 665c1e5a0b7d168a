// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/points/sampler.hpp"

#include "algebra/number/error.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

constexpr int attempts_per_prime = 16;
constexpr int primes_per_search = 1 << 18; // a second or two

} // namespace

PointSampler::PointSampler(const Ring& ring, std::uint64_t seed)
    : ring_(ring), random_(seed), root_of_(static_cast<std::size_t>(ring.size()), -1),
      radicands_(static_cast<std::size_t>(ring.size())) {
    draw_powers();
    for (GeneratorId root = 0; root < ring.size(); ++root)
        for (const Term& term : ring.generator(root).radicand.terms()) {
            const std::vector<int> exponents = ring.exponents(term.monomial);
            std::vector<std::pair<std::size_t, int>> powers;
            for (std::size_t id = 0; id < exponents.size(); ++id)
                if (exponents[id] != 0) powers.emplace_back(id, exponents[id]);
            radicands_[static_cast<std::size_t>(root)].push_back({term.coefficient, std::move(powers)});
        }
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        const bool drawn = std::find(root_of_.begin(), root_of_.end(), id) != root_of_.end();
        int rest = g.kind == GeneratorKind::root && !drawn ? g.index : 1;
        for (int prime = 2; rest > 1; ++prime) {
            if (rest % prime == 0) witnesses_.push_back({id, prime, false});
            while (rest % prime == 0) rest /= prime;
        }
    }
}

void PointSampler::draw_powers() {
    std::vector<bool> used(root_of_.size(), false); // in radicands so far
    for (GeneratorId root = 0; root < ring_.size(); ++root) {
        const Generator& g = ring_.generator(root);
        if (g.kind != GeneratorKind::root) continue;
        for (GeneratorId id = 0; id < root; ++id) {
            const auto k = static_cast<std::size_t>(id);
            const GeneratorKind kind = ring_.generator(id).kind;
            const bool free = kind == GeneratorKind::parameter || kind == GeneratorKind::slow;
            if (free && !used[k] && g.radicand == Polynomial(ring_.monomial(id), 1)) root_of_[k] = root;
            for (const Term& term : g.radicand.terms())
                if (ring_.exponent(term.monomial, id) != 0) used[k] = true;
        }
    }
}

Point PointSampler::next() {
    for (int n = 0; n < primes_per_search; ++n) {
        const PrimeField field(random_prime(random_));
        if (!has_roots_of_numbers(field)) continue;
        const Residue i = field.imaginary_unit();
        Point point{field, std::vector<Residue>(static_cast<std::size_t>(ring_.size()))};
        for (int k = 0; k < attempts_per_prime; ++k)
            if (attempt(point, i)) {
                draw_variables(point);
                return point;
            }
    }
    refuse({"a random point at which all roots of the ring exist is found",
            std::to_string(witnesses_.size()),
            "use fewer roots, or roots of smaller index, in the equations",
            {}});
}

std::optional<GeneratorId> PointSampler::dependent_root() {
    const auto missing = [&] {
        return std::find_if(witnesses_.begin(), witnesses_.end(), [](const Witness& w) { return !w.found; });
    };
    for (int n = 0; n < primes_per_search && missing() != witnesses_.end(); ++n) {
        const PrimeField field(random_prime(random_));
        Point point{field, std::vector<Residue>(static_cast<std::size_t>(ring_.size()))};
        attempt(point, field.imaginary_unit());
    }
    const auto witness = missing();
    return witness == witnesses_.end() ? std::nullopt : std::optional(witness->root);
}

void PointSampler::draw_variables(Point& point) {
    for (GeneratorId id = 0; id < ring_.size(); ++id) {
        const GeneratorKind kind = ring_.generator(id).kind;
        if (kind == GeneratorKind::fast || kind == GeneratorKind::small || kind == GeneratorKind::phase)
            point.values[static_cast<std::size_t>(id)] = point.field.random_unit(random_);
    }
}

bool PointSampler::attempt(Point& point, Residue i) {
    const PrimeField& field = point.field;
    std::fill(point.values.begin(), point.values.end(), 0);
    for (GeneratorId id = 0; id < ring_.size(); ++id) {
        const Generator& g = ring_.generator(id);
        Residue& value = point.values[static_cast<std::size_t>(id)];
        switch (g.kind) {
        case GeneratorKind::imaginary: value = i; break;
        case GeneratorKind::fast:
        case GeneratorKind::small:
        case GeneratorKind::phase: break; // no root has them
        case GeneratorKind::parameter:
        case GeneratorKind::slow: {
            const Residue random = field.random_unit(random_);
            const GeneratorId root = root_of_[static_cast<std::size_t>(id)];
            value = root < 0 ? random : field.power(random, ring_.generator(root).index);
            if (root >= 0) point.values[static_cast<std::size_t>(root)] = random;
            break;
        }
        case GeneratorKind::root:
        case GeneratorKind::function: {
            if (value != 0) break; // drawn with its radicand
            const std::optional<Residue> here =
                g.kind == GeneratorKind::root ? root_value(point, id) : function_value(point, g);
            if (!here || *here == 0) return false;
            value = *here;
            break;
        }
        case GeneratorKind::constant:
        case GeneratorKind::primitive:
            refuse({"a normal form is certified over parameters, slow variables, roots and functions",
                    g.name,
                    "certify before the solution adds its constants",
                    {}});
        }
    }
    return true;
}

// Whether roots of numbers exist depends on the prime only, not on the point.
bool PointSampler::has_roots_of_numbers(const PrimeField& field) {
    for (GeneratorId id = 0; id < ring_.size(); ++id) {
        const Generator& g = ring_.generator(id);
        if (g.kind != GeneratorKind::root || g.radicand.size() != 1) continue;
        const Term& number = g.radicand.terms().front();
        if (number.monomial != Monomial{}) continue;
        const std::optional<Residue> radicand = field.from(number.coefficient);
        if (!radicand || *radicand == 0) return false;
        observe(field, id, *radicand);
        if (!field.root(*radicand, g.index)) return false;
    }
    return true;
}

std::optional<Residue> PointSampler::root_value(const Point& point, GeneratorId id) {
    const Generator& g = ring_.generator(id);
    const PrimeField& f = point.field;
    Residue radicand = 0;
    for (const RadicandTerm& term : radicands_[static_cast<std::size_t>(id)]) {
        const std::optional<Residue> coefficient = f.from(term.coefficient);
        if (!coefficient) throw UnluckyPoint();
        Residue product = *coefficient;
        for (const auto& [of, power] : term.powers)
            product = f.multiply(product, f.power(point.values[of], power));
        radicand = f.add(radicand, product);
    }
    if (radicand == 0) return std::nullopt;
    observe(f, id, radicand);
    return f.root(radicand, g.index);
}

// A point of the circle: s = 2 t/(1 + t^2), c = (1 - t^2)/(1 + t^2) = s (1 - t^2)/(2 t). Other functions are
// independent of everything.
std::optional<Residue> PointSampler::function_value(const Point& point, const Generator& g) {
    const PrimeField& f = point.field;
    if (g.of.function == Function::sine) half_tangent_ = f.random_unit(random_);
    if (g.of.function != Function::sine && g.of.function != Function::cosine) return f.random_unit(random_);
    const Residue square = f.multiply(half_tangent_, half_tangent_), below = f.add(1, square);
    if (below == 0) return std::nullopt;
    const Residue above =
        g.of.function == Function::sine ? f.add(half_tangent_, half_tangent_) : f.subtract(1, square);
    return f.multiply(above, f.inverse(below));
}

void PointSampler::observe(const PrimeField& field, GeneratorId root, Residue radicand) {
    for (Witness& w : witnesses_) {
        if (w.root != root || w.found || (field.prime() - 1) % static_cast<std::uint64_t>(w.prime) != 0)
            continue;
        const auto exponent =
            static_cast<std::int64_t>((field.prime() - 1) / static_cast<std::uint64_t>(w.prime));
        w.found = w.prime == 2 ? !field.is_square(radicand) : field.power(radicand, exponent) != 1;
    }
}

} // namespace resonform
