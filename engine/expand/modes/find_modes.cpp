// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/find_modes.hpp"

#include "algebra/number/error.hpp"
#include "expand/modes/given_modes.hpp"
#include "expand/modes/jordan_modes.hpp"
#include "expand/modes/large_blocks.hpp"
#include "expand/modes/mode_blocks.hpp"
#include "expand/modes/mode_finder.hpp"
#include "expand/modes/numeric_modes.hpp"
#include "model/exact/question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace resonform {

using GiNaC::ex;

ModalBasis ModeFinder::find() {
    check_equilibrium();
    fill_linear_part();
    if (!system_.modes.empty()) return given_modal_basis(first_order_, basis_.states, linear_, coefficients_);
    find_blocks();
    if (system_.digits > 0) {
        std::vector<bool> closed;
        for (const Block& block : blocks_) closed.push_back(is_closed(block));
        if (std::count(closed.begin(), closed.end(), false) > 0) return numeric(closed);
    }
    for (const Block& block : blocks_) modes_.push_back(modes_of(block));
    if (system_.style == Style::inner_product && !is_semisimple()) {
        basis_.modes = jordan();
        return std::move(basis_);
    }
    for (std::size_t b = 0; b < blocks_.size(); ++b)
        for (const BlockMode& mode : modes_[b].modes) basis_.modes.push_back(extended(mode, b));
    return std::move(basis_);
}

void ModeFinder::check_equilibrium() const {
    for (std::size_t s = 0; s < basis_.states.size(); ++s) {
        const ex force = coefficients_.at_origin(state(s).rate, place(s));
        if (force.is_zero()) continue;
        const Zero zero = vanishes(force, system_);
        if (zero == Zero::yes) continue;
        if (zero == Zero::unknown)
            refuse(Reason::undecided,
                   {"the origin of the fast variables is proved to be an equilibrium at eps = 0",
                    fmt::format("{} = {} there, which may be zero", variable(s).jet.back().get_name(),
                                spell(force)),
                    "write it as 0 if it is zero, or in a simpler form", place(s)});
        bad_input({"the origin of the fast variables is not an equilibrium at eps = 0",
                   fmt::format("{} = {} there", variable(s).jet.back().get_name(), spell(force)),
                   "say under [equilibrium] where the fast variables rest, or write \"solve\" there",
                   place(s)});
    }
}

void ModeFinder::fill_linear_part() {
    const std::size_t n = basis_.states.size();
    linear_.assign(n, std::vector<ex>(n));
    drives_.assign(n, std::vector<bool>(n, false));
    for (std::size_t s = 0; s < n; ++s) {
        for (std::size_t t = 0; t < n; ++t) {
            // A coupling between different weights is no part of A.
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
    if (are_coupled_oscillators(block)) {
        const Matrix k{{-a(block[1], block[0]), -a(block[1], block[2])},
                       {-a(block[3], block[0]), -a(block[3], block[2])}};
        // Otherwise the characteristic polynomial may have factors, or its coefficients tell the signs.
        if (has_plain_frequencies(k, system_))
            return modes_of_coupled_oscillators(k, system_, name_of(block));
    }
    if (block.size() <= largest_simple_block)
        return modes_of_block(matrix_of(block), system_, name_of(block));
    return modes_of_large_block(matrix_of(block), system_, name_of(block));
}

bool ModeFinder::is_closed(const Block& block) const {
    return block.size() <= largest_simple_block || are_coupled_oscillators(block) ||
           has_closed_modes(matrix_of(block), system_, name_of(block));
}

ModalBasis ModeFinder::numeric(const std::vector<bool>& closed) {
    std::vector<NumericModes::BlockOfStates> blocks;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        blocks.push_back({blocks_[b], std::nullopt});
        if (closed[b]) blocks.back().closed = modes_of(blocks_[b]).modes;
    }
    basis_.numeric = std::make_shared<const NumericModes>(linear_, drives_, blocks, coefficients_, place(0));
    const auto symbol = [&](std::size_t mode, bool growth) -> ex {
        basis_.numbers.push_back(
            {{}, fmt::format("{} of mode {}", growth ? "growth" : "omega", mode + 1), mode, growth});
        return basis_.numbers.back().symbol;
    };
    for (const NumericModes::Shape& shape : basis_.numeric->shapes()) {
        const std::size_t k = basis_.modes.size();
        Complex eigenvalue;
        if (shape.eigenvalue)
            eigenvalue = *shape.eigenvalue;
        else if (shape.like < k)
            eigenvalue = basis_.modes[shape.like].eigenvalue;
        else if (shape.mirror)
            eigenvalue = {-basis_.modes[*shape.mirror].eigenvalue.re,
                          basis_.modes[*shape.mirror].eigenvalue.im};
        else
            eigenvalue = {shape.undamped ? ex(0) : symbol(k, true), shape.real ? ex(0) : symbol(k, false)};
        basis_.modes.push_back({eigenvalue, basis_.states[shape.pivot], {}, {}});
    }
    return std::move(basis_);
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

ModalBasis find_modes(const FirstOrderSystem& system, const CoefficientRing& coefficients) {
    return ModeFinder(system, coefficients).find();
}

} // namespace resonform
