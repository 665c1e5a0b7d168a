// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/walk.hpp"

#include "emit/program/reused_places.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace resonform {

namespace {

using Value = StraightLine::Value;
using Instruction = StraightLine::Instruction;
using Op = StraightLine::Op;

constexpr std::size_t base = 90;
constexpr std::size_t most_operands = base - 1;

// In the order of the walk's.
enum class Walked {
    sum,
    sum_and_number,
    product,
    scaled_product,
    reciprocal,
    root,
    function,
    end,
    long_number
};
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

char digit(std::size_t n) {
    std::size_t c = '#' + n;
    if (c >= '?') ++c;
    if (c >= '\\') ++c;
    return static_cast<char>(c);
}

std::vector<std::size_t> digits_of(std::size_t n, int count) {
    std::vector<std::size_t> digits(static_cast<std::size_t>(count));
    for (auto d = digits.rbegin(); d != digits.rend(); ++d, n /= base) *d = n % base;
    return digits;
}

std::string in_digits(std::size_t n, int digits) {
    std::string text;
    for (const std::size_t d : digits_of(n, digits)) text += digit(d);
    return text;
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

// First in symbols, for the number of digits depends on how many places there are.
class Walker {
public:
    Walker(const StraightLine& code, const std::vector<Value>& order, const std::set<Value>& known)
        : code_(code), order_(order), known_(known) {}

    std::optional<CppWalk> walk(const std::vector<Value>& roots) {
        if (!std::all_of(order_.begin(), order_.end(), [&](Value v) { return can_walk(v); }))
            return std::nullopt;
        find_last_uses(roots);
        for (const Value v : order_)
            if (is_input(v)) walk_.inputs.emplace_back(v, places_[v] = free_.take());
        for (std::size_t k = 0; k < order_.size(); ++k) {
            const Value v = order_[k];
            if (is_input(v) || (is_short_number(v) && last_use_[v] < order_.size())) continue;
            append(v);
            release(v, k);
        }
        for (const Value v : roots) walk_.place_of[v] = places_.at(v);
        walk_.places = free_.used();
        const std::size_t most = std::max(walk_.places, walk_.numbers.size());
        walk_.digits = most > base * base ? 3 : 2;
        if (most > base * base * base) return std::nullopt;
        write();
        return std::move(walk_);
    }

private:
    [[nodiscard]] bool is_number(Value v) const { return code_.at(v).op == Op::number; }
    [[nodiscard]] bool is_input(Value v) const {
        if (known_.contains(v) || code_.at(v).op == Op::doubled) return true;
        return is_number(v) && !is_short_number(v) && !LongNumber(code_.at(v).number).fits();
    }
    // A number that is written where it is used.
    [[nodiscard]] bool is_short_number(Value v) const {
        const Rational& n = code_.at(v).number;
        return is_number(v) && !known_.contains(v) && is_short(cln::numerator(n)) &&
               is_short(cln::denominator(n));
    }
    [[nodiscard]] bool can_walk(Value v) const { return known_.contains(v) || can_be_walked(code_.at(v)); }

    void find_last_uses(const std::vector<Value>& roots) {
        for (std::size_t k = 0; k < order_.size(); ++k)
            if (!is_input(order_[k]))
                for (const Value operand : code_.at(order_[k]).operands) last_use_[operand] = k;
        for (const Value v : roots) last_use_[v] = order_.size();
    }
    // The places of operands that nothing uses after step k.
    void release(Value v, std::size_t k) {
        std::set<Value> operands(code_.at(v).operands.begin(), code_.at(v).operands.end());
        for (const Value operand : operands)
            if (last_use_.at(operand) == k && places_.contains(operand)) free_.give_back(places_.at(operand));
    }
    void write() {
        constexpr std::size_t longest = 60000;
        std::string text;
        const auto end = [&] {
            walk_.texts.push_back(text + digit(static_cast<std::size_t>(Walked::end)));
            text.clear();
        };
        for (std::size_t k = 0; k < symbols_.size(); ++k) {
            if (text.size() > longest && begins_.contains(k)) end();
            const auto& [is_digit, n] = symbols_[k];
            text += is_digit ? std::string(1, digit(n)) : in_digits(n, walk_.digits);
        }
        end();
    }
    void put_digit(std::size_t n) { symbols_.emplace_back(true, n); }
    void put(Walked what) {
        begins_.insert(symbols_.size());
        put_digit(static_cast<std::size_t>(what));
    }
    void put_index(std::size_t n) { symbols_.emplace_back(false, n); }
    void put_number(const Rational& value) {
        const auto [known, fresh] = numbers_.try_emplace(value, walk_.numbers.size());
        if (fresh) walk_.numbers.push_back(value);
        put_index(known->second);
    }
    std::size_t place(Value v) {
        if (const auto known = places_.find(v); known != places_.end()) return known->second;
        const std::size_t place = places_[v] = free_.take(); // a number beside another one, or a long one
        const Rational& value = code_.at(v).number;
        is_short_number(v) ? put_sum(0, 0, &value, place) : put_long_number(LongNumber(value), place);
        return place;
    }
    void put_long_number(const LongNumber& number, std::size_t to) {
        const auto put_digits = [this](const Integer& n, int count) {
            for (const std::size_t d : digits_of(cln::cl_I_to_ulong(n), count)) put_digit(d);
        };
        put(Walked::long_number);
        put_index(to);
        put_digits(Integer(number.exponent()) + static_cast<long>(base * base / 2), 2);
        for (const Integer& mantissa : number.mantissas()) put_digits(mantissa + (Integer(1) << 53), 9);
    }
    void put_sum(std::size_t plus, std::size_t minus, const Rational* number, std::size_t to) {
        put(number != nullptr ? Walked::sum_and_number : Walked::sum);
        put_digit(plus);
        put_digit(minus);
        if (number != nullptr) put_number(*number);
        put_index(to);
    }

    void append(Value v) {
        const Instruction& i = code_.at(v);
        switch (i.op) {
        case Op::number: static_cast<void>(place(v)); return;
        case Op::add: return append_sum(v, i);
        case Op::multiply: return append_product(v, i);
        default: break;
        }
        std::vector<std::size_t> arguments;
        for (const Value operand : i.operands) arguments.push_back(place(operand));
        put(i.op == Op::reciprocal ? Walked::reciprocal : i.op == Op::root ? Walked::root : Walked::function);
        if (i.op == Op::root) put_digit(static_cast<std::size_t>(i.index));
        if (i.op == Op::function) {
            const auto which = static_cast<std::size_t>(
                std::find(walked_functions.begin(), walked_functions.end(), i.function) -
                walked_functions.begin());
            walk_.functions |= 1U << which;
            put_digit(which);
            put_digit(arguments.size());
        }
        put_index(places_[v] = free_.take());
        for (const std::size_t argument : arguments) put_index(argument);
    }

    // At most so many at a time; the sum so far is the first term of the rest.
    void append_sum(Value v, const Instruction& i) {
        const std::size_t positive = i.operands.size() - i.negative;
        std::optional<Rational> number;
        std::vector<std::size_t> plus, minus;
        for (std::size_t k = 0; k < i.operands.size(); ++k) {
            const Value w = i.operands[k];
            if (is_short_number(w) && !places_.contains(w) && !number)
                number = k < positive ? code_.at(w).number : -code_.at(w).number;
            else
                (k < positive ? plus : minus).push_back(place(w));
        }
        const std::size_t to = places_[v] = free_.take();
        while (!plus.empty() || !minus.empty() || number) {
            const std::size_t p = std::min(plus.size(), most_operands),
                              m = std::min(minus.size(), most_operands);
            put_sum(p, m, number ? &*number : nullptr, to);
            for (std::size_t k = 0; k < p; ++k) put_index(plus[k]);
            for (std::size_t k = 0; k < m; ++k) put_index(minus[k]);
            plus.erase(plus.begin(), plus.begin() + static_cast<std::ptrdiff_t>(p));
            minus.erase(minus.begin(), minus.begin() + static_cast<std::ptrdiff_t>(m));
            number.reset();
            if (!plus.empty() || !minus.empty()) plus.insert(plus.begin(), to);
        }
    }

    void append_product(Value v, const Instruction& i) {
        std::optional<Rational> number;
        std::vector<std::size_t> factors;
        for (const Value w : i.operands) {
            if (is_short_number(w) && !places_.contains(w) && !number)
                number = code_.at(w).number;
            else
                factors.push_back(place(w));
        }
        const std::size_t to = places_[v] = free_.take();
        while (!factors.empty()) {
            const std::size_t count = std::min(factors.size(), most_operands);
            put(number ? Walked::scaled_product : Walked::product);
            put_digit(count);
            if (number) put_number(*number);
            put_index(to);
            for (std::size_t k = 0; k < count; ++k) put_index(factors[k]);
            factors.erase(factors.begin(), factors.begin() + static_cast<std::ptrdiff_t>(count));
            number.reset();
            if (!factors.empty()) factors.insert(factors.begin(), to);
        }
    }

    const StraightLine& code_;
    const std::vector<Value>& order_;
    const std::set<Value>& known_;
    CppWalk walk_;
    std::map<Value, std::size_t> places_, last_use_;
    std::map<Rational, std::size_t> numbers_;
    ReusedPlaces free_;
    std::vector<std::pair<bool, std::size_t>> symbols_; // one digit, or several
    std::set<std::size_t> begins_;                      // of operations
};

} // namespace

bool is_short(const Integer& n) { return cln::abs(n) <= (Integer(1) << 48); }

bool can_be_walked(const Instruction& i) {
    if (i.op == Op::symbol || i.data != nullptr || !i.callable.empty()) return false;
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
                                const std::set<Value>& known, const std::vector<Value>& roots) {
    return Walker(code, order, known).walk(roots);
}

} // namespace resonform
