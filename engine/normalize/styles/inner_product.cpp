// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/styles/inner_product.hpp"

#include "algebra/number/rational_matrix.hpp"
#include "normalize/recursion/normalizer.hpp"
#include "normalize/styles/nilpotent_flow.hpp"

#include <algorithm>
#include <map>

namespace resonform {

namespace {

using Coefficients = std::map<VectorMonomial, Polynomial>;

// L_n between monomials that it connects: image(columns_k) = sum_r matrix(r, k) rows_r.
struct Block {
    std::vector<VectorMonomial> rows, columns;
    std::map<VectorMonomial, std::size_t> row_index, column_index;

    // Returns false if v is in the list already.
    static bool add(std::vector<VectorMonomial>& list, std::map<VectorMonomial, std::size_t>& index,
                    const VectorMonomial& v) {
        if (!index.emplace(v, list.size()).second) return false;
        list.push_back(v);
        return true;
    }
};

Polynomial combined(const RationalMatrix& m, std::size_t row, const std::vector<const Polynomial*>& of) {
    std::vector<std::pair<Rational, const Polynomial*>> addends;
    for (std::size_t k = 0; k < of.size(); ++k)
        if (!cln::zerop(m.at(row, k))) addends.emplace_back(m.at(row, k), of[k]);
    return combination(addends);
}

class InnerProductStyle : public HomologicalStyle<RingDomain> {
public:
    explicit InnerProductStyle(const GradedField& field)
        : ring_(*field.ring), domain_(field.ring), flow_(field), outer_(field.outer()) {}

    void solve(int weight, const Equations& equations, const std::vector<Polynomial>& right) const override {
        std::vector<Polynomial> corrections, rates, exact, last;
        for (std::size_t k = 0; k < equations.size(); ++k) {
            auto shares = equations[k]->divided(weight, right[k]);
            exact.push_back(std::move(shares.exact));
            rates.push_back(std::move(shares.near));
            last.push_back(shares.quotient);
            corrections.push_back(std::move(shares.quotient));
        }
        while (any(last)) {
            std::vector<Polynomial> next;
            for (std::size_t k = 0; k < equations.size(); ++k) {
                next.push_back(equations[k]->divided(weight, -image(equations, last, k)).quotient);
                corrections[k] = corrections[k] + next[k];
            }
            last = std::move(next);
        }
        Coefficients correction, rate;
        const Coefficients given = coefficients(equations, exact);
        for (const auto& entry : given)
            if (rate.count(entry.first) == 0) project(block_of(entry.first), given, correction, rate);
        for (std::size_t k = 0; k < equations.size(); ++k) {
            corrections[k] = corrections[k] + gathered(*equations[k], weight, correction);
            rates[k] = rates[k] + gathered(*equations[k], weight, rate);
            equations[k]->accept(weight, std::move(corrections[k]), std::move(rates[k]));
        }
    }

private:
    static bool any(const std::vector<Polynomial>& parts) {
        return std::any_of(parts.begin(), parts.end(), [](const Polynomial& p) { return !p.empty(); });
    }

    // (L_n c)_k
    [[nodiscard]] Polynomial image(const Equations& equations, const std::vector<Polynomial>& c,
                                   std::size_t k) const {
        std::vector<Polynomial> slopes, sources;
        for (const NilpotentFlow::Step& step : flow_.steps()) {
            slopes.push_back(domain_.derivative(c[k], step.to));
            sources.push_back(ring_.gen(step.from));
        }
        std::vector<Product> products;
        for (std::size_t s = 0; s < slopes.size(); ++s)
            products.push_back({flow_.steps()[s].factor, &slopes[s], &sources[s]});
        const Polynomial one = ring_.one();
        for (const ModeCoupling& coupling : flow_.row(equations[k]->mode()))
            for (std::size_t other = 0; other < equations.size(); ++other)
                if (equations[other]->mode() == static_cast<int>(coupling.mode))
                    products.push_back({-coupling.factor, &c[other], &one});
        return domain_.without_vanishing(ring_.dot(products), outer_);
    }

    [[nodiscard]] Coefficients coefficients(const Equations& equations,
                                            const std::vector<Polynomial>& parts) const {
        Coefficients result;
        for (std::size_t k = 0; k < equations.size(); ++k)
            for (auto& [monomial, coefficient] : ring_.collect(parts[k], outer_))
                result.emplace(VectorMonomial{equations[k]->mode(), monomial}, std::move(coefficient));
        return result;
    }

    [[nodiscard]] Polynomial gathered(HomologicalEquation<RingDomain>& equation, int weight,
                                      const Coefficients& all) const {
        std::vector<Polynomial> terms;
        for (const auto& [v, coefficient] : all) {
            if (v.mode != equation.mode() || coefficient.empty()) continue;
            equation.divisor_of(v.monomial, weight);
            terms.push_back(ring_.multiply(Polynomial(v.monomial, 1), coefficient));
        }
        return domain_.without_vanishing(sum(terms), outer_);
    }

    // The monomials that L_n and its adjoint reach from a monomial of the right-hand side.
    [[nodiscard]] Block block_of(const VectorMonomial& v) const {
        Block block;
        Block::add(block.rows, block.row_index, v);
        for (std::size_t r = 0; r < block.rows.size(); ++r)
            for (const VectorMonomial& source : flow_.sources(block.rows[r])) {
                if (!Block::add(block.columns, block.column_index, source)) continue;
                for (const auto& [image, factor] : flow_.image(source))
                    Block::add(block.rows, block.row_index, image);
            }
        return block;
    }

    // c = B+ R, N = R - B c, with the pseudo-inverse of the inner product.
    void project(const Block& block, const Coefficients& right, Coefficients& correction,
                 Coefficients& rate) const {
        RationalMatrix b(block.rows.size(), block.columns.size());
        std::vector<Rational> rows, columns;
        for (const VectorMonomial& v : block.rows) rows.push_back(flow_.square(v));
        for (std::size_t k = 0; k < block.columns.size(); ++k) {
            columns.push_back(flow_.square(block.columns[k]));
            for (const auto& [image, factor] : flow_.image(block.columns[k])) {
                Rational& entry = b.at(block.row_index.at(image), k);
                entry = entry + factor;
            }
        }
        const RationalMatrix solution = pseudo_inverse(b, rows, columns);
        RationalMatrix rest = multiply(b, solution);
        for (std::size_t r = 0; r < rest.rows(); ++r)
            for (std::size_t k = 0; k < rest.columns(); ++k)
                rest.at(r, k) = (r == k ? Rational(1) : Rational(0)) - rest.at(r, k);
        static const Polynomial zero;
        std::vector<const Polynomial*> given;
        for (const VectorMonomial& v : block.rows) {
            const auto found = right.find(v);
            given.push_back(found == right.end() ? &zero : &found->second);
        }
        for (std::size_t k = 0; k < block.columns.size(); ++k)
            correction[block.columns[k]] = combined(solution, k, given);
        for (std::size_t r = 0; r < block.rows.size(); ++r) rate[block.rows[r]] = combined(rest, r, given);
    }

    const Ring& ring_;
    RingDomain domain_;
    NilpotentFlow flow_;
    std::vector<GeneratorId> outer_;
};

} // namespace

Normalization normalize_inner_product(std::shared_ptr<const GradedField> field, int through,
                                      const NormalizeOptions& options) {
    check_order(*field, through);
    Normalization n = field->is_semisimple()
                          ? normalize_poincare(std::move(field), through, options)
                          : normalize_in_ring(std::move(field), through, options, [](const GradedField& f) {
                                return std::make_unique<InnerProductStyle>(f);
                            });
    n.normal_form.style = Style::inner_product;
    return n;
}

} // namespace resonform
