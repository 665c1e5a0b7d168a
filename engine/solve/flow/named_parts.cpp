// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow/named_parts.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

class PartsOfFlow {
public:
    // find(flow): the polynomial or the series of that name.
    template <class Find> void add(const std::string& name, const Polynomial& truth, const Find& find) {
        all.push_back({name, truth, [find](SlowFlow& flow, const Polynomial& p) { find(flow) = p; }});
    }
    template <class Find> void add(const std::string& name, const Series& truth, const Find& find) {
        for (int n = 0; n <= truth.through(); ++n)
            all.push_back({fmt::format("{}, weight {}", name, n), truth.part(n),
                           [find, n](SlowFlow& flow, const Polynomial& p) { find(flow).set(n, p); }});
    }

    std::vector<PartOfFlow> all;
};

} // namespace

std::vector<PartOfFlow> named_parts(const SlowFlow& flow) {
    PartsOfFlow parts;
    for (std::size_t k = 0; k < flow.phases.size(); ++k)
        parts.add(fmt::format("phase rate {}", k), flow.phases[k],
                  [k](SlowFlow& f) -> Polynomial& { return f.phases[k]; });
    for (std::size_t k = 0; k < flow.decays.size(); ++k)
        parts.add(fmt::format("exponent {}", k), flow.decays[k],
                  [k](SlowFlow& f) -> Polynomial& { return f.decays[k]; });
    for (std::size_t k = 0; k < flow.modes.size(); ++k)
        parts.add(fmt::format("rate of mode {}", k), flow.modes[k].rate,
                  [k](SlowFlow& f) -> Series& { return f.modes[k].rate; });
    for (std::size_t k = 0; k < flow.angles.size(); ++k)
        parts.add(fmt::format("rate of angle {}", k), flow.angles[k].rate,
                  [k](SlowFlow& f) -> Series& { return f.angles[k].rate; });
    for (std::size_t k = 0; k < flow.slow.size(); ++k)
        parts.add(fmt::format("slow rate {}", k), flow.slow[k],
                  [k](SlowFlow& f) -> Series& { return f.slow[k]; });
    for (std::size_t k = 0; k < flow.drift.size(); ++k)
        parts.add(fmt::format("drift rate {}", k), flow.drift[k],
                  [k](SlowFlow& f) -> Series& { return f.drift[k]; });
    for (std::size_t k = 0; k < flow.outputs.size(); ++k)
        parts.add(flow.outputs[k].name, flow.outputs[k].value,
                  [k](SlowFlow& f) -> Series& { return f.outputs[k].value; });
    for (std::size_t k = 0; k < flow.state.size(); ++k)
        parts.add("start of " + flow.state[k].name, flow.state[k].value,
                  [k](SlowFlow& f) -> Series& { return f.state[k].value; });
    return parts.all;
}

} // namespace resonform
