// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/jordan_modes.hpp"

#include "algebra/number/error.hpp"
#include "expand/ring/complex_expression.hpp"
#include "expand/ring/power_product.hpp"
#include "model/text/canonical.hpp"
#include "model/text/zero_test.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

// A mode or its conjugate.
struct Coordinate {
    std::size_t mode;
    bool conjugate;
};

// With K the couplings between the modes of the blocks, an I + X brings lambda + K to lambda + n:
//   (lambda_k - lambda_j) X_jk + n_jk = K_jk + sum_m (K_jm X_mk - X_jm n_mk)
// where drivers come first, so that all matrices are strictly triangular.
class JordanModes {
public:
    JordanModes(const Matrix& a, const std::vector<LoneMode>& modes,
                const std::vector<std::size_t>& from_driver, const std::vector<bool>& chained)
        : a_(a), modes_(modes), chained_(chained) {
        for (const std::size_t m : from_driver) {
            coordinates_.push_back({m, false});
            if (!modes[m].shape.is_real()) coordinates_.push_back({m, true});
        }
        shift_.assign(size(), std::vector<Complex>(size()));
        coupling_ = shift_;
    }

    std::vector<ModeShape> find() {
        for (std::size_t k = size(); k-- > 0;)
            for (std::size_t j = k + 1; j < size(); ++j) settle(j, k);
        combine();
        scale();
        return std::move(shapes_);
    }

private:
    [[nodiscard]] std::size_t size() const { return coordinates_.size(); }
    [[nodiscard]] const LoneMode& mode(std::size_t c) const { return modes_[coordinates_[c].mode]; }
    [[nodiscard]] Complex of(std::size_t c, const Complex& value) const {
        return coordinates_[c].conjugate ? conjugate(value) : value;
    }

    // Refuses if it cannot be decided whether the value is zero.
    [[nodiscard]] bool is_zero(const Complex& value, const std::string& what, std::size_t c) const {
        const Zero zero = vanishes(value);
        if (zero == Zero::unknown)
            refuse(Reason::undecided,
                   {fmt::format("{} is proved to be zero or not to be", what), spell(value.re + value.im),
                    "write it in a plainer form, or give parameters numeric values", mode(c).place});
        return zero == Zero::yes;
    }

    [[nodiscard]] Complex given_coupling(std::size_t j, std::size_t k) const {
        const LoneMode &to = mode(j), &from = mode(k);
        if (to.block == from.block && (!chained_[to.block] || coordinates_[j].mode == coordinates_[k].mode))
            return {};
        Complex sum;
        for (std::size_t s = 0; s < a_.size(); ++s)
            for (std::size_t t = 0; t < a_.size(); ++t) {
                if (a_[s][t].is_zero() || to.shape.row[s].is_zero() || from.shape.column[t].is_zero())
                    continue;
                sum = sum + of(j, to.shape.row[s]) * Complex{a_[s][t], 0} * of(k, from.shape.column[t]);
            }
        return normal(sum);
    }

    void settle(std::size_t j, std::size_t k) {
        Complex right = given_coupling(j, k);
        for (std::size_t m = k + 1; m < j; ++m) {
            if (!shift_[m][k].is_zero()) right = right + given_coupling(j, m) * shift_[m][k];
            if (!coupling_[m][k].is_zero()) right = right - shift_[j][m] * coupling_[m][k];
        }
        right = normal(right);
        if (right.is_zero() || is_zero(right, "a coupling of modes", j)) return;
        const Complex gap = normal(of(k, mode(k).shape.eigenvalue) - of(j, mode(j).shape.eigenvalue));
        if (is_zero(gap, "a difference of two eigenvalues", j))
            coupling_[j][k] = right;
        else
            shift_[j][k] = normal(right / gap);
    }

    // columns: C (I + X), rows: (I + X)^-1 R.
    void combine() {
        shapes_.resize(modes_.size());
        std::vector<std::vector<Complex>> rows;
        for (std::size_t c = 0; c < size(); ++c) {
            ModeShape shape = mode(c).shape;
            for (std::size_t s = 0; s < a_.size(); ++s) {
                shape.row[s] = of(c, shape.row[s]);
                for (std::size_t k = 0; k < c; ++k)
                    if (!shift_[c][k].is_zero()) shape.row[s] = shape.row[s] - shift_[c][k] * rows[k][s];
                for (std::size_t j = c + 1; j < size(); ++j)
                    if (!shift_[j][c].is_zero())
                        shape.column[s] = shape.column[s] + of(j, mode(j).shape.column[s]) * shift_[j][c];
                shape.row[s] = normal(shape.row[s]);
                shape.column[s] = normal(shape.column[s]);
            }
            rows.push_back(shape.row);
            if (!coordinates_[c].conjugate) shapes_[coordinates_[c].mode] = std::move(shape);
        }
    }

    // z_j = factor_j times the mode as it is now: n_jk factor_k / factor_j is 1 along a tree.
    void scale() {
        std::vector<Complex> factor(modes_.size());
        std::vector<bool> reached(modes_.size(), false);
        const auto reach = [&](std::size_t m, const Complex& value, const Complex& eigenvalue) {
            factor[m] = normal(value);
            reached[m] = true;
            shapes_[m].eigenvalue = eigenvalue; // modes that are coupled have it in one form
        };
        for (std::size_t first = 0; first < modes_.size(); ++first) {
            if (reached[first]) continue;
            const Complex eigenvalue = shapes_[first].eigenvalue;
            reach(first, {1, 0}, eigenvalue);
            for (bool found = true; found;) {
                found = false;
                each_coupling([&](std::size_t to, std::size_t from, const Complex& n) {
                    if (reached[to] == reached[from]) return;
                    if (reached[to])
                        reach(from, factor[to] / n, eigenvalue);
                    else
                        reach(to, factor[from] * n, eigenvalue);
                    found = true;
                });
            }
        }
        for (std::size_t m = 0; m < modes_.size(); ++m) {
            if (normal(factor[m] - Complex{1, 0}).is_zero()) continue;
            for (Complex& c : shapes_[m].column) c = normal(c * factor[m]);
            for (Complex& r : shapes_[m].row) r = normal(r / factor[m]);
        }
        each_coupling([&](std::size_t to, std::size_t from, const Complex& n) {
            shapes_[to].couplings.push_back({from, number(n * factor[from] / factor[to], to)});
        });
        for (ModeShape& shape : shapes_)
            std::sort(shape.couplings.begin(), shape.couplings.end(),
                      [](const ModeCoupling& p, const ModeCoupling& q) { return p.mode < q.mode; });
    }

    template <class Visit> void each_coupling(const Visit& visit) const {
        for (std::size_t j = 0; j < size(); ++j)
            for (std::size_t k = 0; k < j; ++k)
                if (!coordinates_[j].conjugate && !coupling_[j][k].is_zero())
                    visit(coordinates_[j].mode, coordinates_[k].mode, coupling_[j][k]);
    }

    [[nodiscard]] Rational number(const Complex& coupling, std::size_t m) const {
        const Complex n = normal(coupling);
        if (!n.im.is_zero() || !n.re.info(GiNaC::info_flags::rational))
            refuse(Reason::not_semisimple,
                   {"couplings of modes that have one eigenvalue can be scaled to numbers",
                    fmt::format("that of {} is {}", modes_[m].name, spell(n.re + n.im)),
                    "take a combination of variables in which a coupling less is left, or give parameters "
                    "numeric values with --set NAME=VALUE",
                    modes_[m].place});
        return to_rational(n.re);
    }

    const Matrix& a_;
    const std::vector<LoneMode>& modes_;
    const std::vector<bool>& chained_;
    std::vector<Coordinate> coordinates_;                // drivers first
    std::vector<std::vector<Complex>> shift_, coupling_; // X and n
    std::vector<ModeShape> shapes_;
};

} // namespace

Zero vanishes(const Complex& a) {
    const Zero re = vanishes(a.re), im = vanishes(a.im);
    if (re == Zero::no || im == Zero::no) return Zero::no;
    return re == Zero::yes && im == Zero::yes ? Zero::yes : Zero::unknown;
}

std::vector<ModeShape> jordan_modes(const Matrix& a, const std::vector<LoneMode>& modes,
                                    const std::vector<std::size_t>& from_driver,
                                    const std::vector<bool>& chained) {
    return JordanModes(a, modes, from_driver, chained).find();
}

} // namespace resonform
