// SPDX-License-Identifier: GPL-3.0-or-later
// Exponentials as a reader writes them:
//
//   exp(T/2)^3 * exp(-T)     ->   exp(T/2)
//   exp(-a*log(tau)/2 + T)   ->   tau^(-a/2) * exp(T)
#pragma once

#include "emit/display/display.hpp"

#include <string>

namespace resonform {

// The term with its exponentials made one, and those of logarithms made powers. The tail stays.
DisplayTerm with_powers(const DisplayTerm& term);
// Whether that differs from the term, all of which it copies.
bool has_exponential(const DisplayTerm& term);

// a - b + c of such terms, each spelled without its sign by `spelled`; 0 of none.
template <class Spelled> std::string signed_sum(const DisplaySum& sum, const Spelled& spelled) {
    if (sum.terms.empty()) return "0";
    std::string text;
    const auto append = [&](const DisplayTerm& term) {
        const bool negative = cln::minusp(term.coefficient);
        if (text.empty())
            text = negative ? "-" : "";
        else
            text += negative ? " - " : " + ";
        text += spelled(term);
    };
    for (const DisplayTerm& term : sum.terms)
        if (has_exponential(term))
            append(with_powers(term));
        else
            append(term);
    return text;
}

} // namespace resonform
