// SPDX-License-Identifier: GPL-3.0-or-later
// Program -> C++ text.
#pragma once

#include "emit/cpp/further.hpp"
#include "emit/cpp/lies.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace resonform {

struct CppOptions {
    bool inline_runtime = false;          // copy runtime/*.hpp into the file instead of including it
    std::vector<CppFurther> further = {}; // where the evaluator estimates errors
};

// The header generated/<system>/<scene>.hpp: namespace resonform::generated::<system>::<scene>.
std::string emit_cpp(const Program& program, const CppOptions& options = {});

// A translation unit with a C interface around the header's text, for a shared library that
// verify/evaluate/evaluator.hpp loads. For each letter R of `types`, of double: "d", long double: "l",
// __float128: "q", for each takes the compiler seconds:
//   void* rf_new_R(const R* eps, const R* parameters, const R* start, const R* slow_time_end);
//   void  rf_delete_R(void*);
//   int   rf_call_R(const void*, const R* t, R* outputs);           status, 0 = ok
//   int   rf_state_R(const void*, const R* t, R* state);            only if program.state is filled
// of double besides
//   int   rf_prepare_d(const void*);                                status: builds tables
//   void  rf_batch_d(const void*, const double* t, long n, double* const* outputs, unsigned char* status);
//   void  rf_grid_d(const void*, const double* t0, const double* dt, long n, double* const* outputs,
//                   unsigned char* status);
// With the letter "f", of a final point, nothing constructed (runtime/final_point.hpp):
//   int   rf_at_end(const double* eps, const double* parameters, const double* start, const double* t,
//                   double* outputs);                               status
// With the letter "e", of many members in double (runtime/ensemble.hpp), whose arguments are eps, the
// parameters and the start values, an array each, or null for the scene's default:
//   void  rf_ensemble(const double* const* arguments, long n, const double* t, double* const* outputs,
//                     unsigned char* status, int full_phase);
//   void  rf_interval_ends(const double* const* arguments, long n, double* t);    by the scene's default
// and, if the program has rows, rf_loops, which must be called before batches: with &kernel::loops.
// With lies, the coefficients of the class are planted there, and
//   unsigned char* rf_lies();                       an entry for each place, from 1: 0, or which lie it is
//   (frames/lies.txt)
std::string emit_library(const Program& program, std::string_view types, CppLies* lies = nullptr);

} // namespace resonform
