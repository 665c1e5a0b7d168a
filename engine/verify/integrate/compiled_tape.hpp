// SPDX-License-Identifier: GPL-3.0-or-later
// A tape as compiled code, with numbers put in for parameters and eps.
#pragma once

#include "verify/integrate/integrator.hpp"
#include "verify/integrate/tape.hpp"
#include "verify/run/shared_object.hpp"

#include <functional>
#include <vector>

namespace resonform {

class CompiledTape {
public:
    // Errors: those of SharedObject.
    CompiledTape(const Tape& tape, const std::vector<double>& parameters, double eps,
                 const std::filesystem::path& cache, const std::function<void()>& announce);

    // With its Jacobian; valid as long as this object.
    [[nodiscard]] RightHandSide rates() const;
    // rf_jet of verify/integrate/tape_code.hpp, and its rows: zeros.
    void expand(int order, double* rows) const { jet_(constants_.data(), order, rows); }
    [[nodiscard]] std::vector<double> rows() const;
    [[nodiscard]] const std::vector<Tape::Data>& data() const { return data_; }

private:
    SharedObject code_;
    std::vector<Tape::Data> data_;
    std::vector<double> constants_;
    std::size_t row_count_;
    void (*rates_)(const double*, const double*, double*);
    void (*jacobian_)(const double*, const double*, double*);
    void (*jet_)(const double*, int, double*);
};

// Steps as long as those of integrate_taylor, all of one order. `tape` must outlive the
// integrator.
std::unique_ptr<Integrator> make_taylor(const CompiledTape& tape, const Start& start);

} // namespace resonform
