// SPDX-License-Identifier: GPL-3.0-or-later
// The steps by which find_modes() goes: linear part -> blocks -> modes of each block -> continued over the
// others.
#pragma once

#include "expand/modes/mode_blocks.hpp"
#include "expand/modes/modes.hpp"
#include "model/text/canonical.hpp"

namespace resonform {

// Larger blocks have closed modes only if their characteristic polynomial factors.
constexpr std::size_t largest_simple_block = 2;

class ModeFinder {
    using Block = std::vector<std::size_t>; // indices into ModalBasis::states, ascending

public:
    ModeFinder(const FirstOrderSystem& first_order, const CoefficientRing& coefficients)
        : first_order_(first_order), system_(*first_order.system), coefficients_(coefficients) {
        for (std::size_t s = 0; s < first_order.states.size(); ++s)
            if (system_.variables[first_order.states[s].variable].role == Role::fast)
                basis_.states.push_back(s);
    }

    ModalBasis find();

private:
    [[nodiscard]] const State& state(std::size_t s) const { return first_order_.states[basis_.states[s]]; }
    [[nodiscard]] const Variable& variable(std::size_t s) const {
        return system_.variables[state(s).variable];
    }
    [[nodiscard]] Place place(std::size_t s) const {
        return place_of(system_.equations[state(s).variable].source);
    }
    [[nodiscard]] const GiNaC::ex& a(std::size_t row, std::size_t column) const {
        return linear_[row][column];
    }

    void check_equilibrium() const;
    void fill_linear_part();
    void find_blocks();
    [[nodiscard]] BlockName name_of(const Block& block) const;
    [[nodiscard]] BlockModes modes_of(const Block& block) const;
    [[nodiscard]] bool is_closed(const Block& block) const;
    [[nodiscard]] ModalBasis numeric(const std::vector<bool>& closed); // by block
    [[nodiscard]] bool is_semisimple() const;                          // false also where it is not proved
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

} // namespace resonform
