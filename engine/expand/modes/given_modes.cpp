// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/given_modes.hpp"

#include "algebra/number/error.hpp"
#include "expand/modes/matrix_inverse.hpp"
#include "expand/ring/power_product.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/zero_test.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

class GivenModes {
public:
    GivenModes(const FirstOrderSystem& first_order, std::vector<std::size_t> states, const Matrix& a,
               const CoefficientRing& coefficients)
        : first_order_(first_order), system_(*first_order.system), a_(a), coefficients_(coefficients) {
        basis_.states = std::move(states);
    }

    ModalBasis prove() {
        for (const GivenMode& mode : system_.modes) {
            basis_.modes.push_back(shape_of(mode));
            check_frequency(mode);
            check_residual(mode, basis_.modes.back());
        }
        add_rows();
        return std::move(basis_);
    }

private:
    [[nodiscard]] ModeShape shape_of(const GivenMode& mode) const {
        ModeShape shape{{mode.eigenvalue.re, mode.eigenvalue.im}, 0, {}, {}};
        shape.column.resize(basis_.states.size());
        for (const GivenMode::Entry& entry : mode.column) {
            const std::size_t state = first_order_.index(entry.variable, static_cast<int>(entry.primes));
            const auto at = std::find(basis_.states.begin(), basis_.states.end(), state);
            shape.column[static_cast<std::size_t>(at - basis_.states.begin())] = {entry.value.re,
                                                                                  entry.value.im};
        }
        const auto pivot = std::find_if(shape.column.begin(), shape.column.end(),
                                        [](const Complex& c) { return !c.is_zero(); });
        if (pivot == shape.column.end())
            bad_input({"the column of the mode is zero", mode.name, "give its entries as u = { x = \"1/2\" }",
                       mode.place});
        shape.pivot = basis_.states[static_cast<std::size_t>(pivot - shape.column.begin())];
        check_weights(mode, shape);
        return shape;
    }

    void check_weights(const GivenMode& mode, const ModeShape& shape) const {
        const auto variable_of = [&](std::size_t state) -> const Variable& {
            return system_.variables[first_order_.states[state].variable];
        };
        const Variable& first = variable_of(shape.pivot);
        for (std::size_t s = 0; s < shape.column.size(); ++s)
            if (const Variable& other = variable_of(basis_.states[s]);
                !shape.column[s].is_zero() && other.weight != first.weight)
                bad_input({"the fast variables in the column of the mode have different weights",
                           fmt::format("{} has weight {}, {} has weight {}", first.name,
                                       to_string(system_.weight(first.weight)), other.name,
                                       to_string(system_.weight(other.weight))),
                           "give modes of each weight by themselves", mode.place});
    }

    void check_frequency(const GivenMode& mode) const {
        const ex& omega = mode.eigenvalue.im;
        if (omega.is_zero() || provably_positive(omega, system_)) return;
        const Place place = place_of(mode.eigenvalue.source);
        if (provably_positive(-omega, system_))
            bad_input({"of a conjugate pair the mode with the positive imaginary part is given",
                       in_quotes(mode.eigenvalue.text), "give the conjugate eigenvalue and column", place});
        refuse(Reason::undecided,
               {"the imaginary part of the eigenvalue of a pair is proved to be positive",
                fmt::format("{} for {}", spell(omega), mode.name), how_to_make_positive(omega), place});
    }

    // A u - lambda u = 0, state by state.
    void check_residual(const GivenMode& mode, const ModeShape& shape) const {
        for (std::size_t s = 0; s < a_.size(); ++s) {
            Complex residual = -(shape.eigenvalue * shape.column[s]);
            for (std::size_t t = 0; t < a_.size(); ++t)
                residual = residual + Complex{a_[s][t], 0} * shape.column[t];
            for (const ex& part : {residual.re, residual.im}) check_zero(part, mode, s);
        }
    }

    void check_zero(const ex& residual, const GivenMode& mode, std::size_t s) const {
        const Zero zero = coefficients_.vanishes(residual, mode.place);
        if (zero == Zero::yes) return;
        const std::string value = fmt::format("{} for {}, in the rate of {}", spell(residual.normal()),
                                              mode.name, first_order_.states[basis_.states[s]].name);
        if (zero == Zero::no)
            bad_input({"a mode is one of the linear part: A u - eigenvalue u is zero", value,
                       "correct the eigenvalue or the column, or give the relation between its symbols in "
                       "[relations]",
                       mode.place});
        refuse(Reason::undecided,
               {"A u - eigenvalue u is proved to be zero", value,
                "give the relation between its symbols in [relations], or write the mode in fewer roots",
                mode.place});
    }

    // u = sum (2 Re c) a - (2 Im c) b for z = a + i b: the inverse of a real matrix.
    void add_rows() {
        const std::size_t n = basis_.states.size();
        Matrix columns(n);
        for (std::size_t s = 0; s < n; ++s)
            for (const ModeShape& shape : basis_.modes) {
                const Complex& c = shape.column[s];
                if (shape.is_real()) {
                    columns[s].push_back(c.re);
                } else {
                    columns[s].push_back(2 * c.re);
                    columns[s].push_back(-2 * c.im);
                }
            }
        const auto rows = inverse(std::move(columns));
        if (!rows)
            bad_input({"the columns of the modes are not proved linearly independent",
                       "no determinant that is proved to differ from zero",
                       "give each mode its own eigenvector", system_.modes.front().place});
        std::size_t k = 0;
        for (ModeShape& shape : basis_.modes) {
            for (std::size_t s = 0; s < n; ++s)
                shape.row.push_back({(*rows)[k][s], shape.is_real() ? ex(0) : (*rows)[k + 1][s]});
            k += shape.is_real() ? 1 : 2;
        }
    }

    const FirstOrderSystem& first_order_;
    const System& system_;
    const Matrix& a_;
    const CoefficientRing& coefficients_;
    ModalBasis basis_;
};

} // namespace

ModalBasis given_modal_basis(const FirstOrderSystem& system, std::vector<std::size_t> states, const Matrix& a,
                             const CoefficientRing& coefficients) {
    return GivenModes(system, std::move(states), a, coefficients).prove();
}

} // namespace resonform
