// SPDX-License-Identifier: GPL-3.0-or-later
// Error estimates in emitted code: beside the formula stand those that go a weight further, in a namespace of
// their own each, and the estimate is the difference (verify/estimate/error_estimator.hpp).
#pragma once

#include "emit/cpp/plan.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

struct CppFurther {
    std::vector<std::size_t> outputs;       // of the program, that this is the first to move
    std::shared_ptr<const Program> program; // their values; its inputs are among those of the program
};

struct PlannedFurther {
    std::vector<std::size_t> outputs; // as in CppFurther
    CppPlan plan;                     // of its class
};
std::vector<PlannedFurther> planned(const std::vector<CppFurther>& further);
std::vector<CppCallable> callables_of(const std::vector<PlannedFurther>& further);

// The namespace of a program that goes further: "next_4", of the order 4.
std::string namespace_of_further(const Program& program);

// Of the class: error_estimate and error_batch; what these use; members; their place in the initialisers of
// the constructor, "next_4_(...), ". All are "" without formulas that go further.
std::string cpp_estimates(const CppPlan& plan, const std::vector<PlannedFurther>& further);
std::string cpp_further_arguments(const CppPlan& plan, const std::vector<PlannedFurther>& further);
std::string cpp_further_members(const CppPlan& plan, const std::vector<PlannedFurther>& further);
std::string cpp_further_built(const std::vector<PlannedFurther>& further);

} // namespace resonform
