// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/numeric_modes.hpp"

#include "algebra/number/error.hpp"
#include "expand/modes/block_order.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

constexpr std::int64_t first_bits = 256, most_bits = 16384;

void collect(CoefficientRing& ring, const Complex& c, const Place& place) {
    ring.collect(c.re, place);
    ring.collect(c.im, place);
}

RingPtr ring_of(const Matrix& a, const std::vector<NumericModes::BlockOfStates>& blocks,
                CoefficientRing& coefficients, const Place& place) {
    for (const auto& row : a)
        for (const GiNaC::ex& entry : row) coefficients.collect(entry, place);
    for (const auto& block : blocks) {
        if (!block.closed) continue;
        for (const BlockMode& mode : *block.closed) {
            collect(coefficients, mode.eigenvalue, place);
            for (const Complex& c : mode.column) collect(coefficients, c, place);
            for (const Complex& c : mode.row) collect(coefficients, c, place);
        }
    }
    coefficients.freeze();
    return coefficients.ring();
}

std::vector<ClosedMode> converted(const std::vector<BlockMode>& modes, const CoefficientRing& coefficients,
                                  const Place& place) {
    const auto vector = [&](const std::vector<Complex>& entries) {
        std::vector<Polynomial> result;
        for (const Complex& c : entries) result.push_back(coefficients.convert(c, place));
        return result;
    };
    std::vector<ClosedMode> result;
    for (const BlockMode& mode : modes)
        result.push_back(
            {coefficients.convert(mode.eigenvalue, place), vector(mode.column), vector(mode.row)});
    return result;
}

// The mode before k whose eigenvalue is the mirror image of that of mode k in the imaginary axis, where
// there is one to each eigenvalue.
std::optional<std::size_t> mirror_of(const std::vector<NumericMode>& modes, std::size_t k) {
    const ComplexBall mirrored = modes[k].eigenvalue.conjugate().negative();
    const auto is_it = [&](const NumericMode& m) { return m.eigenvalue.overlaps(mirrored); };
    if (is_it(modes[k]) || std::count_if(modes.begin(), modes.end(), is_it) != 1) return std::nullopt;
    const auto found = std::find_if(modes.begin(), modes.end(), is_it);
    const auto place = static_cast<std::size_t>(found - modes.begin());
    return place < k ? std::optional(place) : std::nullopt;
}

} // namespace

NumericModes::NumericModes(const Matrix& a, std::vector<std::vector<bool>> drives,
                           const std::vector<BlockOfStates>& blocks, CoefficientRing coefficients,
                           const Place& place)
    : drives_(std::move(drives)), ring_(ring_of(a, blocks, coefficients, place)) {
    add_blocks(a, blocks, coefficients, place);
    find_shapes(blocks, place);
}

void NumericModes::add_blocks(const Matrix& a, const std::vector<BlockOfStates>& blocks,
                              const CoefficientRing& coefficients, const Place& place) {
    for (const auto& row : a) {
        a_.emplace_back();
        for (const GiNaC::ex& entry : row) a_.back().push_back(coefficients.convert(entry, place));
    }
    for (const BlockOfStates& block : blocks) {
        NumberMatrix own;
        for (const std::size_t s : block.states) {
            own.emplace_back();
            for (const std::size_t t : block.states) own.back().push_back(a_[s][t]);
        }
        states_.push_back(block.states);
        blocks_.emplace_back(*ring_, std::move(own),
                             block.closed ? converted(*block.closed, coefficients, place)
                                          : std::vector<ClosedMode>());
    }
}

// Decides once which modes exist, so that more bits never change them.
void NumericModes::find_shapes(const std::vector<BlockOfStates>& blocks, const Place& place) {
    for (std::int64_t bits = first_bits; bits <= most_bits; bits *= 2) {
        const NumberDomain numbers = domain(bits);
        const auto modes = found(numbers);
        if (!modes) continue;
        shapes_.clear();
        first_shapes_.clear();
        for (std::size_t b = 0; b < blocks_.size(); ++b) add_shapes((*modes)[b], blocks[b]);
        if (values(*modes, numbers)) return;
    }
    refuse(Reason::size,
           {"the eigenvalues of a linear part in numbers are simple, and none is driven at itself",
            fmt::format("{} bits do not tell them from each other", most_bits),
            "give the modes in [modes], or write a coupling with a factor eps", place});
}

void NumericModes::add_shapes(const std::vector<NumericMode>& modes, const BlockOfStates& block) {
    const std::size_t own = first_shapes_.size(), first = shapes_.size();
    first_shapes_.push_back(first);
    std::size_t like = own; // the first block of the same spectrum
    for (std::size_t b = own; b-- > 0 && !block.closed;)
        if (!blocks_[b].is_closed() && blocks_[b].is_isospectral(blocks_[own])) like = b;
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const std::vector<ComplexBall>& column = modes[k].column;
        const auto entry = std::find_if(column.begin(), column.end(),
                                        [](const ComplexBall& c) { return !c.contains_zero(); });
        Shape shape{block.states[static_cast<std::size_t>(entry - column.begin())],
                    modes[k].real(),
                    modes[k].undamped() || modes[k].zero(),
                    std::nullopt,
                    first_shapes_[like] + k,
                    std::nullopt};
        if (const auto mirror = mirror_of(modes, k); mirror && blocks_[own].is_even())
            shape.mirror = first + *mirror;
        if (block.closed) {
            shape.pivot = block.states[(*block.closed)[k].pivot];
            shape.eigenvalue = (*block.closed)[k].eigenvalue;
        }
        shapes_.push_back(std::move(shape));
    }
}

NumberDomain NumericModes::domain(std::int64_t bits) const { return {ring_, 1, bits, {}}; }

auto NumericModes::found(const NumberDomain& domain) const -> std::optional<Found> {
    Found result;
    for (const NumericBlock& block : blocks_) {
        auto modes = block.modes(domain);
        if (!modes) return std::nullopt;
        result.push_back(std::move(*modes));
    }
    return result;
}

auto NumericModes::at(std::int64_t bits) const -> std::optional<Values> {
    const NumberDomain numbers = domain(bits);
    const auto modes = found(numbers);
    return modes ? values(*modes, numbers) : std::nullopt;
}

// The pivot's entry becomes 1 (1/2), and row . column = 1 stays.
auto NumericModes::values(const Found& modes, const NumberDomain& domain) const -> std::optional<Values> {
    const std::int64_t bits = domain.bits();
    Numbers numbers{bits, {}};
    for (const auto& row : a_) {
        numbers.a.emplace_back();
        for (const Polynomial& p : row) numbers.a.back().push_back(domain.value(p));
    }
    Values result;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
        for (const NumericMode& mode : modes[b]) {
            const Shape& shape = shapes_[result.eigenvalues.size()];
            const auto pivot = static_cast<std::size_t>(
                std::find(states_[b].begin(), states_[b].end(), shape.pivot) - states_[b].begin());
            ComplexBall scale = times(mode.column[pivot], ComplexBall(shape.real ? 1 : 2), bits);
            if (scale.contains_zero()) return std::nullopt;
            std::vector<ComplexBall> column, row;
            for (const ComplexBall& c : mode.column) column.push_back(over(c, scale, bits));
            for (const ComplexBall& c : mode.row) row.push_back(times(c, scale, bits));
            auto columns = extended(column, mode.eigenvalue, b, false, numbers);
            auto rows = extended(row, mode.eigenvalue, b, true, numbers);
            if (!columns || !rows) return std::nullopt;
            result.eigenvalues.push_back(mode.eigenvalue);
            result.columns.push_back(std::move(*columns));
            result.rows.push_back(std::move(*rows));
        }
    return result;
}

// (A_CC - lambda) v_C = -sum A_Ct v_t over the states t between; for rows with A transposed.
std::optional<std::vector<ComplexBall>> NumericModes::extended(const std::vector<ComplexBall>& own,
                                                               const ComplexBall& eigenvalue,
                                                               std::size_t block, bool rows,
                                                               const Numbers& numbers) const {
    const auto entry = [&](std::size_t s, std::size_t t) -> const ComplexBall& {
        return rows ? numbers.a[t][s] : numbers.a[s][t];
    };
    std::vector<ComplexBall> vector(a_.size());
    for (std::size_t k = 0; k < own.size(); ++k) vector[states_[block][k]] = own[k];
    for (const std::size_t b : blocks_reached(block, states_, drives_, rows)) {
        const std::vector<std::size_t>& states = states_[b];
        BallMatrix matrix(states.size(), std::vector<ComplexBall>(states.size()));
        std::vector<ComplexBall> right(states.size());
        for (std::size_t j = 0; j < states.size(); ++j) {
            for (std::size_t k = 0; k < states.size(); ++k) matrix[j][k] = entry(states[j], states[k]);
            matrix[j][j] = plus(matrix[j][j], eigenvalue.negative(), numbers.bits);
            for (std::size_t t = 0; t < vector.size(); ++t)
                acb_submul(right[j].get(), entry(states[j], t).get(), vector[t].get(), numbers.bits);
        }
        const auto solved = solution(matrix, right, numbers.bits);
        if (!solved) return std::nullopt;
        for (std::size_t k = 0; k < states.size(); ++k) vector[states[k]] = (*solved)[k];
    }
    return vector;
}

} // namespace resonform
