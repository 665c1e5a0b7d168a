// SPDX-License-Identifier: GPL-3.0-or-later
// Where the divisors of a result may vanish, as far as the declared domain does not rule it out.
//
//   (2*w1 - w2)*(tau^2 + 1)*w1, w1 positive   ->   2*w1 - w2
#pragma once

#include "emit/display/display.hpp"
#include "expand/expansion/graded_field.hpp"

#include <utility>
#include <vector>

namespace resonform {

// For polynomials in constants of the ring, without i. Remembers its results.
class Vanishing {
public:
    explicit Vanishing(const GradedField& field) : field_(field) {}

    // Proved; false: it may vanish somewhere.
    bool nowhere(const Polynomial& p);
    // The factors of p that may vanish, without common factors of its terms: divisors that the ring has
    // learned, and the rest.
    std::vector<Polynomial> factors(const Polynomial& p);

private:
    const GradedField& field_;
    std::vector<std::pair<Polynomial, bool>> known_;
};

// p or -p, whichever begins without a minus, for an equation p = 0.
DisplaySum display_without_sign(const Ring& ring, const Polynomial& p);

} // namespace resonform
