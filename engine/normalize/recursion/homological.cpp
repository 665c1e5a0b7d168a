// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/homological.hpp"

#include <algorithm>

namespace resonform {

std::vector<Carrier> carriers_of(const GradedField& field) {
    std::vector<Carrier> carriers;
    for (const Mode& m : field.modes) {
        const int weight = field.ring->generator(m.z).weight;
        carriers.push_back({m.z, false, weight});
        if (!m.is_real()) carriers.push_back({m.zbar, false, weight});
    }
    for (const SlowVariable& s : field.slow) carriers.push_back({s.generator, false, 0});
    for (const AngleVariable& a : field.angles) carriers.push_back({a.phase, true, 0});
    return carriers;
}

template <class Domain>
HomologicalEquation<Domain>::HomologicalEquation(const GradedField& field, Domain domain, int mode,
                                                 std::string variable, Place place)
    : field_(field), domain_(domain), mode_(mode), variable_(std::move(variable)), place_(std::move(place)),
      divisors_(field, domain, mode), outer_(field.outer()), carriers_(carriers_of(field)),
      slopes_(carriers_.size()), derived_(carriers_.size()) {}

template <class Domain>
auto HomologicalEquation<Domain>::right_hand_side(int weight, const Part& field_part,
                                                  const Transport<Part>& transport) -> Part {
    std::vector<ProductOf<Part>> products;
    for (std::size_t c = 0; c < slopes_.size(); ++c)
        for (int j = 0; j <= weight; ++j)
            if (!transport[c].part(weight - j).empty()) derive(c, j);
    for (std::size_t c = 0; c < slopes_.size(); ++c)
        for (int j = 0; j <= weight; ++j)
            if (!slopes_[c].part(j).empty() && !transport[c].part(weight - j).empty())
                products.push_back({-1, &slopes_[c].part(j), &transport[c].part(weight - j)});
    const Part one = domain_.one();
    if (!products.empty()) products.push_back({1, &field_part, &one});
    return domain_.without_vanishing(products.empty() ? field_part : domain_.dot(products), outer_);
}

template <class Domain> auto HomologicalEquation<Domain>::divided(int weight, const Part& part) -> Shares {
    std::vector<const Divisor<Part>*> divisors; // one for each share
    const auto share_of = [&](const Monomial& outer) {
        const Divisor<Part>* divisor = &divisor_of(outer, weight);
        const auto known = std::find(divisors.begin(), divisors.end(), divisor);
        const auto place = static_cast<std::size_t>(known - divisors.begin());
        if (known == divisors.end()) divisors.push_back(divisor);
        return place;
    };
    const std::vector<Part> shares = domain_.split(part, outer_, share_of);
    std::vector<std::pair<Rational, const Part*>> exact, near;
    std::vector<ProductOf<Part>> quotients;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        if (divisors[k]->verdict == DivisorVerdict::removed)
            quotients.push_back({1, &shares[k], &divisors[k]->inverse});
        else
            (divisors[k]->verdict == DivisorVerdict::kept_near ? near : exact).emplace_back(1, &shares[k]);
    }
    return {domain_.combination(exact), domain_.combination(near), domain_.dot(quotients)};
}

template <class Domain> void HomologicalEquation<Domain>::accept(int weight, Part correction, Part rate) {
    rate_.set(weight, std::move(rate));
    correction_.set(weight, std::move(correction));
}

template <class Domain>
auto HomologicalEquation<Domain>::divisor_of(const Monomial& outer, int weight) -> const Divisor<Part>& {
    const Divisor<Part>& divisor = at_place(place_, [&]() -> const Divisor<Part>& {
        try {
            return divisors_.of(outer);
        } catch (UndecidedDivisor& undecided) {
            undecided.place = place_;
            throw;
        }
    });
    if (seen_.insert(outer).second)
        records_.push_back({variable_, outer, weight, divisor.value, divisor.verdict});
    return divisor;
}

// d_w lowers the weight by that of w.
template <class Domain> void HomologicalEquation<Domain>::derive(std::size_t carrier, int weight) {
    const Carrier& by = carriers_[carrier];
    const Part& c = correction_.part(weight + by.weight);
    if (c.empty() || !derived_[carrier].insert(weight).second) return;
    slopes_[carrier].set(weight,
                         by.angle ? domain_.angle_derivative(c, by.id) : domain_.derivative(c, by.id));
}

template class HomologicalEquation<RingDomain>;
template class HomologicalEquation<GraphDomain>;
template class HomologicalEquation<NumberDomain>;

} // namespace resonform
