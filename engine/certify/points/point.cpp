// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/points/point.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/taylor_law.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace resonform {

namespace {

// A linear search: the lists are short.
template <class Key, class Entry>
const Entry* find_in(const std::vector<std::pair<Key, Entry>>& list, const Key& key) {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == key; });
    return found == list.end() ? nullptr : &found->second;
}

} // namespace

// A temporary series of a step; its memory is reused.
class PointRun::Scratch {
public:
    explicit Scratch(PointRun& run) : unused_(run.unused_) {
        if (unused_.empty()) {
            unused_.reserve(unused_.capacity() + 1); // the destructor must not allocate
        } else {
            room_ = std::move(unused_.back());
            unused_.pop_back();
        }
        room_.assign(static_cast<std::size_t>(run.through_) + 1, {});
    }
    ~Scratch() { unused_.push_back(std::move(room_)); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    Value value() { return {room_.data(), static_cast<int>(room_.size()), -1}; }

private:
    std::vector<std::vector<Lanes>>& unused_;
    std::vector<Lanes> room_;
};

PointRun::PointRun(const CertificatePlan& plan, const Ring& ring, const PointReadings& readings,
                   const std::vector<Point>& points, int through)
    : ring_(ring), points_(points), through_(through) {
    arithmetic_.reserve(points.size());
    for (const Point& point : points) arithmetic_.emplace_back(point.field);
    one_ = by_point([](const Montgomery& m, std::size_t) { return m.enter(1); });
    const std::vector<Instruction>& steps = plan.program.steps();
    const auto length = static_cast<std::size_t>(through_) + 1;
    offsets_.reserve(steps.size());
    slots_.reserve(steps.size());
    std::size_t room = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        offsets_.push_back(room);
        if (plan.needed[k]) room += length;
    }
    values_.assign(room + length, {});
    for (const std::size_t offset : offsets_) slots_.push_back({values_.data() + offset, through_ + 1, -1});
    for (const PointReadings::Coefficient& read : readings.coefficients())
        set(slots_[static_cast<std::size_t>(read.slot)], read.weight, read.value);
    for (std::size_t k = 0; k < steps.size(); ++k)
        if (plan.needed[k]) run(steps[k], slots_[k]);
}

auto PointRun::product(const Lanes& a, const Lanes& b) const -> Lanes {
    return by_point([&](const Montgomery& m, std::size_t n) { return m.multiply(a[n], b[n]); });
}

void PointRun::run(const Instruction& step, Value& to) {
    const auto operand = [&](Slot slot) -> const Value& { return slots_[static_cast<std::size_t>(slot)]; };
    switch (step.operation) {
    case Operation::number: return set(to, 0, residues(step.number));
    case Operation::generator: {
        const int weight = ring_.generator(step.index).weight * step.power;
        if (weight < 0 || weight > through_) return;
        const auto id = static_cast<std::size_t>(step.index);
        const Lanes value =
            by_point([&](const Montgomery& m, std::size_t n) { return m.enter(points_[n].values[id]); });
        return set(to, weight, power(value, step.power));
    }
    case Operation::add: return add(to, operand(step.left), operand(step.right));
    case Operation::multiply: return multiply(to, operand(step.left), operand(step.right), through_);
    case Operation::function: return function(to, static_cast<Function>(step.index), operand(step.left));
    case Operation::power: return power(to, operand(step.left), step.number, operand(step.right));
    case Operation::inverse_power: return inverse_power(to, operand(step.left), step.index);
    case Operation::integral: return integral(to, operand(step.left), operand(step.right));
    case Operation::at_origin: return set(to, 0, operand(step.left).at[0]);
    case Operation::value:
    case Operation::slope: return; // already read
    }
}

void PointRun::set(Value& to, int weight, const Lanes& coefficient) const {
    Residue any = 0;
    for (const Residue c : coefficient) any |= c;
    if (any == 0 || weight < 0) return;
    to.at[weight] = coefficient;
    to.first = std::min(to.first, weight);
    to.last = std::max(to.last, weight);
}

void PointRun::add(Value& to, const Value& a, const Value& b) const {
    to.first = std::min(a.first, b.first);
    to.last = std::max(a.last, b.last);
    for (int k = to.first; k <= to.last; ++k)
        to.at[k] =
            by_point([&](const Montgomery& m, std::size_t n) { return m.add(a.at[k][n], b.at[k][n]); });
}

void PointRun::multiply(Value& to, const Value& a, const Value& b, int last) const {
    if (a.first > a.last || b.first > b.last) return;
    to.first = std::min(a.first + b.first, through_ + 1);
    to.last = std::min(a.last + b.last, last);
    for (int k = to.first; k <= to.last; ++k) {
        std::array<Montgomery::Wide, PointReader::most_points> sums{};
        for (int j = std::max(a.first, k - b.last); j <= std::min(a.last, k - b.first); ++j)
            for (std::size_t n = 0; n < arithmetic_.size(); ++n)
                arithmetic_[n].accumulate(sums[n], a.at[j][n], b.at[k - j][n]);
        to.at[k] = by_point([&](const Montgomery& m, std::size_t n) { return m.reduce(sums[n]); });
    }
}

void PointRun::taylor(Value& to, const std::vector<Lanes>& coefficients, const Value& u) {
    if (u.first > u.last) return set(to, 0, coefficients.front());
    const int terms = through_ / u.first; // u^k begins at weight k u.first
    const int used = std::min(terms, static_cast<int>(coefficients.size()) - 1);
    Scratch one(*this), other(*this);
    Value sum = one.value(), next = other.value();
    set(sum, 0, coefficients[static_cast<std::size_t>(used)]);
    for (int k = used; k-- > 0;) { // later steps multiply `sum` by u^k
        std::fill_n(next.at, through_ + 1, Lanes{});
        next.first = through_ + 1;
        next.last = -1;
        multiply(next, sum, u, through_ - k * u.first);
        set(next, 0, coefficients[static_cast<std::size_t>(k)]);
        std::swap(sum, next);
    }
    for (int k = sum.first; k <= sum.last; ++k) set(to, k, sum.at[k]);
}

void PointRun::function(Value& to, Function function, const Value& u) {
    if (function == Function::tangent || function == Function::hyperbolic_tangent) {
        const bool circular = function == Function::tangent;
        Scratch above(*this), below(*this), inverse(*this);
        Value sine = above.value(), cosine = below.value(), quotient = inverse.value();
        this->function(sine, circular ? Function::sine : Function::hyperbolic_sine, u);
        this->function(cosine, circular ? Function::cosine : Function::hyperbolic_cosine, u);
        inverse_power(quotient, cosine, 1);
        return multiply(to, sine, quotient, through_);
    }
    if (u.at[0] != (function == Function::logarithm ? one_ : Lanes{}))
        refuse({"a Taylor sum is taken where its argument vanishes at the origin (is 1 for log)",
                "weight 0 of an argument",
                "write the argument so that its value at the origin is plain",
                {}});
    taylor(to, taylor_coefficients(function), {u.at, std::max(u.first, 1), u.last});
}

void PointRun::power(Value& to, const Value& a, const Rational& exponent, const Value& lead) {
    Scratch quotient(*this), sum(*this);
    Value ratio = quotient.value(), total = sum.value();
    const Lanes below = inverse(a.at[0]);
    for (int k = 1; k <= a.last; ++k) set(ratio, k, product(below, a.at[k]));
    taylor(total, binomial(exponent), ratio);
    multiply(to, lead, total, through_);
}

void PointRun::inverse_power(Value& to, const Value& a, int n) {
    Scratch number(*this);
    Value lead = number.value();
    set(lead, 0, power(inverse(a.at[0]), n));
    power(to, a, -n, lead);
}

void PointRun::integral(Value& to, const Value& u, const Value& slope) {
    Scratch weighted(*this), sum(*this);
    Value moving = weighted.value(), product_of_both = sum.value();
    for (int k = std::max(u.first, 1); k <= u.last; ++k) set(moving, k, product(u.at[k], residues(k)));
    multiply(product_of_both, moving, slope, through_);
    for (int k = product_of_both.first; k <= product_of_both.last; ++k)
        set(to, k, product(product_of_both.at[k], inverse_of(k)));
}

auto PointRun::residues(const Rational& value) const -> Lanes {
    return by_point([&](const Montgomery& m, std::size_t) {
        const std::optional<Residue> r = m.field().from(value);
        if (!r) throw UnluckyPoint();
        return m.enter(*r);
    });
}

auto PointRun::inverse(const Lanes& a) -> Lanes {
    if (const Lanes* known = find_in(quotients_, a)) return *known;
    const Lanes below = by_point([&](const Montgomery& m, std::size_t n) {
        if (a[n] == 0) throw UnluckyPoint();
        return m.inverse(a[n]);
    });
    quotients_.emplace_back(a, below);
    return below;
}

auto PointRun::power(const Lanes& a, int exponent) -> Lanes {
    const Lanes base = exponent < 0 ? inverse(a) : a;
    return by_point([&](const Montgomery& m, std::size_t n) {
        return m.power(base[n], static_cast<std::uint64_t>(std::abs(exponent)));
    });
}

// p = q k + r: 1/k = -q/r
auto PointRun::inverse_of(int k) -> const Lanes& {
    if (inverses_.empty()) inverses_ = {Lanes{}, one_};
    while (inverses_.size() <= static_cast<std::size_t>(k)) {
        const std::uint64_t next = inverses_.size();
        inverses_.push_back(by_point([&](const Montgomery& m, std::size_t n) {
            const std::uint64_t prime = m.field().prime();
            return m.negate(m.multiply(m.enter(prime / next), inverses_[prime % next][n]));
        }));
    }
    return inverses_[static_cast<std::size_t>(k)];
}

auto PointRun::binomial(const Rational& exponent) -> const std::vector<Lanes>& {
    if (const auto* known = find_in(binomials_, exponent)) return *known;
    std::vector<Lanes>& c = binomials_.emplace_back(exponent, std::vector<Lanes>{one_}).second;
    c.reserve(static_cast<std::size_t>(through_) + 1);
    Lanes factor = residues(exponent); // exponent - (k - 1)
    for (int k = 1; k <= through_; ++k) {
        c.push_back(product(c.back(), product(factor, inverse_of(k))));
        factor = by_point([&](const Montgomery& m, std::size_t n) { return m.subtract(factor[n], one_[n]); });
    }
    return c;
}

auto PointRun::taylor_coefficients(Function function) -> const std::vector<Lanes>& {
    if (const auto* known = find_in(taylor_, function)) return *known;
    std::vector<Lanes>& c = taylor_.emplace_back(function, std::vector<Lanes>{}).second;
    c.reserve(static_cast<std::size_t>(through_) + 1);
    const TaylorLaw law = taylor_law(function);
    const auto negative = [&](const Lanes& a) {
        return by_point([&](const Montgomery& m, std::size_t n) { return m.negate(a[n]); });
    };
    Lanes factorial = one_, central = one_; // 1/k!, and binomial(2j, j)/4^j with j = (k - 1)/2
    for (int k = 0; k <= through_; ++k) {
        const bool odd = k % 2 != 0;
        if (k > 0) factorial = product(factorial, inverse_of(k));
        if (odd && k > 1) { // (k - 2)/(k - 1) = 1 - 1/(k - 1)
            const Lanes& below = inverse_of(k - 1);
            central = product(central, by_point([&](const Montgomery& m, std::size_t n) {
                                  return m.subtract(one_[n], below[n]);
                              }));
        }
        Lanes value{};
        if (law.has(k))
            value = law.kind == TaylorLaw::factorial    ? factorial
                    : law.kind == TaylorLaw::reciprocal ? inverse_of(k)
                                                        : product(central, inverse_of(k));
        c.push_back(law.negative(k) ? negative(value) : value);
    }
    return c;
}

} // namespace resonform
