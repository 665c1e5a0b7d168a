// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/expansion/graph_fit.hpp"
#include "normalize/recursion/poincare.hpp"

#include <algorithm>

namespace resonform {

namespace {

// Two frequencies cost a ring a few divisors through weight 3, three of them through weight 2, ...
constexpr int largest_for_ring = 5; // weight + number of frequencies

// Neither is zero.
bool proportional(const Polynomial& a, const Polynomial& b) {
    const Rational of_a = 1 / a.terms().front().coefficient, of_b = -1 / b.terms().front().coefficient;
    return combination({{of_a, &a}, {of_b, &b}}).empty();
}

bool is_number(const Polynomial& p) { return p.size() == 1 && p.terms().front().monomial == Monomial{}; }

} // namespace

bool suits_graph(const GradedField& field, int through) {
    if (!fits_graph(field)) return false;
    std::vector<Polynomial> frequencies; // no two proportional
    const auto add = [&](const Polynomial& frequency) {
        if (frequency.empty() || is_number(frequency)) return;
        if (std::none_of(frequencies.begin(), frequencies.end(),
                         [&](const Polynomial& known) { return proportional(known, frequency); }))
            frequencies.push_back(frequency);
    };
    for (const Mode& m : field.modes) add(m.omega);
    for (const AngleVariable& a : field.angles) add(a.frequency);
    const int weight = through / field.system().eps_root;
    return frequencies.size() > 1 && weight + static_cast<int>(frequencies.size()) > largest_for_ring;
}

} // namespace resonform
