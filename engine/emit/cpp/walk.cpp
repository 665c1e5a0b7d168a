// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/walk.hpp"

#include "emit/cpp/digits.hpp"
#include "emit/program/reused_places.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace resonform {

namespace {

using Value = StraightLine::Value;
using Instruction = StraightLine::Instruction;
using Op = StraightLine::Op;

// As in runtime/walk.hpp.
constexpr std::size_t base = digit_base, number_digits = 8, most_added = 9, long_sum = 81, long_product = 89;
namespace mark {
constexpr std::size_t sum = 80, product = 81, two_factors = 82, reciprocal = 83, root = 84, function = 85,
                      long_number = 86, number = 87, end = 88;
}
constexpr std::size_t firsts = mark::sum;
constexpr std::array walked_functions{Graph::Op::sin,
                                      Graph::Op::cos,
                                      Graph::Op::log,
                                      Graph::Op::log1p,
                                      Graph::Op::exp,
                                      Graph::Op::expm1,
                                      Graph::Op::asinh,
                                      Graph::Op::sinh,
                                      Graph::Op::erf,
                                      Graph::Op::atan2,
                                      Graph::Op::sqrt_sum_squares};

std::size_t length_of(std::size_t n) {
    std::size_t length = 1;
    for (; n >= base; n /= base) ++length;
    return length;
}

// value = 2^exponent * sum of mantissas()[k]/2^(53 k) to as many bits as binary_parts() has. The first term
// is the double next to the value.
class LongNumber {
public:
    explicit LongNumber(const Rational& value)
        : exponent_(static_cast<long>(cln::integer_length(cln::abs(cln::numerator(value)))) -
                    static_cast<long>(cln::integer_length(cln::denominator(value))) - 53),
          scaled_(exponent_ < 0 ? value * (Integer(1) << -exponent_) : value / (Integer(1) << exponent_)) {
        if (cln::abs(scaled_) >= Integer(1) << 53) { // one bit too many
            scaled_ = scaled_ / 2;
            ++exponent_;
        }
    }
    [[nodiscard]] long exponent() const { return exponent_; }
    // Does the exponent fit two digits, of which half are for negative ones?
    [[nodiscard]] bool fits() const { return std::abs(exponent_) < static_cast<long>(base * base / 2); }
    // Each is the whole number next to what those before it leave.
    [[nodiscard]] std::array<Integer, 7> mantissas() const {
        std::array<Integer, 7> result;
        Rational rest = scaled_;
        for (Integer& mantissa : result) {
            mantissa = cln::round1(rest);
            rest = (rest - mantissa) * (Integer(1) << 53);
        }
        return result;
    }

private:
    long exponent_;
    Rational scaled_; // value/2^exponent, of 53 bits before its point
};

// Values that are used once stand where they are used, unless they would be nested too deep, and so do
// numbers of the list.
class Nesting {
public:
    Nesting(const StraightLine& code, const std::vector<Value>& walked, const std::vector<Value>& roots) {
        std::map<Value, std::size_t> uses, depth;
        for (const Value v : walked)
            for (const Value operand : code.at(v).operands) ++uses[operand];
        const std::set<Value> wanted(roots.begin(), roots.end());
        for (const Value v : walked) {
            std::size_t below = 0;
            for (const Value operand : code.at(v).operands)
                if (inner_.contains(operand)) below = std::max(below, depth[operand]);
            depth[v] = below + 1;
            const bool is_listed = code.at(v).op == Op::number && is_short(code.at(v).number);
            if (!wanted.contains(v) && (uses[v] == 1 || is_listed) && depth[v] < deepest) inner_.insert(v);
        }
    }
    [[nodiscard]] bool is_inner(Value v) const { return inner_.contains(v); }

private:
    static constexpr std::size_t deepest = 30;
    std::set<Value> inner_;
};

// First in symbols, for the number of digits depends on how many places there are.
class Walker {
public:
    Walker(const StraightLine& code, const std::vector<Value>& order, const std::set<Value>& known)
        : code_(code), order_(order), known_(known) {}

    std::optional<CppWalk> walk(const std::vector<Value>& roots, const std::vector<Value>& first) {
        if (!std::all_of(order_.begin(), order_.end(), [&](Value v) { return can_walk(v); }))
            return std::nullopt;
        std::vector<Value> walked;
        for (const Value v : order_)
            if (is_input(v))
                walk_.inputs.emplace_back(v, places_[v] = free_.take());
            else
                walked.push_back(v);
        const std::vector<Value> early = code_.behind_doubled(first, true);
        const auto end_of_first = std::stable_partition(walked.begin(), walked.end(), [&](Value v) {
            return std::binary_search(early.begin(), early.end(), v);
        });
        const auto first_steps = static_cast<std::size_t>(end_of_first - walked.begin());
        const Nesting nesting(code_, walked, roots);
        find_last_uses(walked, nesting, roots);
        for (std::size_t k = 0; k < walked.size(); ++k) {
            if (k == first_steps) first_symbols_ = symbols_.size();
            if (!nesting.is_inner(walked[k])) put_step(walked[k], k);
        }
        if (first_steps == walked.size()) first_symbols_ = symbols_.size();
        for (const Value v : roots) walk_.place_of[v] = places_.at(v);
        walk_.places = free_.used();
        const std::size_t most = std::max(walk_.places, numbers_.size());
        walk_.digits = most > firsts * base ? 3 : 2;
        if (most > firsts * base * base) return std::nullopt;
        write();
        return std::move(walk_);
    }

private:
    [[nodiscard]] bool is_input(Value v) const {
        if (known_.contains(v) || code_.at(v).op == Op::doubled) return true;
        const Instruction& i = code_.at(v);
        return i.op == Op::number && !is_short(i.number) && !LongNumber(i.number).fits();
    }
    [[nodiscard]] bool can_walk(Value v) const { return known_.contains(v) || can_be_walked(code_.at(v)); }

    // Steps are places in `walked`; that of an inner value is its user's.
    void find_last_uses(const std::vector<Value>& walked, const Nesting& nesting,
                        const std::vector<Value>& roots) {
        std::map<Value, std::size_t> step;
        for (std::size_t k = walked.size(); k-- > 0;) {
            const std::size_t own = nesting.is_inner(walked[k]) ? step.at(walked[k]) : k;
            for (const Value operand : code_.at(walked[k]).operands) {
                if (nesting.is_inner(operand)) step[operand] = own;
                std::size_t& last = last_use_[operand];
                last = std::max(last, own);
            }
        }
        for (const Value v : roots) last_use_.erase(v);
    }
    void write() {
        constexpr std::size_t longest = 60000;
        std::string text;
        const auto finish = [&] {
            walk_.texts.push_back(text + digit(mark::end));
            text.clear();
        };
        for (std::size_t k = 0; k < symbols_.size(); ++k) {
            const bool full = text.size() > longest && begins_.contains(k);
            if (full || (k == first_symbols_ && k > 0)) finish();
            if (k == first_symbols_) walk_.first_texts = walk_.texts.size();
            const auto& [is_digit, n] = symbols_[k];
            text += is_digit ? std::string(1, digit(n)) : in_digits(n, walk_.digits);
        }
        finish();
        if (first_symbols_ == symbols_.size()) walk_.first_texts = walk_.texts.size();
    }
    void put_digit(std::size_t n) { symbols_.emplace_back(true, n); }
    void put_digits(std::size_t n, std::size_t count) {
        for (const std::size_t d : digits_of(n, count)) put_digit(d);
    }
    void put_digits(const Integer& n, std::size_t count) { put_digits(cln::cl_I_to_ulong(n), count); }

    // What is used there for the last time leaves its place, which the value may take.
    void put_step(Value v, std::size_t step) {
        const std::size_t begin = symbols_.size();
        begins_.insert(begin);
        symbols_.emplace_back(false, 0);
        std::set<Value> gone;
        put_value(v, step, gone);
        for (const Value operand : gone) free_.give_back(places_.at(operand));
        symbols_[begin].second = places_[v] = free_.take();
    }
    // step: where this stands.
    void put_value(Value v, std::size_t step, std::set<Value>& gone) {
        const Instruction& i = code_.at(v);
        if (i.op == Op::number) return put_number(i.number);
        const std::size_t count = i.operands.size();
        switch (i.op) {
        case Op::add: put_sum(count - i.negative, i.negative); break;
        case Op::multiply: put_product(count); break;
        case Op::reciprocal: put_digit(mark::reciprocal); break;
        case Op::root:
            put_digit(mark::root);
            put_digit(static_cast<std::size_t>(i.index));
            break;
        default: put_function(i.function);
        }
        for (const Value operand : i.operands) {
            const auto known = places_.find(operand);
            if (known == places_.end()) {
                put_value(operand, step, gone);
                continue;
            }
            symbols_.emplace_back(false, known->second);
            if (const auto last = last_use_.find(operand); last != last_use_.end() && last->second == step)
                gone.insert(operand);
        }
    }
    void put_sum(std::size_t plus, std::size_t minus) {
        put_digit(mark::sum);
        const bool is_long = plus >= most_added || minus >= most_added;
        put_digit(is_long ? long_sum : most_added * plus + minus);
        if (!is_long) return;
        put_digits(plus, 2);
        put_digits(minus, 2);
    }
    void put_product(std::size_t count) {
        put_digit(count == 2 ? mark::two_factors : mark::product);
        if (count == 2) return;
        put_digit(std::min(count, long_product));
        if (count >= long_product) put_digits(count, 2);
    }
    void put_function(Graph::Op f) {
        const auto which = static_cast<std::size_t>(
            std::find(walked_functions.begin(), walked_functions.end(), f) - walked_functions.begin());
        walk_.functions |= 1U << which;
        put_digit(mark::function);
        put_digit(which);
    }
    void put_number(const Rational& value) {
        if (!is_short(value)) return put_long_number(LongNumber(value));
        put_digit(mark::number);
        const auto [known, fresh] = numbers_.try_emplace(value, numbers_.size());
        if (fresh) list(value);
        symbols_.emplace_back(false, known->second);
    }
    // How many digits each part has, |N| with its sign, D.
    void list(const Rational& value) {
        const Integer n = cln::numerator(value);
        const std::size_t over = 2 * cln::cl_I_to_ulong(cln::abs(n)) + (n < 0 ? 1 : 0),
                          under = cln::cl_I_to_ulong(cln::denominator(value));
        const std::size_t over_digits = length_of(over), under_digits = length_of(under);
        walk_.numbers += digit(number_digits * (over_digits - 1) + under_digits - 1);
        walk_.numbers += in_digits(over, over_digits) + in_digits(under, under_digits);
        walk_.count = numbers_.size();
    }
    void put_long_number(const LongNumber& value) {
        put_digit(mark::long_number);
        put_digits(Integer(value.exponent()) + static_cast<long>(base * base / 2), 2);
        for (const Integer& mantissa : value.mantissas()) put_digits(mantissa + (Integer(1) << 53), 9);
    }

    const StraightLine& code_;
    const std::vector<Value>& order_;
    const std::set<Value>& known_;
    CppWalk walk_;
    std::map<Value, std::size_t> places_;
    std::map<Value, std::size_t> last_use_; // a step; roots have none
    std::map<Rational, std::size_t> numbers_;
    ReusedPlaces free_;
    std::vector<std::pair<bool, std::size_t>> symbols_; // one digit, or those of a place
    std::set<std::size_t> begins_;                      // of steps
    std::size_t first_symbols_ = 0;                     // those of what comes first
};

} // namespace

bool is_short(const Rational& value) {
    const auto fits = [](const Integer& n) { return cln::abs(n) <= (Integer(1) << 48); };
    return fits(cln::numerator(value)) && fits(cln::denominator(value));
}

bool can_be_walked(const Instruction& i) {
    if (i.op == Op::symbol || i.data != nullptr || !i.callable.empty()) return false;
    if (i.operands.size() >= base * base) return false;
    if (i.op == Op::root) return static_cast<std::size_t>(i.index) < base;
    return i.op != Op::function ||
           std::find(walked_functions.begin(), walked_functions.end(), i.function) != walked_functions.end();
}

std::string CppWalk::list(const std::vector<Value>& values) const {
    std::string result;
    for (const Value v : values) result += in_digits(place_of.at(v), digits);
    return result;
}

std::optional<CppWalk> cpp_walk(const StraightLine& code, const std::vector<Value>& order,
                                const std::set<Value>& known, const std::vector<Value>& roots,
                                const std::vector<Value>& first) {
    return Walker(code, order, known).walk(roots, first);
}

} // namespace resonform
