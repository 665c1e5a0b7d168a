// SPDX-License-Identifier: GPL-3.0-or-later
// The polynomials of a slow flow, or of a solution, by name, so that one can be changed.
#pragma once

#include "solve/flow/slow_flow.hpp"

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

namespace resonform {

template <class Whole> struct NamedPart {
    std::string name; // "rate of mode 0, weight 3"
    Polynomial truth;
    std::function<void(Whole&, const Polynomial&)> put; // in its place
};

template <class Whole> class NamedParts {
public:
    // find(whole): the polynomial or the series of that name.
    template <class Find> void add(const std::string& name, const Polynomial& truth, const Find& find) {
        all_.push_back({name, truth, [find](Whole& whole, const Polynomial& p) { find(whole) = p; }});
    }
    template <class Find> void add(const std::string& name, const Series& truth, const Find& find) {
        for (int n = 0; n <= truth.through(); ++n)
            all_.push_back({fmt::format("{}, weight {}", name, n), truth.part(n),
                            [find, n](Whole& whole, const Polynomial& p) { find(whole).set(n, p); }});
    }
    // Each item of a list: `part` of it, by name(k).
    template <class Item, class Name, class Part = std::identity>
    void add_each(const Whole& whole, std::vector<Item> Whole::*list, const Name& name, Part part = {}) {
        for (std::size_t k = 0; k < (whole.*list).size(); ++k)
            add(
                name(k), std::invoke(part, (whole.*list)[k]), [=](Whole & w) -> auto& {
                    return std::invoke(part, (w.*list)[k]);
                });
    }
    [[nodiscard]] const std::vector<NamedPart<Whole>>& all() const { return all_; }

private:
    std::vector<NamedPart<Whole>> all_;
};

// "phase rate 0", "phase rate 1", ...
inline auto numbered(const char* name) {
    return [name](std::size_t k) { return fmt::format("{} {}", name, k); };
}

std::vector<NamedPart<SlowFlow>> named_parts(const SlowFlow& flow);

} // namespace resonform
