// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients of emitted code, each of which can be made a lie while it runs (frames/lies.txt):
//
//   Real(3) * x + y   ->   lied(1, Real(3)) * x + lied(2, y)
//
// A term without a number has the coefficient 1, or -1.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace resonform {

class CppLies {
public:
    struct Place {
        std::string function;    // "outputs", "compute_constants"
        std::string coefficient; // "Real(3)", or the whole term
    };

    // The text of a coefficient as one that can be made a lie. Places are counted from 1.
    std::string planted(const std::string& text);
    // The places since the last call are in this function.
    void end_function(const std::string& name);

    [[nodiscard]] const std::vector<Place>& places() const { return places_; }
    // Declares the array lie_kinds, which has an entry for each of them (frames/lies.txt).
    [[nodiscard]] std::string declaration() const;

private:
    std::vector<Place> places_;
    std::size_t named_ = 0;
};

} // namespace resonform
