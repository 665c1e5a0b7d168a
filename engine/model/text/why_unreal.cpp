// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/why_unreal.hpp"

#include "model/text/canonical.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/function_call.hpp"

#include <optional>

namespace resonform {

std::string why_unreal(const GiNaC::ex& e, const GiNaC::exmap& point) {
    for (auto part = e.postorder_begin(); part != e.postorder_end(); ++part) {
        const bool fractional = GiNaC::is_a<GiNaC::power>(*part) &&
                                GiNaC::is_a<GiNaC::numeric>(part->op(1)) &&
                                !GiNaC::ex_to<GiNaC::numeric>(part->op(1)).is_integer();
        const std::optional<Function> f = function_of(*part);
        if (!fractional && !f) continue;
        const std::optional<RealBall> asked =
            enclose(fractional ? part->op(0) : asked_of(part->op(0), *f), point);
        if (!asked || asked->sign() >= 0) continue;
        const Argument wanted = fractional ? Argument::positive : row_of(*f).argument;
        return spell(part->op(0)) + (wanted == Argument::positive       ? " is negative"
                                     : wanted == Argument::at_least_one ? " is less than 1"
                                                                        : " is not within -1 ... 1");
    }
    return "";
}

} // namespace resonform
