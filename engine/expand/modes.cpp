// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes.hpp"

#include "expand/given_modes.hpp"
#include "expand/jordan_modes.hpp"
#include "expand/large_blocks.hpp"
#include "expand/matrix_inverse.hpp"
#include "model/canonical.hpp"
#include "model/zero_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace resonform {

namespace {

using GiNaC::ex;

constexpr std::size_t largest_block = 2;
using Block = std::vector<std::size_t>; // indices into ModalBasis::states, ascending

class ModeFinder {
public:
    ModeFinder(const FirstOrderSystem& first_order, const CoefficientRing& coefficients)
        : first_order_(first_order), system_(*first_order.system), coefficients_(coefficients) {
        for (std::size_t s = 0; s < first_order.states.size(); ++s)
            if (system_.variables[first_order.states[s].variable].role == Role::fast)
                basis_.states.push_back(s);
    }

    ModalBasis find() {
        check_equilibrium();
        fill_linear_part();
        if (!system_.modes.empty())
            return given_modal_basis(first_order_, basis_.states, linear_, coefficients_);
        find_blocks();
        for (const Block& block : blocks_) modes_.push_back(modes_of(block));
        if (system_.style == Style::inner_product && !is_semisimple()) {
            basis_.modes = jordan();
            return std::move(basis_);
        }
        for (std::size_t b = 0; b < blocks_.size(); ++b)
            for (const BlockMode& mode : modes_[b].modes) basis_.modes.push_back(extended(mode, b));
        return std::move(basis_);
    }

private:
    [[nodiscard]] const State& state(std::size_t s) const { return first_order_.states[basis_.states[s]]; }
    [[nodiscard]] const Variable& variable(std::size_t s) const {
        return system_.variables[state(s).variable];
    }
    [[nodiscard]] Place place(std::size_t s) const {
        return place_of(system_.equations[state(s).variable].source);
    }
    [[nodiscard]] const ex& a(std::size_t row, std::size_t column) const { return linear_[row][column]; }

    void check_equilibrium() const;
    void fill_linear_part();
    void find_blocks();
    [[nodiscard]] BlockName name_of(const Block& block) const;
    [[nodiscard]] BlockModes modes_of(const Block& block) const;
    [[nodiscard]] bool is_semisimple() const; // false also where it is not proved
    [[nodiscard]] std::vector<ModeShape> jordan() const;
    [[nodiscard]] std::vector<std::size_t> from_driving_block() const; // each before those that it drives
    // The mode of a block by itself.
    [[nodiscard]] ModeShape lone(const BlockMode& mode, std::size_t block) const;
    [[nodiscard]] bool are_coupled_oscillators(const Block& block) const;
    [[noreturn]] void refuse_driven(const Block& block) const;
    [[nodiscard]] Matrix matrix_of(const Block& block) const;

    // Continues an eigenvector of a block to the blocks that it drives (column), or that drive it (row).
    [[nodiscard]] ModeShape extended(const BlockMode& mode, std::size_t block) const;
    void extend(std::vector<Complex>& vector, const Complex& eigenvalue, std::size_t block, bool rows) const;
    [[nodiscard]] std::vector<Complex> solve(const Block& block, const Complex& eigenvalue,
                                             const std::vector<Complex>& right, bool rows) const;

    const FirstOrderSystem& first_order_;
    const System& system_;
    const CoefficientRing& coefficients_;
    ModalBasis basis_;
    Matrix linear_;
    std::vector<std::vector<bool>> drives_; // [t][s]: t occurs in the rates that lead to s, or t = s
    std::vector<Block> blocks_;             // in the order of their first states
    std::vector<BlockModes> modes_;         // of each block
};

void ModeFinder::check_equilibrium() const {
    for (std::size_t s = 0; s < basis_.states.size(); ++s) {
        const ex force = coefficients_.at_origin(state(s).rate, place(s));
        if (force.is_zero()) continue;
        const std::string& name = variable(s).name;
        bad_input({"the origin of the fast variables is an equilibrium at eps = 0",
                   fmt::format("{} = {} there", variable(s).jet.back().get_name(), spell(force)),
                   fmt::format("shift {} to the equilibrium by a change of variable", name), place(s)});
    }
}

void ModeFinder::fill_linear_part() {
    const std::size_t n = basis_.states.size();
    linear_.assign(n, std::vector<ex>(n));
    drives_.assign(n, std::vector<bool>(n, false));
    for (std::size_t s = 0; s < n; ++s) {
        for (std::size_t t = 0; t < n; ++t) {
            // Of another weight it is a coupling of another weight: no part of A.
            if (variable(s).weight == variable(t).weight)
                linear_[s][t] = coefficients_.at_origin(state(s).rate.diff(state(t).symbol), place(s));
            drives_[t][s] = s == t || !linear_[s][t].is_zero();
        }
    }
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t t = 0; t < n; ++t)
            for (std::size_t s = 0; s < n; ++s)
                if (drives_[t][k] && drives_[k][s]) drives_[t][s] = true;
}

void ModeFinder::find_blocks() {
    std::vector<bool> found(basis_.states.size(), false);
    for (std::size_t s = 0; s < found.size(); ++s) {
        if (found[s]) continue;
        Block block;
        for (std::size_t t = s; t < found.size(); ++t) {
            if (!drives_[s][t] || !drives_[t][s]) continue;
            block.push_back(t);
            found[t] = true;
        }
        blocks_.push_back(std::move(block));
    }
}

BlockName ModeFinder::name_of(const Block& block) const {
    BlockName name{"", block.size() == 2 && state(block[0]).variable == state(block[1]).variable,
                   place(block[0])};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const std::string& variable_name = variable(block[k]).name;
        if (k > 0 && variable(block[k - 1]).name == variable_name) continue;
        name.variables += (k == 0 ? "" : ", ") + variable_name;
    }
    return name;
}

Matrix ModeFinder::matrix_of(const Block& block) const {
    Matrix matrix;
    for (std::size_t s : block) {
        matrix.emplace_back();
        for (std::size_t t : block) matrix.back().push_back(a(s, t));
    }
    return matrix;
}

bool ModeFinder::are_coupled_oscillators(const Block& block) const {
    if (block.size() != 4) return false;
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}})
        if (variable(block[k]).order != 2 || state(block[k]).variable != state(block[k + 1]).variable)
            return false;
    return a(block[1], block[1]).is_zero() && a(block[1], block[3]).is_zero() &&
           a(block[3], block[1]).is_zero() && a(block[3], block[3]).is_zero();
}

BlockModes ModeFinder::modes_of(const Block& block) const {
    if (are_coupled_oscillators(block))
        return modes_of_coupled_oscillators({{-a(block[1], block[0]), -a(block[1], block[2])},
                                             {-a(block[3], block[0]), -a(block[3], block[2])}},
                                            system_, name_of(block));
    if (block.size() <= largest_block) return modes_of_block(matrix_of(block), system_, name_of(block));
    return modes_of_large_block(matrix_of(block), system_, name_of(block));
}

// No mode drives one of the same eigenvalue, or of one that is not proved to be another.
bool ModeFinder::is_semisimple() const {
    const auto may_coincide = [](const BlockMode& a, const BlockMode& b) {
        return vanishes(a.eigenvalue - b.eigenvalue) != Zero::no ||
               vanishes(a.eigenvalue - conjugate(b.eigenvalue)) != Zero::no;
    };
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        if (modes_[b].chained) return false;
        for (std::size_t c = 0; c < blocks_.size(); ++c) {
            if (b == c || !drives_[blocks_[b].front()][blocks_[c].front()]) continue;
            for (const BlockMode& from : modes_[b].modes)
                for (const BlockMode& to : modes_[c].modes)
                    if (may_coincide(from, to)) return false;
        }
    }
    return true;
}

std::vector<ModeShape> ModeFinder::jordan() const {
    std::vector<LoneMode> modes;
    std::vector<std::vector<std::size_t>> of_block(blocks_.size());
    std::vector<bool> chained;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const std::size_t pivot = blocks_[b].front();
        chained.push_back(modes_[b].chained);
        for (const BlockMode& mode : modes_[b].modes) {
            of_block[b].insert(of_block[b].begin(), modes.size()); // in a chain later ones drive
            modes.push_back({lone(mode, b), b, state(pivot).name, place(pivot)});
        }
    }
    std::vector<std::size_t> from_driver;
    for (std::size_t b : from_driving_block())
        from_driver.insert(from_driver.end(), of_block[b].begin(), of_block[b].end());
    return jordan_modes(linear_, modes, from_driver, chained);
}

std::vector<std::size_t> ModeFinder::from_driving_block() const {
    std::vector<std::size_t> order(blocks_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto drivers = [&](std::size_t b) {
        return std::count_if(blocks_.begin(), blocks_.end(),
                             [&](const Block& c) { return drives_[c.front()][blocks_[b].front()]; });
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t p, std::size_t q) { return drivers(p) < drivers(q); });
    return order;
}

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

// (A_CC - lambda) v_C = -sum A_Ct v_t over the states t between; for rows with A transposed. A block comes
// when all that lead to it have come.
void ModeFinder::extend(std::vector<Complex>& vector, const Complex& eigenvalue, std::size_t block,
                        bool rows) const {
    const auto leads = [&](std::size_t from, std::size_t to) {
        const std::size_t t = blocks_[from].front(), s = blocks_[to].front();
        return from != to && (rows ? drives_[s][t] : drives_[t][s]);
    };
    std::vector<std::size_t> next;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
        if (leads(block, b)) next.push_back(b);
    std::stable_sort(next.begin(), next.end(), [&](std::size_t p, std::size_t q) {
        const auto before = [&](std::size_t b) {
            return std::count_if(next.begin(), next.end(), [&](std::size_t c) { return leads(c, b); });
        };
        return before(p) < before(q);
    });
    for (std::size_t b : next) {
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
    if (n > largest_block) {
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
    refuse({"the linear part of the fast variables is semisimple: nothing is driven at its own eigenvalue",
            fmt::format("{} is, or that cannot be excluded", state(block.front()).name),
            "write style = \"inner_product\" in [normal_form], give the variable a restoring force, or "
            "write the coupling with a factor eps",
            place(block.front())});
}

} // namespace

bool ModalBasis::is_oscillator(std::size_t mode, const FirstOrderSystem& system) const {
    const ModeShape& shape = modes[mode];
    const State& pivot = system.states[shape.pivot];
    if (shape.is_real() || !shape.eigenvalue.re.is_zero() ||
        system.system->variables[pivot.variable].order != 2)
        return false;
    for (std::size_t s = 0; s < states.size(); ++s) {
        Complex rest = shape.row[s];
        if (states[s] == shape.pivot) {
            rest.re -= 1;
        } else if (system.states[states[s]].variable == pivot.variable) {
            rest.im = rest.im * shape.eigenvalue.im + 1;
        } else if (!shape.column[s].is_zero()) {
            return false;
        }
        if (!rest.is_zero()) return false;
    }
    return true;
}

ModalBasis find_modes(const FirstOrderSystem& system, const CoefficientRing& coefficients) {
    return ModeFinder(system, coefficients).find();
}

} // namespace resonform
