// SPDX-License-Identifier: GPL-3.0-or-later
// How a form finds its node: by its terms, then by its values.
#include "algebra/graph/coefficient_graph.hpp"

#include <algorithm>
#include <stdexcept>

namespace resonform {

namespace {

constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ULL;

std::uint32_t hash_of(std::span<const GraphTerm> form) {
    std::uint64_t hash = form.size();
    for (const GraphTerm& t : form) {
        hash = (hash ^ ((std::uint64_t{t.left} << 32) | t.right)) * golden;
        hash = (hash ^ (hash >> 29) ^ t.factor) * 0xBF58476D1CE4E5B9ULL;
    }
    return static_cast<std::uint32_t>(hash >> 32);
}

} // namespace

Coefficient CoefficientGraph::lookup(std::span<const GraphTerm> form) {
    if (2 * forms_.size() >= form_slots_.size()) grow_forms();
    const std::uint32_t hash = hash_of(form);
    const std::size_t mask = form_slots_.size() - 1;
    std::size_t slot = hash & mask;
    for (; form_slots_[slot] != 0; slot = (slot + 1) & mask) {
        const Form& known = forms_[form_slots_[slot] - 1];
        if (known.hash == hash && known.count == form.size() &&
            std::equal(form.begin(), form.end(), terms_.begin() + known.begin))
            return known.meaning;
    }
    if (terms_.size() + form.size() > UINT32_MAX)
        throw std::length_error("CoefficientGraph: more than 2^32 terms");
    const Coefficient meaning = decide(form);
    forms_.push_back(
        {static_cast<std::uint32_t>(terms_.size()), static_cast<std::uint32_t>(form.size()), hash, meaning});
    terms_.insert(terms_.end(), form.begin(), form.end());
    form_slots_[slot] = static_cast<std::uint32_t>(forms_.size());
    return meaning;
}

// A form that is new: zero, an old node (or its negative) by value, or a new node, whose form comes next.
Coefficient CoefficientGraph::decide(std::span<const GraphTerm> form) {
    ++decisions_.asked;
    const Values values = values_of(form);
    if (values == Values{}) {
        ++decisions_.zeros;
        return {};
    }
    if (const std::uint32_t known = slot_of_values(values); known != 0) {
        ++decisions_.merged;
        const NodeId node = known - 1;
        return {values_[node] == values ? RationalTable::one : RationalTable::minus_one, node};
    }
    return {RationalTable::one, append(Kind::sum, static_cast<std::uint32_t>(forms_.size()), values)};
}

CoefficientGraph::Values CoefficientGraph::values_of(std::span<const GraphTerm> form) {
    Values values{};
    for (std::size_t k = 0; k < points; ++k) {
        PrimeField::ProductSum sum(fields_[k]);
        for (const GraphTerm& t : form) {
            Residue left = values_[t.left][k];
            if (t.factor != RationalTable::one) left = fields_[k].multiply(residue(t.factor, k), left);
            sum.add(left, values_[t.right][k]);
        }
        values[k] = sum.value();
    }
    return values;
}

Residue CoefficientGraph::residue(RationalId id, std::size_t point) {
    while (residues_.size() < rationals_.size()) {
        Values values{};
        for (std::size_t k = 0; k < points; ++k) {
            const auto value = fields_[k].from(rationals_.value(static_cast<RationalId>(residues_.size())));
            if (!value) throw std::logic_error("CoefficientGraph: a prime divides a denominator");
            values[k] = *value;
        }
        residues_.push_back(values);
    }
    return residues_[id][point];
}

NodeId CoefficientGraph::append(Kind kind, std::uint32_t index, const Values& values) {
    const auto node = static_cast<NodeId>(nodes_.size());
    if (2 * nodes_.size() >= value_slots_.size()) grow_values();
    nodes_.push_back({kind, index});
    values_.push_back(values);
    slot_of_values(values) = node + 1;
    return node;
}

CoefficientGraph::Values CoefficientGraph::negated(Values values) const {
    for (std::size_t k = 0; k < points; ++k) values[k] = fields_[k].negate(values[k]);
    return values;
}

// The slot of the node with these values or their negatives, or the free one where it belongs. Both signs
// have one hash.
std::uint32_t& CoefficientGraph::slot_of_values(const Values& values) {
    const Residue either = std::min(values[0], fields_[0].negate(values[0]));
    const std::size_t mask = value_slots_.size() - 1;
    const Values negative = negated(values);
    std::size_t slot = (either * golden >> 20) & mask;
    for (; value_slots_[slot] != 0; slot = (slot + 1) & mask) {
        const Values& known = values_[value_slots_[slot] - 1];
        if (known == values || known == negative) break;
    }
    return value_slots_[slot];
}

void CoefficientGraph::grow_forms() {
    form_slots_.assign(std::max<std::size_t>(1024, 2 * form_slots_.size()), 0);
    const std::size_t mask = form_slots_.size() - 1;
    for (std::size_t k = 1; k < forms_.size(); ++k) {
        std::size_t slot = forms_[k].hash & mask;
        while (form_slots_[slot] != 0) slot = (slot + 1) & mask;
        form_slots_[slot] = static_cast<std::uint32_t>(k + 1);
    }
}

void CoefficientGraph::grow_values() {
    value_slots_.assign(std::max<std::size_t>(1024, 2 * value_slots_.size()), 0);
    for (std::size_t k = 0; k < values_.size(); ++k)
        slot_of_values(values_[k]) = static_cast<std::uint32_t>(k + 1);
}

} // namespace resonform
