// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/enclosure.hpp"

#include "model/text/function_call.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <cstdlib>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

using Value = std::optional<RealBall>;

constexpr std::int64_t least_bits = 64, most_bits = 512;
constexpr slong largest_binary_exponent = 1 << 20;

Value checked(RealBall value) {
    const slong exponent = arf_abs_bound_lt_2exp_si(arb_midref(value.get()));
    const bool moderate =
        arf_is_zero(arb_midref(value.get())) != 0 || std::abs(exponent) <= largest_binary_exponent;
    return moderate && value.is_finite() ? Value(std::move(value)) : std::nullopt;
}

class Enclosure {
public:
    Enclosure(const GiNaC::exmap& point, std::int64_t bits) : point_(point), bits_(bits) {}

    [[nodiscard]] Value of(const ex& e) const {
        if (is_a<GiNaC::numeric>(e)) return of_number(ex_to<GiNaC::numeric>(e));
        if (e.is_equal(GiNaC::Pi)) return pi();
        if (is_a<GiNaC::symbol>(e) || is_named(e)) {
            const auto found = point_.find(e);
            return found == point_.end() ? std::nullopt : of(found->second);
        }
        if (is_a<GiNaC::add>(e)) return of_operands(e, 0, arb_add);
        if (is_a<GiNaC::mul>(e)) return of_operands(e, 1, arb_mul);
        if (is_a<GiNaC::power>(e)) return of_power(e);
        return is_a<GiNaC::function>(e) && e.nops() == 1 ? of_function(e) : std::nullopt;
    }

private:
    [[nodiscard]] Value of_number(const GiNaC::numeric& n) const {
        if (!n.is_rational()) return std::nullopt;
        return RealBall(cln::the<cln::cl_RA>(n.to_cl_N()), bits_);
    }

    [[nodiscard]] RealBall pi() const {
        RealBall result;
        arb_const_pi(result.get(), bits_);
        return result;
    }

    [[nodiscard]] Value of_operands(const ex& e, std::int64_t neutral,
                                    void (*join)(arb_t, const arb_t, const arb_t, slong)) const {
        RealBall total(neutral);
        for (const ex& part : e) {
            const Value value = of(part);
            if (!value) return std::nullopt;
            join(total.get(), total.get(), value->get(), bits_);
        }
        return total;
    }

    [[nodiscard]] Value of_power(const ex& e) const {
        const Value base = of(e.op(0)), exponent = base ? of(e.op(1)) : std::nullopt;
        if (!exponent) return std::nullopt;
        RealBall result;
        arb_pow(result.get(), base->get(), exponent->get(), bits_);
        return checked(std::move(result));
    }

    [[nodiscard]] Value of_function(const ex& e) const {
        const std::optional<Function> f = function_of(e);
        const Value argument = f ? of(e.op(0)) : std::nullopt;
        if (!argument) return std::nullopt;
        RealBall result;
        row_of(*f).enclose(result.get(), argument->get(), bits_);
        return checked(std::move(result));
    }

    const GiNaC::exmap& point_;
    std::int64_t bits_;
};

} // namespace

bool is_constant(const ex& e) {
    return std::none_of(e.preorder_begin(), e.preorder_end(),
                        [](const ex& part) { return is_a<GiNaC::symbol>(part) || is_named(part); });
}

std::optional<RealBall> enclose(const ex& e, const GiNaC::exmap& point, std::int64_t bits) {
    return Enclosure(point, bits).of(e);
}

std::optional<RealBall> enclose(const ex& e, const GiNaC::exmap& point) {
    Value value;
    for (std::int64_t bits = least_bits; bits <= most_bits && !(value && value->sign() != 0); bits *= 2)
        value = enclose(e, point, bits);
    return value;
}

ConstantSign sign_of_constant(const ex& e) {
    const Value value = enclose(e);
    const int sign = value ? value->sign() : 0;
    return sign > 0 ? ConstantSign::positive : sign < 0 ? ConstantSign::negative : ConstantSign::unknown;
}

} // namespace resonform
