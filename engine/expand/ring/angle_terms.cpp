// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/ring/angle_terms.hpp"

#include "model/text/canonical.hpp"

namespace resonform {

using GiNaC::ex;

bool is_rational_number(const ex& e) {
    return GiNaC::is_a<GiNaC::numeric>(e) && GiNaC::ex_to<GiNaC::numeric>(e).is_rational();
}

Multiple one_multiple(const ex& term) {
    Multiple result{1, 1};
    for (const ex& f : factors_of(term)) {
        if (is_rational_number(f))
            result.factor = result.factor * to_rational(f);
        else
            result.part *= f;
    }
    return result;
}

std::vector<Multiple> multiples(const ex& argument) {
    std::vector<Multiple> result;
    const auto add = [&](const ex& term) {
        if (const Multiple m = one_multiple(term); !cln::zerop(m.factor)) result.push_back(m);
    };
    if (GiNaC::is_a<GiNaC::add>(argument)) {
        for (const ex& term : operands(argument)) add(term);
    } else {
        add(argument);
    }
    return result;
}

CosineSine sum_of(const CosineSine& a, const CosineSine& b) {
    return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

} // namespace resonform
