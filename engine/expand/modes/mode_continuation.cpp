// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvectors of a block, continued to the blocks that it drives or that drive it.
#include "algebra/number/error.hpp"
#include "expand/modes/block_order.hpp"
#include "expand/modes/matrix_inverse.hpp"
#include "expand/modes/mode_finder.hpp"
#include "expand/ring/complex_expression.hpp"
#include "model/text/zero_test.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

using GiNaC::ex;

ModeShape ModeFinder::lone(const BlockMode& mode, std::size_t block) const {
    ModeShape shape{mode.eigenvalue, basis_.states[blocks_[block][mode.pivot]], {}, {}};
    shape.column.resize(basis_.states.size());
    shape.row.resize(basis_.states.size());
    for (std::size_t k = 0; k < blocks_[block].size(); ++k) {
        shape.column[blocks_[block][k]] = mode.column[k];
        shape.row[blocks_[block][k]] = mode.row[k];
    }
    return shape;
}

ModeShape ModeFinder::extended(const BlockMode& mode, std::size_t block) const {
    ModeShape shape = lone(mode, block);
    extend(shape.column, mode.eigenvalue, block, false);
    extend(shape.row, mode.eigenvalue, block, true);
    return shape;
}

// (A_CC - lambda) v_C = -sum A_Ct v_t over the states t between; for rows with A transposed.
void ModeFinder::extend(std::vector<Complex>& vector, const Complex& eigenvalue, std::size_t block,
                        bool rows) const {
    for (const std::size_t b : blocks_reached(block, blocks_, drives_, rows)) {
        std::vector<Complex> right(blocks_[b].size());
        for (std::size_t k = 0; k < right.size(); ++k)
            for (std::size_t t = 0; t < vector.size(); ++t) {
                const ex& coupling = rows ? a(t, blocks_[b][k]) : a(blocks_[b][k], t);
                if (!coupling.is_zero() && !vector[t].is_zero())
                    right[k] = right[k] - Complex{coupling, 0} * vector[t];
            }
        const std::vector<Complex> solution = solve(blocks_[b], eigenvalue, right, rows);
        for (std::size_t k = 0; k < solution.size(); ++k) vector[blocks_[b][k]] = normal(solution[k]);
    }
}

std::vector<Complex> ModeFinder::solve(const Block& block, const Complex& eigenvalue,
                                       const std::vector<Complex>& right, bool rows) const {
    if (std::all_of(right.begin(), right.end(), [](const Complex& c) { return normal(c).is_zero(); }))
        return right;
    const std::size_t n = block.size();
    std::vector<std::vector<Complex>> m(n, std::vector<Complex>(n));
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < n; ++k)
            m[j][k] = {rows ? a(block[k], block[j]) : a(block[j], block[k]), 0};
        m[j][j] = m[j][j] - eigenvalue;
    }
    if (n > largest_simple_block) {
        const auto solution = solve_linear(std::move(m), right);
        if (!solution) refuse_driven(block);
        return *solution;
    }
    const Complex determinant = normal(n == 1 ? m[0][0] : m[0][0] * m[1][1] - m[0][1] * m[1][0]);
    if (vanishes(determinant.re) != Zero::no && vanishes(determinant.im) != Zero::no) refuse_driven(block);
    if (n == 1) return {right[0] / determinant};
    return {(right[0] * m[1][1] - m[0][1] * right[1]) / determinant,
            (m[0][0] * right[1] - m[1][0] * right[0]) / determinant};
}

void ModeFinder::refuse_driven(const Block& block) const {
    refuse(Reason::undecided,
           {"the linear part of the fast variables is semisimple: nothing is driven at its own eigenvalue",
            fmt::format("{} is, or that cannot be excluded", state(block.front()).name),
            "write style = \"inner_product\" in [normal_form], give the variable a restoring force, or "
            "write the coupling with a factor eps",
            place(block.front())});
}

} // namespace resonform
