// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_point.hpp"

#include <algorithm>
#include <cstdlib>
#include <future>
#include <thread>
#include <utility>

namespace resonform {

namespace {

// There are few.
template <class Key>
const std::vector<Residue>* find_in(const std::vector<std::pair<Key, std::vector<Residue>>>& list,
                                    const Key& key) {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == key; });
    return found == list.end() ? nullptr : &found->second;
}

} // namespace

// A series that a step needs on its way; its room is used again.
class PointRun::Scratch {
public:
    explicit Scratch(PointRun& run) : unused_(run.unused_) {
        if (unused_.empty()) {
            unused_.reserve(unused_.capacity() + 1); // to take it back
        } else {
            room_ = std::move(unused_.back());
            unused_.pop_back();
        }
        room_.assign(static_cast<std::size_t>(run.through_) + 1, 0);
    }
    ~Scratch() { unused_.push_back(std::move(room_)); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    Value value() { return {room_.data(), static_cast<int>(room_.size()), -1}; }

private:
    std::vector<std::vector<Residue>>& unused_;
    std::vector<Residue> room_;
};

PointReadings::PointReadings(const CertificatePlan& plan, const NormalForm& normal_form,
                             const NearIdentityMap& map, const std::vector<Point>& points, int through) {
    const Ring& ring = *normal_form.field->ring;
    std::size_t terms = 0;
    for (const CertificatePlan::Reading& reading : plan.readings) {
        const Series& from = series_of(reading.series, plan.program, normal_form, map);
        for (int weight = 0; weight <= std::min(through, from.through()); ++weight) {
            if (from.part(weight).empty()) continue;
            parts_.push_back({&reading, &from.part(weight).fractions()});
            terms += parts_.back().numbers->size();
            for (const auto& of : reading.sides) {
                if (of.value >= 0) coefficients_.push_back({of.value, weight, {}});
                for (const auto& [by, slot] : of.slopes)
                    coefficients_.push_back({slot, weight - ring.generator(by).weight, {}});
            }
        }
    }
    // Two threads take a share of the points each. They meet no number of CLN.
    constexpr std::size_t enough = std::size_t{1} << 15; // half a millisecond
    if (points.size() < 2 || terms * points.size() < enough || std::thread::hardware_concurrency() < 2) {
        read(ring, points, 0);
        return;
    }
    const std::span<const Point> all(points);
    const std::size_t half = points.size() / 2;
    std::future<void> other = std::async(std::launch::async, [&] { read(ring, all.subspan(half), half); });
    read(ring, all.first(half), 0);
    other.get();
}

// The first of them is number `first` of all.
void PointReadings::read(const Ring& ring, std::span<const Point> points, std::size_t first) {
    PointReader reader(ring, points);
    std::vector<PointReader::Wanted> wanted;
    const CertificatePlan::Reading* reading = nullptr;
    auto to = coefficients_.begin();
    const auto keep = [&](const auto& value) {
        for (std::size_t n = 0; n < points.size(); ++n) to->value[first + n] = value(n);
        ++to;
    };
    for (const Part& part : parts_) {
        if (part.reading != reading) {
            reading = part.reading;
            wanted.clear();
            for (const auto& of : reading->sides) {
                std::vector<GeneratorId> slopes;
                for (const auto& slope : of.slopes) slopes.push_back(slope.first);
                wanted.emplace_back(of.side, slopes);
            }
        }
        reader.read(*part.numbers, wanted);
        for (std::size_t side = 0; side < wanted.size(); ++side) {
            const PointReader::Wanted& w = wanted[side];
            if (reading->sides[side].value >= 0) keep([&](std::size_t n) { return w.value(n); });
            for (std::size_t k = 0; k < reading->sides[side].slopes.size(); ++k)
                keep([&](std::size_t n) { return w.slope(k, n); });
        }
    }
}

PointRun::PointRun(const CertificatePlan& plan, const Ring& ring, const PointReadings& readings,
                   std::size_t n, const Point& point, int through)
    : ring_(ring), montgomery_(point.field), generators_(point.values), through_(through),
      one_(montgomery_.enter(1)) {
    const std::vector<Step>& steps = plan.program.steps();
    const auto length = static_cast<std::size_t>(through_) + 1;
    offsets_.reserve(steps.size());
    slots_.reserve(steps.size());
    std::size_t room = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        offsets_.push_back(room);
        if (plan.needed[k]) room += length;
    }
    values_.assign(room + length, 0);
    for (const std::size_t offset : offsets_) slots_.push_back({values_.data() + offset, through_ + 1, -1});
    for (const PointReadings::Coefficient& read : readings.coefficients())
        set(slots_[static_cast<std::size_t>(read.slot)], read.weight, read.value[n]);
    for (std::size_t k = 0; k < steps.size(); ++k)
        if (plan.needed[k]) run(steps[k], slots_[k]);
}

void PointRun::run(const Step& step, Value& to) {
    const auto operand = [&](Slot slot) -> const Value& { return slots_[static_cast<std::size_t>(slot)]; };
    switch (step.operation) {
    case Operation::number: return set(to, 0, residue(step.number));
    case Operation::generator: {
        const int weight = ring_.generator(step.index).weight * step.power;
        if (weight < 0 || weight > through_) return;
        return set(to, weight,
                   power(montgomery_.enter(generators_[static_cast<std::size_t>(step.index)]), step.power));
    }
    case Operation::add: return add(to, operand(step.left), operand(step.right));
    case Operation::multiply: return multiply(to, operand(step.left), operand(step.right), through_);
    case Operation::function: return function(to, static_cast<Elementary>(step.index), operand(step.left));
    case Operation::power: return power(to, operand(step.left), step.number, operand(step.right));
    case Operation::inverse_power: return inverse_power(to, operand(step.left), step.index);
    case Operation::at_origin: return set(to, 0, operand(step.left).at[0]);
    case Operation::value:
    case Operation::slope: return; // read before
    }
}

void PointRun::set(Value& to, int weight, Residue coefficient) const {
    if (coefficient == 0 || weight < 0) return;
    to.at[weight] = coefficient;
    to.first = std::min(to.first, weight);
    to.last = std::max(to.last, weight);
}

void PointRun::add(Value& to, const Value& a, const Value& b) const {
    to.first = std::min(a.first, b.first);
    to.last = std::max(a.last, b.last);
    for (int n = to.first; n <= to.last; ++n) to.at[n] = montgomery_.add(a.at[n], b.at[n]);
}

void PointRun::multiply(Value& to, const Value& a, const Value& b, int last) const {
    if (a.first > a.last || b.first > b.last) return;
    to.first = std::min(a.first + b.first, through_ + 1);
    to.last = std::min(a.last + b.last, last);
    for (int n = to.first; n <= to.last; ++n) {
        Montgomery::Wide sum = 0;
        for (int j = std::max(a.first, n - b.last); j <= std::min(a.last, n - b.first); ++j)
            montgomery_.accumulate(sum, a.at[j], b.at[n - j]);
        to.at[n] = montgomery_.reduce(sum);
    }
}

void PointRun::taylor(Value& to, const std::vector<Residue>& coefficients, const Value& u) {
    if (u.first > u.last) return set(to, 0, coefficients.front());
    const int terms = through_ / u.first; // u^k begins at weight k u.first
    const int used = std::min(terms, static_cast<int>(coefficients.size()) - 1);
    Scratch one(*this), other(*this);
    Value sum = one.value(), next = other.value();
    set(sum, 0, coefficients[static_cast<std::size_t>(used)]);
    for (int k = used; k-- > 0;) { // it is multiplied with u^k still
        std::fill_n(next.at, through_ + 1, 0);
        next.first = through_ + 1;
        next.last = -1;
        multiply(next, sum, u, through_ - k * u.first);
        set(next, 0, coefficients[static_cast<std::size_t>(k)]);
        std::swap(sum, next);
    }
    for (int n = sum.first; n <= sum.last; ++n) set(to, n, sum.at[n]);
}

void PointRun::function(Value& to, Elementary function, const Value& u) {
    if (function == Elementary::tangent || function == Elementary::hyperbolic_tangent) {
        const bool circular = function == Elementary::tangent;
        Scratch above(*this), below(*this), inverse(*this);
        Value sine = above.value(), cosine = below.value(), quotient = inverse.value();
        this->function(sine, circular ? Elementary::sine : Elementary::hyperbolic_sine, u);
        this->function(cosine, circular ? Elementary::cosine : Elementary::hyperbolic_cosine, u);
        inverse_power(quotient, cosine, 1);
        return multiply(to, sine, quotient, through_);
    }
    if (u.at[0] != (function == Elementary::logarithm ? one_ : 0))
        refuse({"a Taylor sum is taken where its argument vanishes at the origin (is 1 for log)",
                "weight 0 of an argument",
                "write the argument so that its value at the origin is plain",
                {}});
    taylor(to, taylor_coefficients(function), {u.at, std::max(u.first, 1), u.last});
}

void PointRun::power(Value& to, const Value& a, const Rational& exponent, const Value& lead) {
    Scratch quotient(*this), sum(*this);
    Value ratio = quotient.value(), total = sum.value();
    const Residue below = inverse(a.at[0]);
    for (int n = 1; n <= a.last; ++n) set(ratio, n, montgomery_.multiply(below, a.at[n]));
    taylor(total, binomial(exponent), ratio);
    multiply(to, lead, total, through_);
}

void PointRun::inverse_power(Value& to, const Value& a, int n) {
    Scratch number(*this);
    Value lead = number.value();
    set(lead, 0, power(inverse(a.at[0]), n));
    power(to, a, -n, lead);
}

Residue PointRun::residue(const Rational& value) const {
    const std::optional<Residue> r = montgomery_.field().from(value);
    if (!r) throw UnluckyPoint();
    return montgomery_.enter(*r);
}

Residue PointRun::inverse(Residue a) {
    if (a == 0) throw UnluckyPoint();
    const auto [known, is_new] = quotients_.try_emplace(a);
    if (is_new) known->second = montgomery_.inverse(a);
    return known->second;
}

Residue PointRun::power(Residue a, int exponent) {
    return montgomery_.power(exponent < 0 ? inverse(a) : a, static_cast<std::uint64_t>(std::abs(exponent)));
}

// p = q k + r: 1/k = -q/r
Residue PointRun::inverse_of(int k) {
    if (inverses_.empty()) inverses_ = {0, one_};
    const std::uint64_t prime = montgomery_.field().prime();
    while (inverses_.size() <= static_cast<std::size_t>(k)) {
        const std::uint64_t next = inverses_.size();
        const Residue quotient = montgomery_.enter(prime / next);
        inverses_.push_back(montgomery_.negate(montgomery_.multiply(quotient, inverses_[prime % next])));
    }
    return inverses_[static_cast<std::size_t>(k)];
}

const std::vector<Residue>& PointRun::binomial(const Rational& exponent) {
    if (const auto* known = find_in(binomials_, exponent)) return *known;
    std::vector<Residue>& c = binomials_.emplace_back(exponent, std::vector<Residue>{one_}).second;
    c.reserve(static_cast<std::size_t>(through_) + 1);
    Residue factor = residue(exponent); // exponent - (k - 1)
    for (int k = 1; k <= through_; ++k) {
        c.push_back(montgomery_.multiply(c.back(), montgomery_.multiply(factor, inverse_of(k))));
        factor = montgomery_.subtract(factor, one_);
    }
    return c;
}

const std::vector<Residue>& PointRun::taylor_coefficients(Elementary function) {
    if (const auto* known = find_in(taylor_, function)) return *known;
    std::vector<Residue>& c = taylor_.emplace_back(function, std::vector<Residue>{}).second;
    c.reserve(static_cast<std::size_t>(through_) + 1);
    const bool alternating =
        function == Elementary::sine || function == Elementary::cosine || function == Elementary::arc_tangent;
    Residue factorial = one_, central = one_; // 1/k!, and binomial(2j, j)/4^j with j = (k - 1)/2
    for (int k = 0; k <= through_; ++k) {
        const bool odd = k % 2 != 0;
        if (k > 0) factorial = montgomery_.multiply(factorial, inverse_of(k));
        if (odd && k > 1) // (k - 2)/(k - 1) = 1 - 1/(k - 1)
            central = montgomery_.multiply(central, montgomery_.subtract(one_, inverse_of(k - 1)));
        Residue value = 0;
        switch (function) {
        case Elementary::exponential: value = factorial; break;
        case Elementary::sine:
        case Elementary::hyperbolic_sine: value = odd ? factorial : 0; break;
        case Elementary::cosine:
        case Elementary::hyperbolic_cosine: value = odd ? 0 : factorial; break;
        case Elementary::arc_tangent: value = odd ? inverse_of(k) : 0; break;
        case Elementary::arc_sine: value = odd ? montgomery_.multiply(central, inverse_of(k)) : 0; break;
        case Elementary::logarithm:
            if (k > 0) value = odd ? inverse_of(k) : montgomery_.negate(inverse_of(k));
            break;
        case Elementary::tangent:
        case Elementary::hyperbolic_tangent: break; // quotients, see function()
        }
        c.push_back(alternating && k % 4 >= 2 ? montgomery_.negate(value) : value);
    }
    return c;
}

} // namespace resonform
