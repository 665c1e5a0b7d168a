// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/constant_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace resonform {

namespace {

using Value = StraightLine::Value;

constexpr double furthest = 900;         // binary exponents of double, less the digits of doubled precision
constexpr double least_bound = 100;      // 1e30
constexpr double digits_cancelled = 110; // binary digits that a sum in doubled precision may lose
constexpr double nearest_to_zero = 128;  // of sin, cos, log, at arguments that have so many digits
constexpr double infinite = std::numeric_limits<double>::infinity();

// A binary logarithm, at most slope * bound + offset; neither is negative.
struct Logarithm {
    double slope = 0, offset = 0;
};
Logarithm operator+(const Logarithm& a, const Logarithm& b) {
    return {a.slope + b.slope, a.offset + b.offset};
}
Logarithm larger(const Logarithm& a, const Logarithm& b) {
    return {std::max(a.slope, b.slope), std::max(a.offset, b.offset)};
}

// 2^-below <= |x| <= 2^above, unless x = 0
struct Size {
    Logarithm above, below;
};

Size size_of_number(const Rational& value) {
    if (value == 0) return {};
    const double n = static_cast<double>(cln::integer_length(cln::numerator(value))),
                 d = static_cast<double>(cln::integer_length(cln::denominator(value)));
    const double parts = n > 48 || d > 48 ? 0 : std::max(n, d); // p and q themselves, where they are written
    return {{0, std::max(parts, n - d + 1)}, {0, std::max(0.0, d - n + 1)}};
}

Size size_of_function(Graph::Op op, const std::vector<Size>& x) {
    switch (op) {
    case Graph::Op::cos: return {{}, {0, nearest_to_zero}};
    case Graph::Op::sin: return {{}, larger(x[0].below, {0, nearest_to_zero})};
    case Graph::Op::log: return {{0, 16}, {0, nearest_to_zero}};
    case Graph::Op::asinh: return {x[0].above, larger(x[0].below, {0, 1})};
    case Graph::Op::erf: return {{0, 1}, larger(x[0].below, {0, 1})};
    case Graph::Op::atan2: return {{0, 2}, larger(x[0].below + x[1].above, {0, 1})};
    case Graph::Op::sqrt_sum_squares: // both are squared
        return {{2 * larger(x[0].above, x[1].above).slope, 2 * larger(x[0].above, x[1].above).offset + 1},
                {2 * larger(x[0].below, x[1].below).slope, 2 * larger(x[0].below, x[1].below).offset}};
    default: return {{0, infinite}, {0, infinite}};
    }
}

Size size_of(const StraightLine::Instruction& i, const std::vector<Size>& x) {
    Size result;
    switch (i.op) {
    case StraightLine::Op::number: return size_of_number(i.number);
    case StraightLine::Op::symbol: return {{1, 0}, {1, 0}};
    case StraightLine::Op::add:
        for (const Size& term : x)
            result = {larger(result.above, term.above), larger(result.below, term.below)};
        result.above.offset += std::log2(static_cast<double>(x.size()));
        result.below.offset += digits_cancelled;
        return result;
    case StraightLine::Op::multiply:
        for (const Size& factor : x) result = {result.above + factor.above, result.below + factor.below};
        return result;
    case StraightLine::Op::reciprocal: return {x[0].below, x[0].above};
    case StraightLine::Op::doubled:
    case StraightLine::Op::root: return x[0]; // less, but for Newton's step
    default: return size_of_function(i.function, x);
    }
}

// The largest bound for which a logarithm stays in range.
double bound_of(const Logarithm& x) {
    if (x.offset > furthest) return 0;
    return x.slope > 0 ? (furthest - x.offset) / x.slope : infinite;
}

} // namespace

ConstantRange constant_range(const StraightLine& code, const std::vector<Value>& constants) {
    std::vector<Size> sizes(code.size());
    std::set<Graph::Node> limited;
    double bound = furthest;
    for (const Value v : code.behind(constants, true)) {
        const StraightLine::Instruction& i = code.at(v);
        std::vector<Size> x;
        for (const Value operand : i.operands) {
            x.push_back(sizes[static_cast<std::size_t>(operand)]);
            if (code.at(operand).op == StraightLine::Op::symbol) limited.insert(code.at(operand).symbol);
        }
        const Size size = sizes[static_cast<std::size_t>(v)] = size_of(i, x);
        bound = std::min({bound, bound_of(size.above), bound_of(size.below)});
    }
    return {bound >= least_bound, static_cast<int>(bound), {limited.begin(), limited.end()}};
}

} // namespace resonform
