// SPDX-License-Identifier: GPL-3.0-or-later
// The LaTeX that emit/display writes, as MathML: what a browser shows without scripts and fonts of its own.
#pragma once

#include <string>
#include <vector>

namespace resonform::report {

// A line of a document of formulas: words, or an equation.
struct FormulaLine {
    std::string words; // "amplitude and phase:"; empty for an equation
    std::vector<std::string>
        terms; // LaTeX, in pieces between which a line may break: "\dot{\xi} =", "a", "- b"
};

// "% ...\n\begin{align*}\n  x &= a \\\n  &\quad - b\n\end{align*}\n" -> one line of terms {"x =", "a", "-
// b"}. Comments are left out.
std::vector<FormulaLine> formula_lines(const std::string& document);

// "\frac{1}{2} z_{1}^{2}" -> "<math ...>...</math>". A command that is not known is shown as it is spelled.
std::string to_mathml(const std::string& latex);

} // namespace resonform::report
