// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/inner_product.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace resonform {

namespace {

using Exponents = std::vector<int>;          // of all generators; those of coefficients are 0
using Component = std::pair<int, Exponents>; // of the mode, or of another variable (-1)
using Vector = std::map<Component, Residue>;
using Row = std::map<std::size_t, Residue>;

// n_ab of the modes and their conjugates, by generator.
struct Link {
    std::size_t to, from;
    Rational factor;
};

std::vector<Link> links_of(const GradedField& field) {
    std::vector<Link> links;
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        for (const ModeCoupling& c : field.basis.modes[k].couplings) {
            const Mode &to = field.modes[k], &from = field.modes[c.mode];
            links.push_back({static_cast<std::size_t>(to.z), static_cast<std::size_t>(from.z), c.factor});
            if (!to.is_real())
                links.push_back(
                    {static_cast<std::size_t>(to.zbar), static_cast<std::size_t>(from.zbar), c.factor});
        }
    return links;
}

bool is_outer(const Generator& g) {
    return g.kind == GeneratorKind::fast || g.kind == GeneratorKind::small || g.kind == GeneratorKind::phase;
}

class PointScan {
public:
    PointScan(const GradedField& field, const FrequencySample& sample, const Resonance& resonance)
        : field_(field), ring_(*field.ring), sample_(sample), f_(sample.field), resonance_(resonance),
          links_(links_of(field)) {
        for (const Link& link : links_) factors_.push_back(f_.from(link.factor).value());
        families_.resize(static_cast<std::size_t>(ring_.size()));
        for (std::size_t id = 0; id < families_.size(); ++id) families_[id] = id;
        for (bool found = true; found;) {
            found = false;
            for (const Link& link : links_) {
                const std::size_t lower = std::min(families_[link.to], families_[link.from]);
                found = found || families_[link.to] != families_[link.from];
                families_[link.to] = families_[link.from] = lower;
            }
        }
    }

    // The part of `series` at `weight` with D = 0, its coefficients evaluated.
    void add(Vector& v, int mode, const Series& series, int weight) const {
        for (const Term& term : series.part(weight).terms()) {
            Exponents exponents = ring_.exponents(term.monomial);
            Residue value = f_.from(term.coefficient).value(); // part (a) has read it at this prime
            for (std::size_t id = 0; id < exponents.size(); ++id) {
                if (is_outer(ring_.generator(static_cast<GeneratorId>(id)))) continue;
                value = f_.multiply(value, f_.power(sample_.generators[id], exponents[id]));
                exponents[id] = 0;
            }
            if (!resonance_.is_exact(exponents, mode)) continue;
            Residue& entry = v[{mode, exponents}];
            entry = f_.add(entry, value);
        }
    }

    [[nodiscard]] bool adjoint_vanishes(const Vector& v) const {
        Vector image;
        for (const auto& [component, value] : v) {
            const auto& [mode, exponents] = component;
            for (std::size_t l = 0; l < links_.size(); ++l) {
                const int power = exponents[links_[l].from];
                if (power == 0) continue;
                add_to(image, {mode, moved(exponents, links_[l].from, links_[l].to)},
                       f_.multiply(f_.from(power), f_.multiply(factors_[l], value)));
            }
            for (std::size_t l = 0; l < links_.size(); ++l) // f_k -> n_kj f_k in component j
                if (mode >= 0 && links_[l].to == generator(mode))
                    add_to(image, {mode_of(links_[l].from), exponents},
                           f_.negate(f_.multiply(factors_[l], value)));
        }
        return std::all_of(image.begin(), image.end(), [](const auto& entry) { return entry.second == 0; });
    }

    [[nodiscard]] bool is_orthogonal_to_kernel(const Vector& v) const {
        std::map<Exponents, Vector> blocks;
        for (const auto& [component, value] : v) blocks[degrees(component)][component] = value;
        return std::all_of(blocks.begin(), blocks.end(),
                           [&](const auto& block) { return in_row_space(block.second); });
    }

private:
    [[nodiscard]] std::size_t generator(int mode) const {
        return static_cast<std::size_t>(field_.modes[static_cast<std::size_t>(mode)].z);
    }
    [[nodiscard]] int mode_of(std::size_t generator) const {
        const auto found = std::find_if(field_.modes.begin(), field_.modes.end(), [&](const Mode& m) {
            return static_cast<std::size_t>(m.z) == generator;
        });
        return static_cast<int>(found - field_.modes.begin());
    }
    void add_to(Vector& v, const Component& component, Residue value) const {
        Residue& entry = v[component];
        entry = f_.add(entry, value);
    }
    static Exponents moved(Exponents exponents, std::size_t from, std::size_t to) {
        --exponents[from];
        ++exponents[to];
        return exponents;
    }

    // The invariants of L: the degree in each family, and the family of the mode.
    [[nodiscard]] Exponents degrees(const Component& component) const {
        Exponents sums(families_.size() + 1, 0);
        for (std::size_t id = 0; id < families_.size(); ++id) sums[families_[id]] += component.second[id];
        sums.back() = component.first < 0 ? -1 : static_cast<int>(families_[generator(component.first)]);
        return sums;
    }

    // All components with the same invariants.
    [[nodiscard]] std::vector<Component> basis_like(const Component& component) const {
        std::vector<Exponents> monomials{Exponents(families_.size(), 0)};
        const Exponents sums = degrees(component);
        for (std::size_t id = 0; id < families_.size(); ++id) {
            std::vector<Exponents> longer;
            const bool last = std::find(families_.begin() + static_cast<std::ptrdiff_t>(id) + 1,
                                        families_.end(), families_[id]) == families_.end();
            for (const Exponents& monomial : monomials) {
                int left = sums[families_[id]];
                for (std::size_t other = 0; other < id; ++other)
                    if (families_[other] == families_[id]) left -= monomial[other];
                for (int power = last ? left : 0; last ? power == left : power <= left; ++power) {
                    longer.push_back(monomial);
                    longer.back()[id] = power;
                }
            }
            monomials = std::move(longer);
        }
        std::vector<Component> basis;
        for (int mode = component.first < 0 ? -1 : 0;
             mode < (component.first < 0 ? 0 : static_cast<int>(field_.modes.size())); ++mode)
            for (const Exponents& monomial : monomials)
                if (degrees({mode, monomial}) == sums) basis.emplace_back(mode, monomial);
        return basis;
    }

    // The rows of L over the columns `basis`.
    [[nodiscard]] std::vector<Row> rows_of(const std::vector<Component>& basis) const {
        std::map<Component, std::size_t> index;
        for (std::size_t k = 0; k < basis.size(); ++k) index.emplace(basis[k], k);
        std::vector<Row> rows(basis.size());
        const auto add_entry = [&](const Component& row, std::size_t column, Residue value) {
            Residue& entry = rows[index.at(row)][column];
            entry = f_.add(entry, value);
        };
        for (std::size_t k = 0; k < basis.size(); ++k) {
            const auto& [mode, exponents] = basis[k];
            for (std::size_t l = 0; l < links_.size(); ++l) {
                if (exponents[links_[l].to] > 0)
                    add_entry({mode, moved(exponents, links_[l].to, links_[l].from)}, k,
                              f_.multiply(f_.from(exponents[links_[l].to]), factors_[l]));
                if (mode >= 0 && links_[l].from == generator(mode))
                    add_entry({mode_of(links_[l].to), exponents}, k, f_.negate(factors_[l]));
            }
        }
        return rows;
    }

    void eliminate(Row& row, const Row& by) const {
        const auto found = row.find(by.begin()->first);
        if (found == row.end()) return;
        const Residue factor = f_.negate(f_.multiply(found->second, f_.inverse(by.begin()->second)));
        for (const auto& [column, value] : by) {
            Residue& entry = row[column];
            entry = f_.add(entry, f_.multiply(factor, value));
            if (entry == 0) row.erase(column);
        }
    }

    [[nodiscard]] bool in_row_space(const Vector& v) const {
        const std::vector<Component> basis = basis_like(v.begin()->first);
        std::map<std::size_t, Row> echelon; // by first column
        const auto reduce = [&](Row& row) {
            for (const auto& [column, by] : echelon) eliminate(row, by);
        };
        for (Row row : rows_of(basis)) {
            for (auto entry = row.begin(); entry != row.end();)
                entry = entry->second == 0 ? row.erase(entry) : std::next(entry);
            reduce(row);
            if (!row.empty()) echelon.emplace(row.begin()->first, std::move(row));
        }
        Row given;
        for (std::size_t k = 0; k < basis.size(); ++k) {
            const auto found = v.find(basis[k]);
            if (found == v.end() || found->second == 0) continue;
            Residue square = 1;
            for (std::size_t id = 0; id < families_.size(); ++id)
                if (ring_.generator(static_cast<GeneratorId>(id)).kind == GeneratorKind::fast)
                    for (int n = 2; n <= basis[k].second[id]; ++n) square = f_.multiply(square, f_.from(n));
            given.emplace(k, f_.multiply(square, found->second));
        }
        reduce(given);
        return given.empty();
    }

    const GradedField& field_;
    const Ring& ring_;
    const FrequencySample& sample_;
    const PrimeField& f_;
    const Resonance& resonance_;
    std::vector<Link> links_;
    std::vector<Residue> factors_;      // of links_
    std::vector<std::size_t> families_; // by generator: the first of those linked to it by couplings
};

} // namespace

std::string inner_product_complaint(const NormalForm& normal_form, const NearIdentityMap& map,
                                    const std::vector<FrequencySample>& samples, const Resonance& resonance) {
    const GradedField& field = *normal_form.field;
    for (const FrequencySample& sample : samples) {
        const PointScan scan(field, sample, resonance);
        const auto complaint = [&](const std::string& what, int n, const Vector& rate,
                                   const Vector& shift) -> std::string {
            const std::string weight = to_string(field.system().weight(n));
            if (!scan.adjoint_vanishes(rate))
                return fmt::format("normal form of {}, weight {}: not in the kernel of the adjoint", what,
                                   weight);
            if (!scan.is_orthogonal_to_kernel(shift))
                return fmt::format("map of {}, weight {}: not orthogonal to the kernel", what, weight);
            return "";
        };
        for (int n = 0; n <= normal_form.through; ++n) {
            Vector rates, shifts;
            for (std::size_t k = 0; k < field.modes.size(); ++k) {
                if (n > field.ring->generator(field.modes[k].z).weight)
                    scan.add(rates, static_cast<int>(k), normal_form.mode[k], n);
                scan.add(shifts, static_cast<int>(k), map.mode[k], n);
            }
            std::string found = complaint("the modes", n, rates, shifts);
            const auto look = [&](const auto& variables, const std::vector<Series>& rate,
                                  const std::vector<Series>& shift) {
                for (std::size_t k = 0; k < variables.size() && found.empty(); ++k) {
                    Vector one, other;
                    scan.add(one, -1, rate[k], n);
                    scan.add(other, -1, shift[k], n);
                    found = complaint(variables[k].name, n, one, other);
                }
            };
            look(field.angles, normal_form.angle, map.angle);
            look(field.slow, normal_form.slow, map.slow);
            look(field.drift, normal_form.drift, map.drift);
            if (!found.empty()) return found;
        }
    }
    return "";
}

double inner_product_bits(const NormalForm& normal_form, const NearIdentityMap& map) {
    const GradedField& field = *normal_form.field;
    if (field.is_semisimple()) return 0;
    int degree = 1;
    const auto look = [&](const std::vector<Series>& list) {
        for (const Series& series : list)
            for (int n = 0; n <= series.through(); ++n)
                for (const Monomial& m : series.part(n).fractions().monomials) {
                    int sum = 0;
                    for (GeneratorId id = 0; id < field.ring->size(); ++id)
                        if (field.ring->generator(id).kind == GeneratorKind::fast)
                            sum += field.ring->exponent(m, id);
                    degree = std::max(degree, sum);
                }
    };
    for (const auto* list : {&map.mode, &map.angle, &map.slow, &map.drift, &normal_form.mode}) look(*list);
    double fast = 0, numbers = 0;
    for (const Mode& m : field.modes) fast += m.is_real() ? 1 : 2;
    for (const Link& link : links_of(field))
        numbers = std::max(numbers, static_cast<double>(cln::integer_length(cln::numerator(link.factor)) +
                                                        cln::integer_length(cln::denominator(link.factor))));
    double size = static_cast<double>(field.modes.size()); // of a block: all monomials of the degree
    for (int k = 1; k <= degree; ++k) size *= (fast + k - 1) / k;
    const double entry = std::log2(degree + 1) + numbers + std::log2(2 * fast * fast);
    return size * (entry + std::log2(size) / 2) + degree * std::log2(degree + 1);
}

} // namespace resonform
