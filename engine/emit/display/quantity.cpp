// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/quantity.hpp"

#include "emit/display/display.hpp"
#include "emit/display/spelling.hpp"

namespace resonform {

std::string quantity(const Ring& ring, const Polynomial& p) {
    const Polynomial turned_back(ring.monomial(Ring::imaginary_unit), -1); // 1/i
    const bool imaginary = ring.conjugate(p) == -p;
    return short_quantity(
        spell(display(ring, imaginary ? ring.multiply(turned_back, p) : p), text_spelling()));
}

std::string short_quantity(const std::string& text) {
    constexpr std::size_t longest = 80;
    return text.size() <= longest ? text : text.substr(0, longest - 3) + "...";
}

} // namespace resonform
