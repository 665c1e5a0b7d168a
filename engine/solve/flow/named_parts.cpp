// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow/named_parts.hpp"

namespace resonform {

std::vector<NamedPart<SlowFlow>> named_parts(const SlowFlow& flow) {
    NamedParts<SlowFlow> parts;
    parts.add_each(flow, &SlowFlow::phases, numbered("phase rate"));
    parts.add_each(flow, &SlowFlow::decays, numbered("exponent"));
    parts.add_each(flow, &SlowFlow::modes, numbered("rate of mode"), &FlowMode::rate);
    parts.add_each(flow, &SlowFlow::angles, numbered("rate of angle"), &FlowMode::rate);
    parts.add_each(flow, &SlowFlow::slow, numbered("slow rate"));
    parts.add_each(flow, &SlowFlow::drift, numbered("drift rate"));
    parts.add_each(
        flow, &SlowFlow::outputs, [&](std::size_t k) { return flow.outputs[k].name; }, &FlowOutput::value);
    parts.add_each(
        flow, &SlowFlow::state, [&](std::size_t k) { return "start of " + flow.state[k].name; },
        &FlowOutput::value);
    return parts.all();
}

} // namespace resonform
