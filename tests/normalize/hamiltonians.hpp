// SPDX-License-Identifier: GPL-3.0-or-later
// Systems that are given by an energy.
#pragma once

#include "normalize/styles/hamiltonian.hpp"
#include "support/exact.hpp"

#include <string>

namespace resonform::test {

// Coordinates x, y (with momenta px, py) or x alone.
inline std::string one_degree(const std::string& energy, const std::string& parameters = "") {
    return "[system]\nname = \"test\"\n[parameters]\n" + parameters +
           "[variables]\nx = { role = \"fast\" }\npx = { role = \"fast\" }\n"
           "[hamiltonian]\nenergy = \"" +
           energy + "\"\nmomenta = { x = \"px\" }\n";
}

inline std::string two_degrees(const std::string& energy, const std::string& parameters = "") {
    return "[system]\nname = \"test\"\n[parameters]\n" + parameters +
           "[variables]\nx = { role = \"fast\" }\npx = { role = \"fast\" }\n"
           "y = { role = \"fast\" }\npy = { role = \"fast\" }\n"
           "[hamiltonian]\nenergy = \"" +
           energy + "\"\nmomenta = { x = \"px\", y = \"py\" }\n";
}

inline std::string henon_heiles() { return two_degrees("px^2/2 + py^2/2 + (x^2 + y^2)/2 + x^2*y - y^3/3"); }

} // namespace resonform::test
