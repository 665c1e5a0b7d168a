// SPDX-License-Identifier: GPL-3.0-or-later
// A program at a point, over truncated series in a grading variable t: a generator of weight k becomes
// value * t^k, so that weights are read off as powers of t.
#pragma once

#include "certify/points/readings.hpp"

#include <array>
#include <utility>
#include <vector>

namespace resonform {

// Runs a program at the points of some readings, side by side. Residues are held in Montgomery's form, so
// that only zeros can be read off.
class PointRun {
public:
    // Series are known through their weight `through`. Throws UnluckyPoint. Errors (refused): a Taylor sum
    // whose argument does not vanish at the origin.
    PointRun(const CertificatePlan& plan, const Ring& ring, const PointReadings& readings,
             const std::vector<Point>& points, int through);

    // The coefficient of t^weight at the n-th point, weight <= through.
    [[nodiscard]] Residue operator()(Slot slot, int weight, std::size_t n) const {
        const std::size_t offset = offsets_[static_cast<std::size_t>(slot)];
        return values_[offset + static_cast<std::size_t>(weight)][n];
    }
    // The coefficients of t^0, as residues.
    [[nodiscard]] std::vector<Residue> at_origin(const std::vector<Slot>& slots, std::size_t n) const {
        std::vector<Residue> values;
        values.reserve(slots.size());
        for (const Slot slot : slots) values.push_back(at_origin(slot, n));
        return values;
    }
    [[nodiscard]] Residue at_origin(Slot slot, std::size_t n) const {
        return arithmetic_[n].leave((*this)(slot, 0, n));
    }

private:
    using Lanes = std::array<Residue, PointReader::most_points>; // by point; 0 beyond the last
    // A span of through + 1 coefficients, of which those outside of first ... last are zero.
    struct Value {
        Lanes* at;
        int first, last;
    };
    class Scratch;

    template <class Function> [[nodiscard]] Lanes by_point(Function function) const {
        Lanes result{};
        for (std::size_t n = 0; n < arithmetic_.size(); ++n) result[n] = function(arithmetic_[n], n);
        return result;
    }
    [[nodiscard]] Lanes product(const Lanes& a, const Lanes& b) const;

    void run(const Instruction& step, Value& to);
    void set(Value& to, int weight, const Lanes& coefficient) const;
    void add(Value& to, const Value& a, const Value& b) const;
    // Through weight `last`.
    void multiply(Value& to, const Value& a, const Value& b, int last) const;
    // sum_k coefficients[k] u^k with u_0 = 0, by Horner's rule.
    void taylor(Value& to, const std::vector<Lanes>& coefficients, const Value& u);
    void integral(Value& to, const Value& u, const Value& slope);
    void function(Value& to, Function function, const Value& u);
    void power(Value& to, const Value& a, const Rational& exponent, const Value& lead);
    void inverse_power(Value& to, const Value& a, int n);

    [[nodiscard]] Lanes residues(const Rational& value) const;
    [[nodiscard]] Lanes inverse(const Lanes& a); // throws UnluckyPoint
    [[nodiscard]] Lanes power(const Lanes& a, int exponent);
    [[nodiscard]] const Lanes& inverse_of(int k); // 1/k for 1 <= k
    // The Taylor coefficients of (1 + u)^exponent; the reference is valid until the next call.
    [[nodiscard]] const std::vector<Lanes>& binomial(const Rational& exponent);
    // Those of a function, likewise.
    [[nodiscard]] const std::vector<Lanes>& taylor_coefficients(Function function);

    const Ring& ring_;
    const std::vector<Point>& points_;
    std::vector<Montgomery> arithmetic_;
    int through_;
    Lanes one_;
    std::vector<Lanes> inverses_;                    // of 1, 2, ...
    std::vector<std::pair<Lanes, Lanes>> quotients_; // a and 1/a, of all a inverted so far
    std::vector<std::pair<Rational, std::vector<Lanes>>> binomials_;
    std::vector<std::pair<Function, std::vector<Lanes>>> taylor_;
    std::vector<std::vector<Lanes>> unused_; // memory for temporary series
    std::vector<std::size_t> offsets_;
    std::vector<Lanes> values_;
    std::vector<Value> slots_;
};

} // namespace resonform
