// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/signs/root_split.hpp"

#include "model/text/canonical.hpp"
#include "model/text/growth.hpp"

#include <algorithm>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

constexpr int largest_index = 24; // of a root, and of its powers

bool is_root(const ex& e) {
    return is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::rational) &&
           !e.op(1).info(GiNaC::info_flags::integer);
}

// The roots that stand in no other one, each once.
void collect_roots(const ex& e, std::vector<ex>& roots) {
    if (is_root(e)) {
        if (std::none_of(roots.begin(), roots.end(), [&](const ex& r) { return r.is_equal(e); }))
            roots.push_back(e);
        return;
    }
    for (const ex& part : e) collect_roots(part, roots);
}

// Of t, of any sign; t stands in no other root and no function.
bool is_sum_of_powers(const ex& e, const ex& t) {
    if (e.is_equal(t) || !e.has(t)) return true;
    if (is_a<GiNaC::power>(e)) return e.op(0).is_equal(t) && e.op(1).info(GiNaC::info_flags::integer);
    return (is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e)) &&
           std::all_of(e.begin(), e.end(), [&](const ex& part) { return is_sum_of_powers(part, t); });
}

// By the powers of one radicand.
std::optional<RootSplit> split_by(const ex& radicand, const ex& e, const std::vector<ex>& roots) {
    numeric index = 1;
    for (const ex& r : roots)
        if (r.op(0).is_equal(radicand)) index = GiNaC::lcm(index, ex_to<numeric>(r.op(1)).denom());
    if (index.is_odd() || index > largest_index) return std::nullopt;
    const GiNaC::symbol t("t");
    GiNaC::exmap by_t;
    for (const ex& r : roots) {
        const ex power = r.op(1) * index;
        if (GiNaC::abs(ex_to<numeric>(power)) > largest_index) return std::nullopt;
        if (r.op(0).is_equal(radicand)) by_t[r] = GiNaC::pow(t, power);
    }
    ex in_t = e.subs(by_t, GiNaC::subs_options::no_pattern).expand();
    if (!is_sum_of_powers(in_t, t)) return std::nullopt;
    in_t = (in_t * GiNaC::pow(t, -std::min(0, in_t.ldegree(t)))).expand();
    RootSplit split{0, 0, GiNaC::pow(radicand, 2 / index), radicand};
    for (int k = 0; k <= in_t.degree(t); ++k)
        (k % 2 == 0 ? split.a : split.b) += in_t.coeff(t, k) * GiNaC::pow(radicand, (k - k % 2) / index);
    split.a = split.a.expand();
    split.b = split.b.expand();
    return split;
}

} // namespace

std::optional<ex> RootSplit::norm(std::size_t most_operands) const {
    const ex product = a * a - b * b * square;
    // Collecting leaves fewer terms than this bound, but not many times fewer.
    if (of_expression(product).terms > 20 * static_cast<double>(most_operands)) return std::nullopt;
    ex norm = product.expand();
    return norm.nops() > most_operands ? std::nullopt : std::optional(std::move(norm));
}

std::optional<RootSplit> split_by_root(const ex& e) {
    std::vector<ex> roots;
    collect_roots(e, roots);
    if (roots.size() > 1) // GiNaC's order of terms decides nothing
        std::sort(roots.begin(), roots.end(), [](const ex& a, const ex& b) { return spell(a) < spell(b); });
    for (const ex& root : roots)
        if (auto split = split_by(root.op(0), e, roots); split && !split->b.is_zero()) return split;
    return std::nullopt;
}

} // namespace resonform
