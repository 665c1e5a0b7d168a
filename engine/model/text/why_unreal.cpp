// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/why_unreal.hpp"

#include "model/text/canonical.hpp"
#include "model/text/enclosure.hpp"

namespace resonform {

std::string why_unreal(const GiNaC::ex& e, const GiNaC::exmap& point) {
    for (auto part = e.postorder_begin(); part != e.postorder_end(); ++part) {
        const bool fractional = GiNaC::is_a<GiNaC::power>(*part) &&
                                GiNaC::is_a<GiNaC::numeric>(part->op(1)) &&
                                !GiNaC::ex_to<GiNaC::numeric>(part->op(1)).is_integer();
        const std::string name =
            GiNaC::is_a<GiNaC::function>(*part) ? GiNaC::ex_to<GiNaC::function>(*part).get_name() : "";
        if (!fractional && name != "log" && name != "asin" && name != "acos") continue;
        const GiNaC::ex argument = part->op(0);
        const auto sign = [&](const GiNaC::ex& value) {
            const std::optional<RealBall> there = enclose(value, point);
            return there ? there->sign() : 0;
        };
        if ((fractional || name == "log") && sign(argument) < 0) return spell(argument) + " is negative";
        if (name.substr(0, 1) == "a" && (sign(argument - 1) > 0 || sign(argument + 1) < 0))
            return spell(argument) + " is not within -1 ... 1";
    }
    return "";
}

} // namespace resonform
