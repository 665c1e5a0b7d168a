// SPDX-License-Identifier: GPL-3.0-or-later
// The task of a scene's evaluator, taken from the exact polynomials of its solution: before lowering,
// pruning and the choice of a form. Closed solutions and slow flows are one thing here: variables that move
// in slow time T, phases that turn, and outputs as polynomials of them.
#pragma once

#include "solve/first_correction.hpp"
#include "verify/integrate/tape.hpp"
#include "verify/symbolic/start.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

struct SymbolicVariable { // d/dT = rate/eps^power, in powers of the ring's eps, as all here
    enum class Kind {
        slow,       // zeta
        quadrature, // from 0
        mode,       // a, of z = eps^weight a e^{chi + i theta}
        angle,      // delta, of phi = phi_0 + delta + theta
        drift,      // the integral of its rate
        phase,      // theta, from 0
        exponent,   // chi, from 0
    };
    Kind kind;
    GeneratorId id = -1, conjugate = -1;
    int power = 0, weight = 0;
    std::optional<std::size_t> phase = {}, decay = {}; // mode, angle: indices of the variables theta and chi
    std::size_t start = 0;                             // index into SymbolicStart
    SymbolicSum rate = {};                             // with the phases left out of modes and angles
    SymbolicSum drive = {}, decline = {};              // slow, if rate = drive - decline zeta: constants
    bool needed = false;                               // by an output
};

struct SymbolicPrimitive { // no quadrature
    GeneratorId id;
    bool logarithm; // else an exponential
    SymbolicSum argument;
};

struct SymbolicOutput {
    std::string name;
    SymbolicSum sum;                  // written out
    std::optional<std::size_t> drift; // a variable to be added, and its constant
};

// A condition that needs variables which no output needs is left out.
struct SymbolicCondition { // > 0
    enum class Kind {
        radicand,   // of roots and logarithms, and the damping of modes
        standing,   // the margin of a divisor that does not move
        keeps_sign, // of a slow variable or a divisor: that of the start
        slow,
        declared,   // of SymbolicSolution::declared, by index
        correction, // of SymbolicSolution::corrections, by index
    };
    Kind kind;
    SymbolicSum sum;
    std::size_t index = 0;
};

struct SymbolicCorrection { // of the map, > 0 while it is small
    FirstCorrection correction;
    std::vector<SymbolicSum> polynomials; // of the correction
    SymbolicSum needs;                    // all that it is made of
    bool is_layer = false;                // where it moves; else a condition, or nothing
};

class SymbolicSolution {
public:
    // fixed: values under [fix] are put in exactly; else they are inputs. solution and scene must outlive it.
    SymbolicSolution(const Solution& solution, const Scene& scene, bool fixed = true);
    SymbolicSolution(const SymbolicSolution&) = delete;
    SymbolicSolution& operator=(const SymbolicSolution&) = delete;

    [[nodiscard]] const SymbolicRing& ring() const { return *ring_; }
    [[nodiscard]] const std::vector<SymbolicVariable>& variables() const { return variables_; }
    [[nodiscard]] const std::vector<SymbolicPrimitive>& primitives() const { return primitives_; }
    [[nodiscard]] const std::vector<SymbolicOutput>& outputs() const { return outputs_; }
    [[nodiscard]] const std::vector<SymbolicCondition>& conditions() const { return conditions_; }
    [[nodiscard]] const std::vector<SymbolicLayer>& layers() const { return layers_; }
    [[nodiscard]] const std::vector<SymbolicCorrection>& corrections() const { return corrections_; }
    // |a| of each mode; of one that decays 0: it is gone before anything else moves.
    [[nodiscard]] std::vector<Wide> moduli(const SymbolicValues<Wide>& values, const Wide& eps) const;
    // The expressions declared positive, at these values of the slow variables, in the order of `variables`.
    [[nodiscard]] std::vector<Float128> declared_at(const std::vector<Wide>& slow,
                                                    const SymbolicInputs& inputs) const;
    [[nodiscard]] const SymbolicStartFinder& start() const { return *start_; }
    // Generators with a constant value that the start gives: amplitude and constants of a closed solution.
    struct Constant {
        GeneratorId id;
        std::optional<std::size_t> drift; // else the amplitude
    };
    [[nodiscard]] const std::vector<Constant>& constants() const { return constants_; }
    [[nodiscard]] std::optional<GeneratorId> slow_time() const { return slow_time_; }
    // Everything that results depend on, as text: the key of caches.
    [[nodiscard]] std::string text() const;

private:
    void read_closed();
    void read_flow();
    std::size_t add(SymbolicVariable variable);
    void add_slow(const Variable& variable, GeneratorId id, std::size_t start, const Polynomial& rate,
                  int power);
    void add_layers(const std::function<Polynomial(const Polynomial&)>& lifted);
    void add_corrections();
    void add_conditions();
    void keep_what_is_needed();
    [[nodiscard]] std::vector<Float128> parameters(const SymbolicInputs& inputs) const;

    const Solution& solution_;
    const Scene& scene_;
    SymbolicRing::Fix fix_;
    std::map<std::string, Float128> fix_values_;
    std::unique_ptr<SymbolicRing> ring_;
    std::vector<SymbolicVariable> variables_;
    std::vector<GiNaC::symbol> slow_symbols_;
    std::vector<SymbolicPrimitive> primitives_;
    std::vector<SymbolicOutput> outputs_;
    std::vector<SymbolicCondition> conditions_;
    std::vector<SymbolicLayer> layers_;
    std::vector<SymbolicCorrection> corrections_;
    SymbolicSum modulus_;            // of a closed solution
    std::unique_ptr<Tape> declared_; // in parameters; its states are the slow variables
    std::unique_ptr<SymbolicStartFinder> start_;
    std::vector<Constant> constants_;
    std::optional<GeneratorId> slow_time_;
};

} // namespace resonform
