// SPDX-License-Identifier: GPL-3.0-or-later
// A program at a point, over truncated series in a grading variable t: a generator of weight k becomes
// value * t^k, so that weights are read off as powers of t.
#pragma once

#include "normalize/certificate_plan.hpp"
#include "normalize/certificate_reader.hpp"

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace resonform {

// The series that a program reads, at some points, by one pass over their terms.
class PointReadings {
public:
    // Through weight `through`. Throws UnluckyPoint. Points: 1 ... PointReader::most_points.
    PointReadings(const CertificatePlan& plan, const NormalForm& normal_form, const NearIdentityMap& map,
                  const std::vector<Point>& points, int through);

    // The coefficient of t^weight by point, in Montgomery's form.
    struct Coefficient {
        Slot slot;
        int weight;
        std::array<Residue, PointReader::most_points> value;
    };
    [[nodiscard]] const std::vector<Coefficient>& coefficients() const { return coefficients_; }

private:
    struct Part {
        const CertificatePlan::Reading* reading;
        const Fractions* numbers;
    };

    void read(const Ring& ring, std::span<const Point> points, std::size_t first);

    std::vector<Part> parts_;
    std::vector<Coefficient> coefficients_; // of the parts, one after the other
};

// Runs a program at a point. Residues are held in Montgomery's form, so that only zeros can be read off.
class PointRun {
public:
    // At the n-th of the points of the readings; series are known through their weight `through`. Throws
    // UnluckyPoint. Errors (refused): a Taylor sum whose argument does not vanish at the origin.
    PointRun(const CertificatePlan& plan, const Ring& ring, const PointReadings& readings, std::size_t n,
             const Point& point, int through);

    // The coefficients of t^0 ... t^through.
    [[nodiscard]] const Residue* operator()(Slot slot) const {
        return values_.data() + offsets_[static_cast<std::size_t>(slot)];
    }
    // The coefficient of t^0, as a residue.
    [[nodiscard]] Residue at_origin(Slot slot) const { return montgomery_.leave((*this)(slot)[0]); }

private:
    // A span of through + 1 coefficients, of which those outside of first ... last are zero.
    struct Value {
        Residue* at;
        int first, last;
    };
    class Scratch;

    void run(const Step& step, Value& to);
    void set(Value& to, int weight, Residue coefficient) const;
    void add(Value& to, const Value& a, const Value& b) const;
    // Through weight `last`.
    void multiply(Value& to, const Value& a, const Value& b, int last) const;
    // sum_k coefficients[k] u^k with u_0 = 0, by Horner's rule.
    void taylor(Value& to, const std::vector<Residue>& coefficients, const Value& u);
    void function(Value& to, Elementary function, const Value& u);
    void power(Value& to, const Value& a, const Rational& exponent, const Value& lead);
    void inverse_power(Value& to, const Value& a, int n);

    [[nodiscard]] Residue residue(const Rational& value) const;
    [[nodiscard]] Residue inverse(Residue a); // throws UnluckyPoint
    [[nodiscard]] Residue power(Residue a, int exponent);
    [[nodiscard]] Residue inverse_of(int k); // 1/k for 1 <= k
    // Of (1 + u)^exponent. What is returned stays until the next call.
    [[nodiscard]] const std::vector<Residue>& binomial(const Rational& exponent);
    // The same.
    [[nodiscard]] const std::vector<Residue>& taylor_coefficients(Elementary function);

    const Ring& ring_;
    Montgomery montgomery_;
    const std::vector<Residue>& generators_;
    int through_;
    Residue one_;
    std::vector<Residue> inverses_;        // of 1, 2, ...
    std::map<Residue, Residue> quotients_; // inverses of what powers are taken of, often of the same
    std::vector<std::pair<Rational, std::vector<Residue>>> binomials_;
    std::vector<std::pair<Elementary, std::vector<Residue>>> taylor_;
    std::vector<std::vector<Residue>> unused_; // room of series that were needed on the way
    std::vector<std::size_t> offsets_;
    std::vector<Residue> values_;
    std::vector<Value> slots_;
};

} // namespace resonform
