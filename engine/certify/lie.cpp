// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/lie.hpp"

#include "algebra/ring/fractions.hpp"
#include "certify/hamiltonian.hpp"
#include "certify/points/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace resonform {

namespace {

// The integral from 0 to i of the polynomial of lowest degree that is 1 at j and 0 at the other nodes
// 0 ... nodes - 1: entry [i][j].
std::vector<std::vector<Residue>> integrals(const Montgomery& m, std::size_t nodes) {
    const auto number = [&](std::size_t n) { return m.from(static_cast<std::int64_t>(n)); };
    std::vector<std::vector<Residue>> result(nodes, std::vector<Residue>(nodes, 0));
    for (std::size_t j = 0; j < nodes; ++j) {
        std::vector<Residue> polynomial{number(1)}; // the product of (tau - k)
        Residue below = number(1);
        for (std::size_t k = 0; k < nodes; ++k) {
            if (k == j) continue;
            const Residue node = number(k);
            below = m.multiply(below, m.subtract(number(j), node));
            polynomial.push_back(0);
            for (std::size_t e = polynomial.size() - 1; e > 0; --e)
                polynomial[e] = m.subtract(polynomial[e - 1], m.multiply(node, polynomial[e]));
            polynomial[0] = m.negate(m.multiply(node, polynomial[0]));
        }
        const Residue factor = m.inverse(below);
        for (std::size_t e = 0; e < polynomial.size(); ++e)
            polynomial[e] = m.multiply(m.multiply(factor, polynomial[e]), m.inverse(number(e + 1)));
        for (std::size_t i = 0; i < nodes; ++i) {
            const Residue node = number(i);
            for (std::size_t e = polynomial.size(); e-- > 0;)
                result[i][j] = m.multiply(node, m.add(result[i][j], polynomial[e]));
        }
    }
    return result;
}

class FlowAtPoint {
public:
    FlowAtPoint(const CertificatePlan& plan, const NormalForm& normal_form, const Point& point)
        : m_(point.field), weight_(weight_of_modes(*normal_form.field)), through_(normal_form.through),
          nodes_(static_cast<std::size_t>(std::max(through_ - weight_ + 1, 2))) {
        const HamiltonianForm& form = *normal_form.hamiltonian;
        std::vector<Residue> others = point.values; // the coordinates are set to 1
        for (const CertificatePlan::Coordinate& c : plan.coordinates) {
            places_.emplace(c.id, places_.size());
            others[static_cast<std::size_t>(c.id)] = 1;
        }
        const Point there{point.field, others};
        PointReader reader(*normal_form.field->ring, {&there, 1});
        for (const HamiltonianForm::Bracket& b : form.brackets) {
            Residue value = 0;
            for (const Residue term : reader.terms(b.value.fractions())) value = m_.add(value, term);
            brackets_.push_back({places_.at(b.left), places_.at(b.right), value});
        }
        read(*normal_form.field->ring, form.generator, reader);
        solve(plan, point);
    }

    // The coefficient of t^n of y_c(1).
    [[nodiscard]] Residue at_one(std::size_t coordinate, int n) const {
        return products_[coordinate].values[index(1, n)];
    }

private:
    using Exponents = std::vector<int>; // of the coordinates
    // A product of coordinates: an earlier one times a coordinate. By node and weight.
    struct Product {
        int degree;
        std::size_t left, right;
        std::vector<Residue> values;
    };
    // factor * t^weight * a product, in d chi/dy_c.
    struct SlopeTerm {
        std::size_t coordinate, product;
        int weight;
        Residue factor;
    };
    struct Bracket {
        std::size_t left, right;
        Residue value;
    };

    [[nodiscard]] std::size_t index(std::size_t node, int weight) const {
        return node * (static_cast<std::size_t>(through_) + 1) + static_cast<std::size_t>(weight);
    }

    std::size_t add_product(const Exponents& exponents, int degree, std::size_t left, std::size_t right) {
        products_.push_back({degree, left, right,
                             std::vector<Residue>(nodes_ * (static_cast<std::size_t>(through_) + 1), 0)});
        return known_.emplace(exponents, products_.size() - 1).first->second;
    }

    std::size_t product_of(const Exponents& exponents) {
        if (const auto known = known_.find(exponents); known != known_.end()) return known->second;
        Exponents rest = exponents;
        std::size_t right = 0;
        while (rest[right] == 0) ++right;
        --rest[right];
        const std::size_t left = product_of(rest);
        return add_product(exponents, products_[left].degree + 1, left, right);
    }

    void read(const Ring& ring, const Series& generator, PointReader& reader) {
        const std::size_t count = places_.size();
        for (std::size_t c = 0; c < count; ++c) {
            Exponents unit(count, 0);
            unit[c] = 1;
            add_product(unit, 1, c, c);
        }
        add_product(Exponents(count, 0), 0, 0, 0);          // 1
        std::map<std::pair<Exponents, int>, Residue> terms; // of chi: by exponents and weight of the rest
        for (int n = 0; n <= generator.through(); ++n) {
            const Fractions& part = generator.part(n).fractions();
            const std::vector<Residue> values = reader.terms(part);
            for (std::size_t k = 0; k < part.size(); ++k) {
                Exponents exponents(count, 0);
                int degree = 0;
                for (const auto& [id, place] : places_)
                    degree += exponents[place] = ring.exponent(part.monomials[k], id);
                Residue& sum = terms[{std::move(exponents), n - degree * weight_}];
                sum = m_.add(sum, values[k]);
            }
        }
        for (const auto& [term, value] : terms)
            for (std::size_t c = 0; c < count; ++c) {
                if (term.first[c] == 0) continue;
                Exponents rest = term.first;
                --rest[c];
                slopes_.push_back(
                    {c, product_of(rest), term.second, m_.multiply(m_.from(term.first[c]), value)});
            }
    }

    void solve(const CertificatePlan& plan, const Point& point) {
        const std::size_t count = places_.size();
        for (std::size_t node = 0; node < nodes_; ++node) {
            products_[count].values[index(node, 0)] = m_.enter(1);
            for (std::size_t c = 0; c < count; ++c)
                products_[c].values[index(node, weight_)] =
                    m_.enter(point.values[static_cast<std::size_t>(plan.coordinates[c].id)]);
        }
        const std::vector<std::vector<Residue>> weights = integrals(m_, nodes_);
        // Products of finite coordinates (weight 0) need these at the same weight, the generator does not.
        const auto multiply_all = [&](int n) {
            for (std::size_t p = count + 1; p < products_.size(); ++p) multiply(products_[p], n);
        };
        if (weight_ == 0) multiply_all(0);
        for (int n = weight_ + 1; n <= through_; ++n) {
            if (weight_ > 0) multiply_all(n);
            const std::vector<std::vector<Residue>> rates = rates_at(n);
            for (std::size_t c = 0; c < count; ++c)
                for (std::size_t node = 0; node < nodes_; ++node) {
                    Montgomery::Wide sum = 0;
                    for (std::size_t other = 0; other < nodes_; ++other)
                        m_.accumulate(sum, weights[node][other], rates[c][other]);
                    products_[c].values[index(node, n)] = m_.reduce(sum);
                }
            if (weight_ == 0) multiply_all(n);
        }
    }

    // The coefficient of t^n.
    void multiply(Product& product, int n) {
        const Product &left = products_[product.left], &right = products_[product.right];
        for (std::size_t node = 0; node < nodes_; ++node) {
            Montgomery::Wide sum = 0;
            for (int j = left.degree * weight_; j <= n - weight_; ++j)
                m_.accumulate(sum, left.values[index(node, j)], right.values[index(node, n - j)]);
            product.values[index(node, n)] = m_.reduce(sum);
        }
    }

    // The coefficient of t^n of dy_c/dtau, by coordinate and node.
    [[nodiscard]] std::vector<std::vector<Residue>> rates_at(int n) const {
        std::vector<std::vector<Montgomery::Wide>> slopes(places_.size(),
                                                          std::vector<Montgomery::Wide>(nodes_, 0));
        for (const SlopeTerm& term : slopes_) {
            if (term.weight > n) continue;
            const std::vector<Residue>& values = products_[term.product].values;
            for (std::size_t node = 0; node < nodes_; ++node)
                m_.accumulate(slopes[term.coordinate][node], term.factor,
                              values[index(node, n - term.weight)]);
        }
        std::vector<std::vector<Residue>> rates(places_.size(), std::vector<Residue>(nodes_, 0));
        for (const Bracket& b : brackets_)
            for (std::size_t node = 0; node < nodes_; ++node) {
                rates[b.left][node] = m_.multiply(b.value, m_.reduce(slopes[b.right][node]));
                rates[b.right][node] = m_.negate(m_.multiply(b.value, m_.reduce(slopes[b.left][node])));
            }
        return rates;
    }

    Montgomery m_;
    int weight_, through_; // of the modes; M
    std::size_t nodes_;
    std::map<GeneratorId, std::size_t> places_; // of the coordinates
    std::vector<Bracket> brackets_;
    std::vector<Product> products_; // the coordinates, 1, others each after its factors
    std::map<Exponents, std::size_t> known_;
    std::vector<SlopeTerm> slopes_;
};

} // namespace

std::string generator_complaint(const CertificatePlan& plan, const NormalForm& normal_form,
                                const PointRun& run, std::size_t number, const Point& point) {
    const FlowAtPoint flow(plan, normal_form, point);
    for (std::size_t c = 0; c < plan.coordinates.size(); ++c)
        for (int n = 0; n <= normal_form.through; ++n)
            if (flow.at_one(c, n) != run(plan.coordinates[c].mapped, n, number))
                return fmt::format("weight {}: the map of {} is not the Lie series of the generator",
                                   to_string(normal_form.field->system().weight(n)),
                                   plan.coordinates[c].mode);
    return "";
}

} // namespace resonform
