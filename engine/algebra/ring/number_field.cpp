// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/number_field.hpp"

#include "algebra/number/elimination.hpp"
#include "algebra/number/rational_matrix.hpp"
#include "algebra/ring/polynomial.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace resonform {

namespace {

constexpr std::size_t largest_degree = 64;

class NumberField {
public:
    NumberField(const Ring& ring, const Polynomial& p) : ring_(ring) {
        for (const Term& t : p.terms())
            for (GeneratorId id = 0; id < ring.size(); ++id)
                if (ring.exponent(t.monomial, id) != 0) add(id);
        std::sort(ids_.begin(), ids_.end());
        for (const GeneratorId id : ids_) degree_ = std::min(degree_ * index(id), largest_degree + 1);
    }

    [[nodiscard]] bool holds_numbers() const { return numeric_ && degree_ > 1 && degree_ <= largest_degree; }

    // x with p x = 1, by the products of p with the basis.
    [[nodiscard]] std::optional<Polynomial> inverse(const Polynomial& p) const {
        std::vector<std::vector<Rational>> rows(degree_, std::vector<Rational>(degree_ + 1));
        rows[0][degree_] = 1;
        for (std::size_t column = 0; column < degree_; ++column) {
            const Polynomial product = ring_.multiply(p, Polynomial(basis(column), Rational(1)));
            for (const Term& t : product.terms()) {
                const auto row = position(t.monomial);
                if (!row) return std::nullopt;
                rows[*row][column] = t.coefficient;
            }
        }
        if (!solve_rows(rows, Rationals())) return std::nullopt;
        std::vector<Term> terms;
        for (std::size_t k = 0; k < degree_; ++k)
            if (!cln::zerop(rows[k].front())) terms.push_back({basis(k), rows[k].front()});
        return Polynomial::from_terms(std::move(terms));
    }

private:
    // Adds a generator and those of its radicand.
    void add(GeneratorId id) {
        if (std::find(ids_.begin(), ids_.end(), id) != ids_.end()) return;
        ids_.push_back(id);
        const Generator& g = ring_.generator(id);
        if (id == Ring::imaginary_unit) return;
        numeric_ = numeric_ && g.kind == GeneratorKind::root && g.index > 1;
        if (!numeric_) return;
        for (const Term& t : g.radicand.terms())
            for (GeneratorId inner = 0; inner < ring_.size(); ++inner)
                if (numeric_ && ring_.exponent(t.monomial, inner) != 0) add(inner);
    }

    [[nodiscard]] std::size_t index(GeneratorId id) const {
        return id == Ring::imaginary_unit ? 2
                                          : static_cast<std::size_t>(std::max(1, ring_.generator(id).index));
    }

    [[nodiscard]] Monomial basis(std::size_t k) const {
        Monomial m;
        for (const GeneratorId id : ids_) {
            m = m + ring_.monomial(id, static_cast<int>(k % index(id)));
            k /= index(id);
        }
        return m;
    }

    [[nodiscard]] std::optional<std::size_t> position(Monomial m) const {
        std::size_t k = 0, step = 1;
        for (const GeneratorId id : ids_) {
            const int e = ring_.exponent(m, id);
            if (e < 0 || static_cast<std::size_t>(e) >= index(id)) return std::nullopt;
            k += step * static_cast<std::size_t>(e);
            step *= index(id);
            m = m - ring_.monomial(id, e);
        }
        return m == Monomial{} ? std::optional(k) : std::nullopt;
    }

    const Ring& ring_;
    std::vector<GeneratorId> ids_;
    std::size_t degree_ = 1;
    bool numeric_ = true;
};

} // namespace

bool is_numeric_root(const Ring& ring, GeneratorId id) {
    const Generator& g = ring.generator(id);
    if (g.kind != GeneratorKind::root || g.index < 2) return false;
    for (const Term& t : g.radicand.terms())
        for (GeneratorId inner = 0; inner < ring.size(); ++inner)
            if (ring.exponent(t.monomial, inner) != 0 && !is_numeric_root(ring, inner)) return false;
    return true;
}

std::optional<Polynomial> inverse_in_number_field(const Ring& ring, const Polynomial& p) {
    if (p.size() < 2) return std::nullopt;
    Monomial common; // divides all terms; of numeric roots, negative exponents only
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        if (!ring.generator(id).invertible || id == Ring::imaginary_unit) continue;
        const int least = ring.lowest_exponent(p, id);
        if (least < 0 || !is_numeric_root(ring, id)) common = common + ring.monomial(id, least);
    }
    const Polynomial rest = divided(p, common);
    const NumberField field(ring, rest);
    if (!field.holds_numbers()) return std::nullopt;
    const std::optional<Polynomial> inverse = field.inverse(rest);
    if (!inverse) return std::nullopt;
    return ring.multiply(*inverse, Polynomial(ring.packing().scaled(common, -1), Rational(1)));
}

} // namespace resonform
