// SPDX-License-Identifier: GPL-3.0-or-later
// The symbolic evaluator: runs a Program's graph in any real type, without compiling anything. Emitted
// code is compared with it, and `resonform evaluate` uses it.
#pragma once

#include "runtime/status.hpp"
#include "verify/evaluate/interpretation.hpp"
#include "verify/evaluate/program_defaults.hpp"

#include <memory>
#include <string>
#include <vector>

namespace resonform {

// Real: double, long double, __float128, boost cpp_bin_float_50 / _100 (instantiated in the .cpp).
template <class Real> class Interpreter {
public:
    // parameters, start: values in the order of program.parameters / program.start; empty: defaults.
    Interpreter(std::shared_ptr<const Program> program, Real eps, std::vector<Real> parameters,
                std::vector<Real> start, Real slow_time_end);
    // The same, for many of one program.
    Interpreter(std::shared_ptr<const Interpretation> shared, Real eps, std::vector<Real> parameters,
                std::vector<Real> start, Real slow_time_end);
    ~Interpreter();
    Interpreter(Interpreter&&) noexcept;

    Status call(Real t, std::vector<Real>& outputs) const; // sized like program.outputs
    Status state(Real t, std::vector<Real>& state) const;  // sized like program.state
    // sum of |terms| of each output at t, written out, with 1 for |cos| and |sin|: the scale against which
    // accuracy is judged. Functions and negative powers count as one term.
    Status scale(Real t, std::vector<Real>& scale) const;
    // The values at t of the graph's nodes that outputs are computed from, constants among them; others are
    // 0. Empty without numbers.
    Status trace(Real t, std::vector<Real>& nodes) const;
    [[nodiscard]] Status construction_status() const;
    // The cause of a status of the construction or of calls, "" if there is none; it lives as long as this.
    [[nodiscard]] const char* why(Status status) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace resonform
