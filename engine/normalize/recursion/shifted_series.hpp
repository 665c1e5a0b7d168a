// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials of a field at shifted variables, evaluated weight by weight: z + g, zbar + conj g, phi + m,
// xi + k, and with xi every root of the ring that depends on it.
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <map>

namespace resonform {

class ShiftedSeries {
public:
    explicit ShiftedSeries(const GradedField& field);

    // All polynomials are added before run().
    SeriesProgram::Node add(const Polynomial& p);
    [[nodiscard]] SeriesRun run() const { return SeriesRun(program_); }
    // Sets part `weight` of the shifted variables, as far as the shift is known there.
    void set(SeriesRun& run, const NearIdentityMap& shift, int weight) const;

private:
    [[nodiscard]] bool moves(GeneratorId id) const;
    SeriesProgram::Node power(GeneratorId id, int exponent);
    SeriesProgram::Node function(GeneratorId id);
    [[nodiscard]] GeneratorId cosine_beside(GeneratorId sine) const;
    SeriesProgram::Node turned(GeneratorId phase, int exponent);

    const GradedField& field_;
    SeriesProgram program_;
    std::map<GeneratorId, SeriesProgram::Node> inputs_; // of a phase: the shift of its angle
    std::vector<GeneratorId> moving_;                   // generators that are not constants
};

} // namespace resonform
