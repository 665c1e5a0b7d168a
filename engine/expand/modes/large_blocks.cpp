// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/large_blocks.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/real_ball.hpp"
#include "expand/modes/closed_roots.hpp"
#include "expand/modes/eigen_field.hpp"
#include "expand/modes/number_fit.hpp"
#include "model/text/canonical.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/zero_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;
using Rows = EigenField::Rows;

struct Factor { // irreducible in lambda, monic
    std::vector<ex> lower;
    std::size_t multiplicity;
};

class LargeBlock {
public:
    LargeBlock(const Matrix& a, const System& system, const BlockName& name)
        : a_(a), system_(system), name_(name) {
        name_symbols();
    }

    [[nodiscard]] bool is_closed() const {
        const std::vector<Factor> found = factors();
        return std::all_of(found.begin(), found.end(), has_closed_roots);
    }

    BlockModes modes() {
        for (const Factor& factor : factors()) {
            if (!has_closed_roots(factor)) refuse_factor(factor);
            add_modes(factor);
        }
        sort();
        return {std::move(modes_), chained_};
    }

private:
    void name_symbols() {
        std::size_t count = 0;
        const auto add = [&](const ex& symbol) {
            indexed_[symbol] = GiNaC::symbol(fmt::format("p{:03}", count));
            near_one_[symbol] = 1 + numeric(static_cast<long>(++count), 64);
        };
        for (const Parameter& p : system_.parameters) add(p.symbol);
        for (const Variable& v : system_.variables) add(v.jet.front());
    }

    [[nodiscard]] std::vector<Factor> factors() const;
    [[nodiscard]] ex polynomial(const Factor& factor, const ex& variable) const;
    static bool has_closed_roots(const Factor& factor);
    [[noreturn]] void refuse_factor(const Factor& factor) const;
    [[noreturn]] void refuse_unknown() const;
    [[noreturn]] void refuse_nilpotent(const Factor& factor) const;

    void add_modes(const Factor& factor);
    [[nodiscard]] Rows chain(const Factor& factor, const EigenField& field) const;
    [[nodiscard]] Rows power_of_shifted(const EigenField& field, bool transposed, std::size_t times) const;
    [[nodiscard]] static EigenField::Row product(const EigenField& field, const Rows& m,
                                                 const EigenField::Row& v);
    [[nodiscard]] Rows shifted(const EigenField& field, bool transposed) const;
    [[nodiscard]] BlockMode mode_of(const EigenRoot& root, const EigenField::Row& column,
                                    const EigenField::Row& row) const;
    void sort();

    const Matrix& a_;
    const System& system_;
    const BlockName& name_;
    GiNaC::exmap indexed_, near_one_; // the symbols by their places in the file
    GiNaC::symbol lambda_{"lambda"};
    std::vector<BlockMode> modes_;
    bool chained_ = false;
};

std::vector<Factor> LargeBlock::factors() const {
    const auto n = static_cast<unsigned>(a_.size());
    GiNaC::matrix matrix(n, n);
    for (unsigned i = 0; i < n; ++i)
        for (unsigned j = 0; j < n; ++j) matrix(i, j) = a_[i][j];
    GiNaC::exmap atoms;
    const ex characteristic = matrix.charpoly(lambda_).normal().numer().to_polynomial(atoms).expand();
    const ex factored = GiNaC::factor(characteristic);
    std::vector<Factor> found;
    for (const ex& f : factors_of(factored)) {
        const bool power = GiNaC::is_a<GiNaC::power>(f);
        const ex base = (power ? f.op(0) : f).subs(atoms, GiNaC::subs_options::no_pattern).expand();
        if (!base.has(lambda_)) continue;
        const int degree = base.degree(lambda_);
        Factor factor{{}, 1};
        if (power) factor.multiplicity = static_cast<std::size_t>(GiNaC::ex_to<numeric>(f.op(1)).to_int());
        for (int k = 0; k < degree; ++k)
            factor.lower.push_back((base.coeff(lambda_, k) / base.lcoeff(lambda_)).normal());
        found.push_back(std::move(factor));
    }
    const auto key = [&](const Factor& f) {
        const ex named = polynomial(f, lambda_).subs(indexed_, GiNaC::subs_options::no_pattern);
        return std::make_tuple(f.lower.size(), spell(named));
    };
    std::sort(found.begin(), found.end(), [&](const Factor& p, const Factor& q) { return key(p) < key(q); });
    return found;
}

ex LargeBlock::polynomial(const Factor& factor, const ex& variable) const {
    ex sum = GiNaC::pow(variable, factor.lower.size());
    for (std::size_t k = 0; k < factor.lower.size(); ++k) sum += factor.lower[k] * GiNaC::pow(variable, k);
    return sum;
}

bool LargeBlock::has_closed_roots(const Factor& factor) {
    const std::size_t degree = factor.lower.size();
    return degree <= 2 || (degree == 4 && factor.lower[1].is_zero() && factor.lower[3].is_zero());
}

void LargeBlock::refuse_factor(const Factor& factor) const {
    refuse(
        Reason::eigenvalues,
        {"eigenvalues in closed form are roots of factors of degree 1 or 2 in lambda or in lambda^2",
         fmt::format("{} of the characteristic polynomial of {}", spell(polynomial(factor, lambda_)),
                     name_.variables),
         std::string(hindrance_to_numbers(system_)
                         ? ""
                         : "with a value for every parameter take numbers: --digits 30; or ") +
             "give the modes in [modes] with their frequencies as parameters, or write the coupling with a "
             "factor eps",
         name_.place});
}

void LargeBlock::refuse_unknown() const {
    refuse(Reason::undecided,
           {"entries of eigenvectors are proved to be zero or nonzero",
            fmt::format("not all of those of {}", name_.variables),
            "write the coefficients with fewer roots, or give the modes in [modes]", name_.place});
}

void LargeBlock::refuse_nilpotent(const Factor& factor) const {
    refuse(Reason::not_semisimple,
           {"the linear part of the fast variables is semisimple (has as many eigenvectors as variables)",
            fmt::format(
                "{} is a {}-fold factor of the characteristic polynomial of {}, and has fewer eigenvectors",
                spell(polynomial(factor, lambda_)), factor.multiplicity, name_.variables),
            system_.style == Style::inner_product
                ? "give parameters other values, so that a chain less is left, or unfold the block"
                : "write style = \"inner_product\" in [normal_form], give the variable a restoring force, or "
                  "unfold the block",
            name_.place});
}

// A - lambda.
Rows LargeBlock::shifted(const EigenField& field, bool transposed) const {
    Rows rows;
    for (std::size_t i = 0; i < a_.size(); ++i) {
        rows.emplace_back();
        for (std::size_t j = 0; j < a_.size(); ++j) {
            const auto entry = field.constant(transposed ? a_[j][i] : a_[i][j]);
            rows.back().push_back(i == j ? field.minus(entry, field.root()) : entry);
        }
    }
    return rows;
}

EigenField::Row LargeBlock::product(const EigenField& field, const Rows& m, const EigenField::Row& v) {
    EigenField::Row result;
    for (const EigenField::Row& row : m) {
        EigenField::Element sum = field.constant(0);
        for (std::size_t k = 0; k < v.size(); ++k)
            sum = field.minus(sum, field.times(field.minus(field.constant(0), row[k]), v[k]));
        result.push_back(std::move(sum));
    }
    return result;
}

// (A - lambda)^n
Rows LargeBlock::power_of_shifted(const EigenField& field, bool transposed, std::size_t n) const {
    const Rows once = shifted(field, !transposed); // its rows are the columns of the factor
    Rows rows = shifted(field, transposed);
    for (std::size_t k = 1; k < n; ++k)
        for (EigenField::Row& row : rows) row = product(field, once, row);
    return rows;
}

// Generalised eigenvectors v_1, ..., v_m with (A - lambda) v_{k+1} = v_k, where one eigenvector is all there
// is.
Rows LargeBlock::chain(const Factor& factor, const EigenField& field) const {
    const std::size_t m = factor.multiplicity;
    const auto all = field.null_space(power_of_shifted(field, false, m), a_.size());
    if (!all) refuse_unknown();
    const Rows once = shifted(field, false);
    for (const EigenField::Row& top : *all) {
        Rows vectors{top};
        while (vectors.size() < m) vectors.insert(vectors.begin(), product(field, once, vectors.front()));
        const auto lead = std::find_if(vectors.front().begin(), vectors.front().end(), [](const auto& entry) {
            return EigenField::vanishes(entry) != Zero::yes;
        });
        if (lead == vectors.front().end()) continue; // of a shorter chain
        const auto factor_of_all = field.inverse(*lead);
        if (!factor_of_all) refuse_unknown();
        for (EigenField::Row& v : vectors)
            for (EigenField::Element& entry : v) entry = field.times(entry, *factor_of_all);
        return vectors;
    }
    refuse_unknown();
}

// Columns from the null space, rows from that of the transpose, paired to one another.
void LargeBlock::add_modes(const Factor& factor) {
    const EigenField field(factor.lower);
    auto columns = field.null_space(shifted(field, false), a_.size());
    if (!columns) refuse_unknown();
    const std::size_t m = factor.multiplicity;
    const bool chained = columns->size() < m;
    if (chained && (columns->size() > 1 || system_.style != Style::inner_product)) refuse_nilpotent(factor);
    if (chained) columns = chain(factor, field);
    chained_ = chained_ || chained;
    const auto rows = field.null_space(power_of_shifted(field, true, chained ? m : 1), a_.size());
    if (!rows) refuse_unknown();
    if (rows->size() != m) refuse_nilpotent(factor);
    Rows paired; // P | rows with P = rows columns: the echelon form is 1 | P^-1 rows
    for (const EigenField::Row& row : *rows) {
        paired.push_back(product(field, *columns, row));
        paired.back().insert(paired.back().end(), row.begin(), row.end());
    }
    const auto inverted = field.echelon(std::move(paired));
    if (!inverted) refuse_unknown();
    for (const EigenRoot& root : closed_roots(factor.lower, system_, name_))
        for (std::size_t k = 0; k < m; ++k) {
            if (EigenField::vanishes((*inverted)[k][k]) != Zero::no) refuse_nilpotent(factor);
            const EigenField::Row row((*inverted)[k].begin() + static_cast<std::ptrdiff_t>(m),
                                      (*inverted)[k].end());
            modes_.push_back(mode_of(root, (*columns)[k], row));
        }
}

BlockMode LargeBlock::mode_of(const EigenRoot& root, const EigenField::Row& column,
                              const EigenField::Row& row) const {
    const ex scale = root.value.im.is_zero() ? ex(1) : ex(1) / 2;
    const auto at_root = [&](const EigenField::Element& e, const ex& factor) {
        Complex sum;
        for (std::size_t k = 0; k < e.size(); ++k)
            if (!e[k].is_zero()) sum = sum + Complex{factor * e[k], 0} * root.powers[k];
        return sum;
    };
    BlockMode mode{root.value, {}, {}};
    for (std::size_t s = 0; s < a_.size(); ++s) {
        if (mode.pivot == s && EigenField::vanishes(column[s]) == Zero::yes) ++mode.pivot;
        mode.column.push_back(at_root(column[s], scale));
        mode.row.push_back(at_root(row[s], 1 / scale));
    }
    return mode;
}

// By frequency and growth at parameters near one, if all have values there.
void LargeBlock::sort() {
    for (const BlockMode& m : modes_) {
        add_named(m.eigenvalue.re, near_one_);
        add_named(m.eigenvalue.im, near_one_);
    }
    const auto value = [&](const ex& e) {
        constexpr std::int64_t bits = 64;
        const auto ball = enclose(e, near_one_, bits);
        return ball ? nearest_double(*ball) : std::numeric_limits<double>::quiet_NaN();
    };
    if (std::any_of(modes_.begin(), modes_.end(), [&](const BlockMode& m) {
            return !std::isfinite(value(m.eigenvalue.re)) || !std::isfinite(value(m.eigenvalue.im));
        }))
        return;
    const auto before = [&](const BlockMode& p, const BlockMode& q) {
        const double omega = value(p.eigenvalue.im) - value(q.eigenvalue.im);
        const double growth = value(p.eigenvalue.re) - value(q.eigenvalue.re);
        constexpr double equal = 1e-9;
        return std::abs(omega) > equal ? omega < 0 : growth < -equal;
    };
    std::stable_sort(modes_.begin(), modes_.end(), before);
}

} // namespace

BlockModes modes_of_large_block(const Matrix& a, const System& system, const BlockName& name) {
    return LargeBlock(a, system, name).modes();
}

bool has_closed_modes(const Matrix& a, const System& system, const BlockName& name) {
    return LargeBlock(a, system, name).is_closed();
}

} // namespace resonform
