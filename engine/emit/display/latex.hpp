// SPDX-License-Identifier: GPL-3.0-or-later
// Display sums in LaTeX (amsmath), as the paper writes them.
//
//   -\frac{i \sqrt{g}}{16 \left(r^{2} + \xi^{2}\right)^{1/4}} z_{1}^{2} z_{2}
#pragma once

#include "emit/display/display.hpp"

#include <string>

namespace resonform {

std::string latex(const DisplaySum& sum);
std::string latex(const DisplayFactor& factor);

// "xi'" -> \dot{\xi}; "lambda1" -> \lambda_{1}; "C_delta" -> C_{\delta}; "gain" -> \mathrm{gain}.
std::string latex_name(const std::string& name, int primes = 0);

// "x_2" -> "x_(2)", the name of x_{(2)}; again: "x_((2))".
std::string with_bracketed_subscript(const std::string& name);

// Plain text with the characters special to TeX escaped.
std::string latex_text(const std::string& text);

} // namespace resonform
