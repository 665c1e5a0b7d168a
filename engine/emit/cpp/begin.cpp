// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/begin.hpp"

#include "emit/cpp/embedded_text.hpp"
#include "emit/cpp/names.hpp"

#include <fmt/format.h>

#include <map>

namespace resonform {

namespace {

std::string bad_unless(const std::string& condition, const std::string& status, const std::string& what) {
    return fmt::format("        if (!{}) return {{Status::{}, {}}};\n", condition, status, cpp_literal(what));
}

class CppBegin {
public:
    explicit CppBegin(const CppPlan& plan) : program_(*plan.program), plan_(plan) {}

    [[nodiscard]] std::string print() const;

private:
    [[nodiscard]] std::string arguments() const;
    [[nodiscard]] std::string conditions() const;

    const Program& program_;
    const CppPlan& plan_;
};

std::string CppBegin::arguments() const {
    std::string text;
    for (const CppCallable& callable : plan_.callables)
        text +=
            bad_unless(fmt::format("parameters.{}.given()", callable.name), "bad_argument", callable.name);
    std::map<Graph::Node, std::string> all{{program_.eps, "eps"}};
    const auto finite = [&](const std::string& from, const std::vector<ProgramInput>& inputs,
                            const std::vector<std::string>& names) {
        for (std::size_t k = 0; k < names.size(); ++k) {
            all[inputs[k].symbol] = from + names[k];
            text += bad_unless(fmt::format("finite({}{})", from, names[k]), "bad_argument", names[k]);
        }
    };
    finite("parameters.", program_.parameters, plan_.parameters);
    finite("start.", program_.start, plan_.start);
    if (!plan_.range.native) return text;
    for (const Graph::Node symbol : plan_.range.limited) {
        const std::string& argument = all.at(symbol);
        text += bad_unless(fmt::format("within({}, 0x1p{})", argument, plan_.range.bound), "overflow",
                           argument.substr(argument.find('.') + 1));
    }
    return text;
}

// Checks of the constant conditions; none if keep_constants, which computes in Scaled, has checked them.
std::string CppBegin::conditions() const {
    if (!plan_.range.native || plan_.constant_conditions.empty()) return "";
    std::string text;
    for (std::size_t k = 0; k < plan_.constant_conditions.size(); ++k) {
        const CppCondition& condition = plan_.constant_conditions[k];
        text += bad_unless(plan_.conditions_apart
                               ? fmt::format("(holds[{}] > resonform::Scaled<Real>(0))", k)
                               : fmt::format("(c.{} > Real(0))", plan_.members.at(condition.value)),
                           "outside_domain", condition.quantity);
    }
    return plan_.conditions_apart ? std::string(frames::start_holds) + text : text;
}

std::string CppBegin::print() const {
    return "    static Cause begin(const Real& eps, [[maybe_unused]] const Parameters& parameters,\n"
           "                       const Start& start, Constants<Real>& c) {\n" +
           arguments() + cpp_constants_call(plan_, "constants", "c") + conditions() +
           "        return {};\n    }\n\n";
}

} // namespace

std::string cpp_constants_call(const CppPlan& plan, const std::string& which, const std::string& target) {
    const std::string call = fmt::format("{}(eps, parameters, start, {})", which, target);
    if (plan.range.native) return "        compute_" + call + ";\n";
    return "        if (const Cause lost = keep_" + call +
           "; lost.status != Status::ok)\n            return lost;\n";
}

std::string cpp_begin(const CppPlan& plan) { return CppBegin(plan).print(); }

} // namespace resonform
