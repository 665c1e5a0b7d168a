// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/decided.hpp"

#include "algebra/number/error.hpp"
#include "emit/display/display.hpp"
#include "emit/display/spelling.hpp"
#include "normalize/recursion/undecided_term.hpp"

#include <fmt/format.h>

namespace resonform {

void require_decided(const NormalForm& form) {
    const auto undecided = undecided_term(form);
    if (!undecided) return;
    const Ring& ring = *form.field->ring;
    const auto text = [&](const Polynomial& p) { return spell(display(ring, p), text_spelling()); };
    const std::string coefficient = text(undecided->coefficient);
    constexpr std::size_t longest = 1500; // of a message of 2 kB
    const std::string shown =
        coefficient.size() > longest ? coefficient.substr(0, longest) + "..." : coefficient;
    refuse(Reason::undecided,
           {"each coefficient of a normal form is proved to be zero or to be different from zero",
            fmt::format("{} of {} in {}", shown, text(Polynomial(undecided->monomial, Rational(1))),
                        undecided->rate),
            "write the equation without the expressions that may cancel, or give parameters values with "
            "--set NAME=VALUE",
            {}});
}

} // namespace resonform
