// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/names_apart.hpp"

#include "emit/display/display.hpp"
#include "emit/display/latex.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

namespace {

// f of each name of a symbol or a function, in place.
template <class F> void for_each_name(DisplaySum& sum, const F& f);

template <class F> void for_each_name(std::vector<DisplayFactor>& factors, const F& f) {
    for (DisplayFactor& factor : factors) {
        const bool is_function = factor.kind == DisplayFactor::Kind::function && !is_elementary(factor);
        if (is_function || factor.kind == DisplayFactor::Kind::symbol) f(factor.name);
        for (DisplaySum& argument : factor.arguments) for_each_name(argument, f);
    }
}

template <class F> void for_each_name(DisplaySum& sum, const F& f) {
    for (DisplayTerm& term : sum.terms) {
        for_each_name(term.factors, f);
        for_each_name(term.tail, f);
    }
}

template <class F> void for_each_name(Formula& formula, const F& f) {
    for (Side* side : {&formula.left, &formula.right})
        for (DisplaySum& group : side->groups) for_each_name(group, f);
    for (Formula& other : formula.together) for_each_name(other, f);
}

template <class F> void for_each_name(Page& page, const F& f) {
    for (Section& section : page.sections)
        for (Formula& formula : section.formulas) for_each_name(formula, f);
}

// Those that change, by name. Of names that print alike the one with the fewest underscores stays.
std::map<std::string, std::string> set_apart(const std::set<std::string>& names) {
    std::vector<std::pair<std::ptrdiff_t, std::string>> in_order;
    for (const std::string& name : names)
        in_order.emplace_back(std::count(name.begin(), name.end(), '_'), name);
    std::sort(in_order.begin(), in_order.end());
    std::set<std::string> printed;
    std::map<std::string, std::string> changed;
    for (const auto& [underscores, name] : in_order)
        for (std::string other = name; !printed.insert(latex_name(other)).second; changed[name] = other)
            other = with_bracketed_subscript(other);
    return changed;
}

} // namespace

Page with_names_apart(Page page) {
    std::set<std::string> names;
    for_each_name(page, [&](std::string& name) { names.insert(name); });
    const std::map<std::string, std::string> changed = set_apart(names);
    if (changed.empty()) return page;
    for_each_name(page, [&](std::string& name) {
        if (const auto other = changed.find(name); other != changed.end()) name = other->second;
    });
    return page;
}

} // namespace resonform
