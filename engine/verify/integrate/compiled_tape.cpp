// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/compiled_tape.hpp"

#include "verify/integrate/tape_code.hpp"

namespace resonform {

namespace {

std::vector<double> constants_of(const Tape& tape, const std::vector<double>& parameters, double eps) {
    const std::vector<double> all = BoundTape<double>(tape, parameters, eps).registers();
    return {all.begin(), all.begin() + tape.constant_count()};
}

} // namespace

CompiledTape::CompiledTape(const Tape& tape, const std::vector<double>& parameters, double eps,
                           const std::filesystem::path& cache, const std::function<void()>& announce)
    : code_(SharedObject::load(emit_tape(tape), cache, announce)), data_(tape.data()),
      constants_(constants_of(tape, parameters, eps)), row_count_(jet_rows(tape)),
      rates_(reinterpret_cast<decltype(rates_)>(code_.symbol("rf_rates"))),
      jacobian_(reinterpret_cast<decltype(jacobian_)>(code_.symbol("rf_jacobian"))),
      jet_(reinterpret_cast<decltype(jet_)>(code_.symbol("rf_jet"))) {}

RightHandSide CompiledTape::rates() const {
    return {[](const void* self, const double* state, double* rates) {
                const auto& tape = *static_cast<const CompiledTape*>(self);
                tape.rates_(tape.constants_.data(), state, rates);
            },
            this,
            [](const void* self, const double* state, double* matrix) {
                const auto& tape = *static_cast<const CompiledTape*>(self);
                tape.jacobian_(tape.constants_.data(), state, matrix);
            }};
}

std::vector<double> CompiledTape::rows() const { return std::vector<double>(row_count_ * jet_stride); }

} // namespace resonform
