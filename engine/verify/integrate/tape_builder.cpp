// SPDX-License-Identifier: GPL-3.0-or-later
// GiNaC expressions -> Tape. Operands of sums and products are taken in the order of a spelling of our own
// (spelling.hpp), and sums with the sign that it gives them, because GiNaC's choices change from run to run
// and with them the rounding.
#include "verify/integrate/tape.hpp"

#include "algebra/number/error.hpp"
#include "model/text/function_call.hpp"
#include "model/text/function_slope.hpp"
#include "model/text/named_function.hpp"
#include "verify/integrate/spelling.hpp"
#include "verify/run/real.hpp"

#include <cln/cln.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace resonform {

namespace {

using Op = Tape::Op;

cln::cl_RA exact(const GiNaC::numeric& n) { return cln::the<cln::cl_RA>(n.to_cl_N()); }

bool is_rational(const GiNaC::ex& e) {
    return GiNaC::is_a<GiNaC::numeric>(e) && GiNaC::ex_to<GiNaC::numeric>(e).is_rational();
}
bool is_integer(const GiNaC::ex& e) {
    return GiNaC::is_a<GiNaC::numeric>(e) && GiNaC::ex_to<GiNaC::numeric>(e).is_integer();
}
bool is_negative_number(const GiNaC::ex& e) {
    return is_rational(e) && GiNaC::ex_to<GiNaC::numeric>(e).is_negative();
}

} // namespace

class TapeBuilder {
public:
    TapeBuilder(const System& system, const std::vector<GiNaC::symbol>& states) : system_(system) {
        for (const Parameter& p : system.parameters) constants_symbol(p.symbol);
        tape_.parameters_ = constants_;
        constants_symbol(system.eps);
        tape_.eps_root_ = system.eps_root;
        for (const GiNaC::symbol& s : states) known_[s] = {true, tape_.states_++};
        varying_ = tape_.states_;
    }

    Tape build(const std::vector<GiNaC::ex>& expressions) {
        std::vector<Value> outputs;
        outputs.reserve(expressions.size());
        for (const GiNaC::ex& e : expressions) outputs.push_back(lower(e));
        finish(outputs);
        return std::move(tape_);
    }

private:
    // A register of its own numbering: constants and varying values are counted apart until finish().
    struct Value {
        bool varying = false;
        int index = 0;
        friend bool operator<(const Value& a, const Value& b) {
            return std::tie(a.varying, a.index) < std::tie(b.varying, b.index);
        }
        friend bool operator==(const Value&, const Value&) = default;
    };
    struct LooseStep {
        Op op;
        Value result, left, right;
        Function function;
        const PiecewisePolynomial* data = nullptr;
        int derivative = 0;
    };
    using Exponents = std::vector<std::pair<GiNaC::ex, GiNaC::ex>>;

    void constants_symbol(const GiNaC::symbol& s) { known_[s] = {false, constants_++}; }

    Value number(const cln::cl_RA& value, const std::string& spelling) {
        const auto [at, fresh] = numbers_.try_emplace(spelling, Value{false, constants_});
        if (fresh) tape_.numbers_.push_back({constants_++, to_parts(value)});
        return at->second;
    }
    Value integer(long n) { return number(cln::cl_I(n), std::to_string(n)); }

    // One operation; an equal one is not repeated.
    Value step(Op op, Value left, Value right, int results = 1, Function function = Function::named) {
        if ((op == Op::add || op == Op::multiply) && right < left) std::swap(left, right);
        if (op == Op::multiply && left == right) op = Op::square;
        if (op == Op::multiply && !left.varying && right.varying) op = Op::scale;
        const auto [at, fresh] = steps_.try_emplace(std::tuple(op, left, right, function));
        if (!fresh) return at->second;
        const bool varying = left.varying || right.varying;
        int& count = varying ? varying_ : constants_;
        at->second = {varying, count};
        count += results;
        (varying ? body_ : prologue_).push_back({op, at->second, left, right, function, nullptr, 0});
        return at->second;
    }
    Value step(Op op, Value operand, int results = 1) { return step(op, operand, operand, results); }
    static Value second(Value v) { return {v.varying, v.index + 1}; }

    Value multiply(Value a, Value b) { return step(Op::multiply, a, b); }
    Value divide(Value a, Value b) {
        if (a.varying && !b.varying) return multiply(step(Op::divide, integer(1), b), a);
        return step(Op::divide, a, b);
    }

    [[nodiscard]] std::string name_of(const GiNaC::symbol& s) const;

    Value lower(const GiNaC::ex& e);
    // With its sign (SignedSpelling::Form) taken out.
    Value lower_unsigned(const GiNaC::ex& e);
    Value lower_fresh(const GiNaC::ex& e, bool flipped);
    Value lower_sum(const GiNaC::ex& e, bool flipped);
    Value lower_product(const GiNaC::ex& e, bool negative);
    Value product(const std::vector<Value>& factors);
    Value lower_power(const GiNaC::ex& base, const GiNaC::ex& exponent);
    Value integer_power(Value base, unsigned long exponent);
    Value lower_function(const GiNaC::ex& e);
    Value lower_data(const DataPointer& data, int derivative, Value at);
    void finish(const std::vector<Value>& outputs);

    const System& system_;
    Tape tape_;
    int constants_ = 0, varying_ = 0;
    std::map<GiNaC::ex, Value, GiNaC::ex_is_less> known_;    // symbols, then everything lowered
    std::map<GiNaC::ex, Value, GiNaC::ex_is_less> unsigned_; // -e, of the e that are spelled as negative
    SignedSpelling spelling_{[this](const GiNaC::symbol& s) { return name_of(s); }};
    std::map<std::string, Value> numbers_;
    std::map<std::tuple<Op, Value, Value, Function>, Value> steps_;
    std::map<std::pair<std::string, int>, Value> data_;
    std::vector<LooseStep> prologue_, body_;
};

// By its place in the file.
std::string TapeBuilder::name_of(const GiNaC::symbol& s) const {
    const auto known = known_.find(s);
    if (known == known_.end()) return s.get_name();
    return fmt::format("{}{}", known->second.varying ? "state" : "constant", known->second.index);
}

TapeBuilder::Value TapeBuilder::lower(const GiNaC::ex& e) {
    const auto found = known_.find(e);
    if (found != known_.end()) return found->second;
    const Value value = lower_fresh(e, false);
    known_.emplace(e, value);
    return value;
}

TapeBuilder::Value TapeBuilder::lower_unsigned(const GiNaC::ex& e) {
    if (!spelling_.of(e).negative) return lower(e);
    const auto found = unsigned_.find(e);
    if (found != unsigned_.end()) return found->second;
    const Value value = lower_fresh(e, true);
    unsigned_.emplace(e, value);
    return value;
}

// Of what has a sign: flipped, -e.
TapeBuilder::Value TapeBuilder::lower_fresh(const GiNaC::ex& e, bool flipped) {
    const bool negative = spelling_.of(e).negative != flipped;
    if (is_rational(e))
        return number(flipped ? -exact(GiNaC::ex_to<GiNaC::numeric>(e))
                              : exact(GiNaC::ex_to<GiNaC::numeric>(e)),
                      (negative ? "-" : "") + spelling_.of(e).text);
    if (e.is_equal(GiNaC::Pi)) return number(cln::rational(cln::pi(cln::float_format(60))), "pi");
    if (GiNaC::is_a<GiNaC::add>(e)) return lower_sum(e, flipped);
    if (GiNaC::is_a<GiNaC::mul>(e)) return lower_product(e, negative);
    if (GiNaC::is_a<GiNaC::power>(e)) {
        const Value power = lower_power(e.op(0), e.op(1));
        return negative ? multiply(integer(-1), power) : power;
    }
    if (GiNaC::is_a<GiNaC::function>(e)) return lower_function(e);
    refuse({"direct integration knows numbers, symbols, + - * / ^ and elementary functions",
            spelling_.with_sign(e),
            "write the equation with these",
            {}});
}

TapeBuilder::Value TapeBuilder::lower_sum(const GiNaC::ex& e, bool flipped) {
    // Positive terms first, so that a - b is one subtraction and no term is negated.
    std::vector<Value> plus, minus;
    for (const GiNaC::ex& term : spelling_.sorted_operands(e))
        (spelling_.of(term).negative != flipped ? minus : plus).push_back(lower_unsigned(term));
    Value sum = plus.empty() ? integer(0) : plus.front();
    for (std::size_t i = 1; i < plus.size(); ++i) sum = step(Op::add, sum, plus[i]);
    for (const Value& term : minus) sum = step(Op::subtract, sum, term);
    return sum;
}

TapeBuilder::Value TapeBuilder::lower_product(const GiNaC::ex& e, bool negative) {
    std::vector<Value> above, below;
    bool sign = negative; // yet to be given to a factor
    for (const GiNaC::ex& factor : spelling_.sorted_operands(e)) {
        if (spelling_.of(factor).text == "1") continue; // -1 is but a sign
        if (GiNaC::is_a<GiNaC::power>(factor) && is_negative_number(factor.op(1))) {
            below.push_back(lower_power(factor.op(0), -factor.op(1)));
        } else if (is_rational(factor) && sign) {
            above.push_back(lower_fresh(factor, !spelling_.of(factor).negative));
            sign = false;
        } else {
            above.push_back(lower_unsigned(factor));
        }
    }
    if (sign) above.push_back(integer(-1));
    const Value numerator = product(above);
    return below.empty() ? numerator : divide(numerator, product(below));
}

// Constants are multiplied among themselves first: once, not per evaluation.
TapeBuilder::Value TapeBuilder::product(const std::vector<Value>& factors) {
    const Value one = integer(1);
    Value constant = one, varying = one;
    for (const Value& f : factors) {
        Value& into = f.varying ? varying : constant;
        into = into == one ? f : multiply(into, f);
    }
    if (varying == one) return constant;
    return constant == one ? varying : multiply(constant, varying);
}

// Of an integer power: the sign of the base taken out.
TapeBuilder::Value TapeBuilder::lower_power(const GiNaC::ex& base, const GiNaC::ex& exponent) {
    if (is_negative_number(exponent)) return divide(integer(1), lower_power(base, -exponent));
    if (is_integer(exponent))
        return integer_power(lower_unsigned(base),
                             static_cast<unsigned long>(GiNaC::ex_to<GiNaC::numeric>(exponent).to_long()));
    const Value b = lower(base);
    if (exponent.is_equal(GiNaC::ex(1) / 2)) return step(Op::sqrt, b);
    const Value x = lower(exponent);
    if (!x.varying) return step(Op::power, b, x);
    return step(Op::exp, multiply(x, lower(GiNaC::log(base))));
}

TapeBuilder::Value TapeBuilder::integer_power(Value base, unsigned long exponent) {
    if (exponent == 0) return integer(1);
    if (exponent == 1) return base;
    const Value half = integer_power(base, exponent / 2);
    const Value square = step(Op::square, half);
    return exponent % 2 == 0 ? square : multiply(square, base);
}

TapeBuilder::Value TapeBuilder::lower_function(const GiNaC::ex& e) {
    if (is_named(e)) {
        const NamedCall called = named_call(e);
        const NamedFunction* named = system_.function(called.name);
        const auto state = known_.find(called.argument);
        if (named != nullptr && named->data != nullptr && state != known_.end() && state->second.varying &&
            state->second.index < tape_.states_)
            return lower_data(named->data, called.derivative, state->second);
    }
    const std::optional<Function> f = function_of(e);
    if (!f)
        refuse({"direct integration knows the elementary functions",
                spelling_.with_sign(e),
                "write the equation with these",
                {}});
    const Value a = lower(e.op(0));
    switch (*f) {
    case Function::sine: return step(Op::sin_cos, a, 2);
    case Function::cosine: return second(step(Op::sin_cos, a, 2));
    case Function::hyperbolic_sine: return step(Op::sinh_cosh, a, 2);
    case Function::hyperbolic_cosine: return second(step(Op::sinh_cosh, a, 2));
    case Function::tangent: return step(Op::tan_secant, a, 2);
    case Function::hyperbolic_tangent: return step(Op::tanh_sech, a, 2);
    case Function::exponential: return step(Op::exp, a);
    default: return step(Op::function, a, lower(slope_of(*f, e.op(0))), 1, *f);
    }
}

// A derivative of data by the next one, which is its slope.
TapeBuilder::Value TapeBuilder::lower_data(const DataPointer& data, int derivative, Value at) {
    if (derivative > data->degree) return integer(0);
    const auto known = data_.find({data->name, derivative});
    if (known != data_.end()) return known->second;
    const Value slope = lower_data(data, derivative + 1, at);
    if (derivative == data->degree) tape_.data_.push_back({data, at.index});
    const Value result{true, varying_++};
    body_.push_back({Op::data, result, at, slope, Function::named, data.get(), derivative});
    data_.emplace(std::pair(data->name, derivative), result);
    return result;
}

void TapeBuilder::finish(const std::vector<Value>& outputs) {
    const auto place = [this](const Value& v) { return v.varying ? constants_ + v.index : v.index; };
    const auto settle = [&](const std::vector<LooseStep>& from, std::vector<Tape::Instruction>& to) {
        for (const LooseStep& s : from)
            to.push_back(
                {s.op, place(s.result), place(s.left), place(s.right), s.function, s.data, s.derivative});
    };
    settle(prologue_, tape_.prologue_);
    settle(body_, tape_.body_);
    for (const Value& v : outputs) tape_.outputs_.push_back(place(v));
    tape_.constants_ = constants_;
    tape_.registers_ = constants_ + varying_;
}

Tape Tape::rates(const FirstOrderSystem& system) {
    std::vector<GiNaC::symbol> states;
    std::vector<GiNaC::ex> rates;
    for (const State& s : system.states) {
        states.push_back(s.symbol);
        rates.push_back(s.rate);
    }
    return of(*system.system, states, rates);
}

Tape Tape::of(const System& system, const std::vector<GiNaC::symbol>& states,
              const std::vector<GiNaC::ex>& expressions) {
    return TapeBuilder(system, states).build(expressions);
}

} // namespace resonform
