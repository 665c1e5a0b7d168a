// SPDX-License-Identifier: GPL-3.0-or-later
// Data of a scene in emitted code.
#pragma once

#include "emit/cpp/plan.hpp"

namespace resonform {

// The tables of breakpoints and coefficients; "" without data.
std::string cpp_data_tables(const Program& program);
// edges(c), the slow times at which pieces end; "" without data.
std::string cpp_data_edges(CppPlan& plan);
// A function of slow time as the integrals want it: in pieces, where there are data. `constants`: "c_".
std::string cpp_in_pieces(const CppPlan& plan, const std::string& function, const std::string& constants);

} // namespace resonform
