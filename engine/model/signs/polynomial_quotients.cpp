// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/signs/polynomial_quotients.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

using Quotient = PackedQuotient; // coprime

class Quotients {
public:
    // Without `cancelling` numerators and denominators keep common factors.
    // The variables are the symbols, and pi.
    Quotients(const std::vector<GiNaC::symbol>& symbols, const std::vector<PowerRelation>& relations,
              const PolynomialContext& context, bool cancelling)
        : symbols_(symbols), cancelling_(cancelling), context_(context) {
        for (std::size_t k = 0; k < symbols.size(); ++k) variables_[symbols[k]] = static_cast<slong>(k);
        variables_[GiNaC::Pi] = static_cast<slong>(symbols.size());
        for (const PowerRelation& r : relations) {
            const auto found = variables_.find(r.symbol);
            const Quotient value = of(r.value);
            if (!value.below.is_one()) throw NoQuotient{};
            relations_.push_back({found->second, static_cast<ulong>(r.index), value.above});
        }
    }

    Quotient packed(const ex& e) {
        Quotient q = of(e);
        lower(q.above);
        lower(q.below);
        return q.above.is_zero() || q.below.is_zero() ? q : coprime(q.above, q.below);
    }

    PolynomialQuotient lowered(const ex& e) {
        const Quotient q = packed(e);
        if (q.below.begins_negative()) return {written(q.above.negative()), written(q.below.negative())};
        return {written(q.above), written(q.below)};
    }

    std::optional<bool> is_zero(const ex& e) {
        Quotient q = of(e);
        lower(q.above);
        lower(q.below);
        return q.below.is_zero() ? std::nullopt : std::optional<bool>(q.above.is_zero());
    }

private:
    struct Lowering {
        slong variable;
        ulong index;
        Packed value;
    };

    static Quotient coprime(const Packed& above, const Packed& below) {
        const Packed divisor = common_divisor(above, below);
        return {above.divided_by(divisor), below.divided_by(divisor)};
    }

    Quotient of(const ex& e) {
        if (GiNaC::is_a<numeric>(e)) return of_number(GiNaC::ex_to<numeric>(e));
        if (GiNaC::is_a<GiNaC::symbol>(e) || GiNaC::is_a<GiNaC::constant>(e)) return of_variable(e);
        if (GiNaC::is_a<GiNaC::add>(e)) return sum_of(e, 0, e.nops());
        if (GiNaC::is_a<GiNaC::mul>(e)) {
            Quotient product = of(e.op(0));
            for (std::size_t k = 1; k < e.nops(); ++k) product = times(product, of(e.op(k)));
            return product;
        }
        if (!GiNaC::is_a<GiNaC::power>(e) || !e.op(1).info(GiNaC::info_flags::integer)) throw NoQuotient{};
        const int n = GiNaC::ex_to<numeric>(e.op(1)).to_int();
        const Quotient base = of(e.op(0));
        if (n >= 0)
            return {base.above.raised(static_cast<ulong>(n)), base.below.raised(static_cast<ulong>(n))};
        if (base.above.is_zero()) throw NoQuotient{};
        return {base.below.raised(static_cast<ulong>(-n)), base.above.raised(static_cast<ulong>(-n))};
    }

    Quotient of_number(const numeric& n) {
        if (!n.is_rational()) throw NoQuotient{};
        const Whole above(cln::the<cln::cl_I>(n.numer().to_cl_N()));
        const Whole below(cln::the<cln::cl_I>(n.denom().to_cl_N()));
        return {Packed(context_, above), Packed(context_, below)};
    }

    Quotient of_variable(const ex& e) {
        const auto found = variables_.find(e);
        if (found == variables_.end()) throw NoQuotient{};
        Quotient result{Packed(context_), Packed(context_, 1)};
        fmpz_mpoly_gen(result.above.get(), found->second, context_.get());
        return result;
    }

    // Of the terms first ... last - 1, by halves: sums of like size are added.
    Quotient sum_of(const ex& sum, std::size_t first, std::size_t last) {
        if (last - first == 1) return of(sum.op(first));
        const std::size_t middle = first + (last - first) / 2;
        return plus(sum_of(sum, first, middle), sum_of(sum, middle, last));
    }

    [[nodiscard]] Quotient plus(const Quotient& a, const Quotient& b) const {
        const bool alike = a.below == b.below;
        if (alike && (!cancelling_ || a.below.is_one())) return {a.above + b.above, a.below};
        const Packed common = common_divisor(a.below, b.below);
        const Packed rest = b.below.divided_by(common);
        const Packed above = a.above * rest + b.above * a.below.divided_by(common);
        return cancelling_ ? coprime(above, a.below * rest) : Quotient{above, a.below * rest};
    }

    [[nodiscard]] Quotient times(const Quotient& a, const Quotient& b) const {
        if (!cancelling_) return {a.above * b.above, a.below * b.below};
        const Packed left = common_divisor(a.above, b.below), right = common_divisor(b.above, a.below);
        return {a.above.divided_by(left) * b.above.divided_by(right),
                a.below.divided_by(right) * b.below.divided_by(left)};
    }

    void lower(Packed& p) {
        for (auto r = relations_.rbegin(); r != relations_.rend(); ++r) lower(p, *r);
    }

    // Replaces symbol^index by its value: the terms are sorted by the power of it that they hold.
    void lower(Packed& p, const Lowering& r) {
        const slong degree = fmpz_mpoly_degree_si(p.get(), r.variable, context_.get());
        if (degree < static_cast<slong>(r.index)) return;
        std::vector<Packed> parts(static_cast<std::size_t>(degree) / r.index + 1, Packed(context_));
        p.visit_terms([&](Packed::Exponents& exponents, const Whole& coefficient) {
            ulong& exponent = exponents[static_cast<std::size_t>(r.variable)];
            Packed& part = parts[exponent / r.index];
            exponent %= r.index;
            part.give(exponents, coefficient);
        });
        Packed sum(context_), power(context_, 1);
        for (Packed& part : parts) {
            part.put_in_order();
            sum = sum + part * power;
            power = power * r.value;
        }
        p = sum;
    }

    ex written(const Packed& p) const {
        GiNaC::exvector terms;
        p.visit_terms([&](const Packed::Exponents& exponents, const Whole& coefficient) {
            GiNaC::exvector factors{numeric(cln::cl_N(coefficient.value()))};
            for (std::size_t v = 0; v < exponents.size(); ++v)
                if (exponents[v] != 0)
                    factors.push_back(GiNaC::pow(v < symbols_.size() ? ex(symbols_[v]) : GiNaC::Pi,
                                                 static_cast<long>(exponents[v])));
            terms.push_back(GiNaC::mul(factors));
        });
        return GiNaC::add(terms);
    }

    const std::vector<GiNaC::symbol>& symbols_;
    bool cancelling_;
    const PolynomialContext& context_;
    std::map<ex, slong, GiNaC::ex_is_less> variables_;
    std::vector<Lowering> relations_;
};

} // namespace

PackedQuotient packed_quotient(const ex& e, const std::vector<GiNaC::symbol>& symbols,
                               const std::vector<PowerRelation>& relations,
                               const PolynomialContext& context) {
    return Quotients(symbols, relations, context, true).packed(e);
}

std::optional<PolynomialQuotient> polynomial_quotient(const ex& e, const std::vector<GiNaC::symbol>& symbols,
                                                      const std::vector<PowerRelation>& relations) {
    try {
        const PolynomialContext context(symbols.size() + 1);
        return Quotients(symbols, relations, context, true).lowered(e);
    } catch (const NoQuotient&) {
        return std::nullopt;
    }
}

std::optional<bool> quotient_is_zero(const ex& e, const std::vector<GiNaC::symbol>& symbols,
                                     const std::vector<PowerRelation>& relations) {
    try {
        const PolynomialContext context(symbols.size() + 1);
        return Quotients(symbols, relations, context, false).is_zero(e);
    } catch (const NoQuotient&) {
        return std::nullopt;
    }
}

} // namespace resonform
