// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/zero_test.hpp"

#include "model/text/enclosure.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;

// Distinct rationals in (0, 1) or (1, 2) by turns, the same on every run; the symbols by name.
GiNaC::exmap point_for(const ex& e, int salt) {
    std::vector<ex> symbols;
    for (auto i = e.preorder_begin(); i != e.preorder_end(); ++i) {
        if (GiNaC::is_a<GiNaC::symbol>(*i)) symbols.push_back(*i);
    }
    std::sort(symbols.begin(), symbols.end(), [](const ex& a, const ex& b) {
        return GiNaC::ex_to<GiNaC::symbol>(a).get_name() < GiNaC::ex_to<GiNaC::symbol>(b).get_name();
    });
    GiNaC::exmap point;
    for (const ex& symbol : symbols) {
        const int count = static_cast<int>(point.size());
        point.emplace(symbol, salt % 2 + GiNaC::numeric(1 + (37 * count + 61 * salt) % 97, 101));
    }
    add_named(e, point);
    return point;
}

// 0: not known with 64 bits. More bits would not prove a zero either, and cost time at every point.
int sign_at(const ex& e, const GiNaC::exmap& point) {
    constexpr std::int64_t bits = 64;
    const std::optional<RealBall> value = enclose(e, point, bits);
    return value ? value->sign() : 0;
}

// The cost of normal() may grow exponentially with the number of fractions.
bool is_small(const ex& e) {
    constexpr int most_parts = 300;
    int parts = 0;
    for (auto i = e.preorder_begin(); i != e.preorder_end() && parts <= most_parts; ++i) ++parts;
    return parts <= most_parts;
}

} // namespace

void add_named(const ex& e, GiNaC::exmap& point) {
    for (auto i = e.preorder_begin(); i != e.preorder_end(); ++i) {
        if (!is_named(*i)) continue;
        const NamedCall call = named_call(*i);
        int n = 3;
        for (const char c : call.name) n = (31 * n + static_cast<unsigned char>(c)) % 97 + 3;
        const ex slope = GiNaC::numeric(1, n), value = GiNaC::exp(slope * call.argument);
        point[*i] = call.derivative == 0 ? 1 + value : GiNaC::pow(slope, call.derivative) * value;
    }
}

bool differs_from_zero(const ex& e, const std::vector<ex>& positive) {
    if (is_constant(e) && sign_of_constant(e) != ConstantSign::unknown) return true;
    constexpr int points = 4, tries = 97; // until they repeat
    GiNaC::lst all{e};
    for (const ex& declared : positive) all.append(declared);
    int inside = 0;
    for (int salt = 1; inside < points && salt <= tries; ++salt) {
        const GiNaC::exmap point = point_for(positive.empty() ? e : ex(all), salt);
        const bool meant = std::all_of(positive.begin(), positive.end(),
                                       [&](const ex& declared) { return sign_at(declared, point) > 0; });
        if (meant && sign_at(e, point) != 0) return true;
        inside += meant ? 1 : 0;
    }
    return false;
}

bool differs_from_zero(const ex& e) { return differs_from_zero(e, {}); }

Zero vanishes(const ex& e) { return vanishes(e, {}); }

Zero vanishes(const ex& e, const std::vector<ex>& positive) {
    if (e.is_zero()) return Zero::yes;
    if (differs_from_zero(e, positive)) return Zero::no;
    if (e.expand().is_zero()) return Zero::yes;
    return is_small(e) && e.normal().is_zero() ? Zero::yes : Zero::unknown;
}

} // namespace resonform
