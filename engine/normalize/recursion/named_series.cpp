// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/named_series.hpp"

namespace resonform {

std::vector<SeriesOfForm> all_series(Normalization& n) {
    std::vector<SeriesOfForm> result;
    const auto add = [&](const std::string& name, std::vector<Series>& list) {
        for (std::size_t k = 0; k < list.size(); ++k)
            result.push_back({name + " " + std::to_string(k), &list[k]});
    };
    add("normal form, mode", n.normal_form.mode);
    add("normal form, angle", n.normal_form.angle);
    add("normal form, slow", n.normal_form.slow);
    add("normal form, drift", n.normal_form.drift);
    add("map, mode", n.map.mode);
    add("map, angle", n.map.angle);
    add("map, slow", n.map.slow);
    add("map, drift", n.map.drift);
    if (n.normal_form.hamiltonian) {
        result.push_back({"energy", &n.normal_form.hamiltonian->energy});
        result.push_back({"generator", &n.normal_form.hamiltonian->generator});
    }
    return result;
}

} // namespace resonform
