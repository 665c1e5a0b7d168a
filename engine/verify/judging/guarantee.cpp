// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/guarantee.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/files/interval_length.hpp"
#include "model/files/settings.hpp"
#include "model/text/eps_powers.hpp"
#include "solve/neglected.hpp"
#include "solve/route.hpp"
#include "solve/solve.hpp"
#include "solve/time_scale.hpp"
#include "solve/truncation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

// Normal form and map through a weight and outputs through eps^order guarantee the weight after the largest
// order not above that asks for no larger weight, on t <= T/eps^p. Errors (refused): there is none; those of
// count_truncation.
int guaranteed_by_count(const GradedField& field, Scene scene, int order, int truncation, int p) {
    const auto text = [&](int held) { return to_string(field.system().weight(held)); };
    scene.truncation.reset();
    scene.time_scale = p;
    for (scene.order = order; scene.order >= 0; --scene.order)
        if (count_truncation(field, scene).truncation <= truncation) return scene.order + 1;
    scene.order = 0;
    refuse({"order 0 asks for no more weights than were derived",
            fmt::format("truncation = {}, over eps^-{} order 0 asks for {}", text(truncation), text(p),
                        text(count_truncation(field, scene).truncation)),
            "shorten verify.interval",
            {}});
}

// Where an interval is longer than the scene promises, the count may not hold. Error: refused.
void require_count(const Scene& scene, const Solution& solution, int p) {
    if (p <= scene.slow_power()) return;
    Scene longer = scene;
    longer.truncation.reset();
    longer.time_scale = p;
    check_time_scale(solution, longer);
    if (!solution.flow && !solves_by_quadratures(solution.normalization->normal_form, p))
        refuse({"beyond 1/eps an amplitude in closed form is constant",
                "powers of eps*t are expanded",
                "shorten verify.interval",
                {}});
}

Guarantees unguaranteed(const Claims& claims, const std::string& why) {
    Guarantees found;
    for (const auto& [name, claim] : claims)
        found[name] = {{}, false, "no order is guaranteed on this interval: " + why};
    return found;
}

class Search {
public:
    Search(const Scene& scene, const Solution& solution, const Derive& derive, int p)
        : scene_(scene), solution_(solution), derive_(derive), formula_(formula_of(scene, solution, p)) {}

    Guarantees of(const Claims& claims) {
        Guarantees found;
        Claims open;
        try {
            for (const auto& [name, claim] : claims) {
                found[name].order = by_count(name);
                if (claim > *found[name].order) open[name] = claim;
            }
            require_count(scene_, solution_, formula_.time_power);
        } catch (const Error& error) {
            return unguaranteed(claims, told(error));
        }
        try {
            for (int weight = formula_.truncation + 1; !open.empty(); ++weight) look(weight, found, open);
        } catch (const Error& error) {
            for (const auto& [name, claim] : open)
                found[name].reason = "what comes next cannot be derived: " + told(error);
        }
        return found;
    }

private:
    [[nodiscard]] int by_count(const std::string& name) const {
        const int order =
            counted(*solution_.normalization->normal_form.field, formula_.order, formula_.truncation);
        if (formula_.oscillating) return order;
        return std::min(first_oscillation(solution_, name).value_or(order), order);
    }

    [[nodiscard]] int counted(const GradedField& field, int order, int truncation) const {
        return guaranteed_by_count(field, scene_, order, truncation, formula_.time_power);
    }

    // Derives one more weight and settles the claims that it decides.
    void look(int weight, Guarantees& found, Claims& open) {
        if (!fixed_) fixed_ = system_with_fix(scene_);
        const Solution richer = derive_(fixed_, weight, weight);
        const Neglected neglected(richer, formula_);
        const int known = counted(*richer.normalization->normal_form.field, weight, weight);
        for (auto output = open.begin(); output != open.end();) {
            const auto& [name, claim] = *output;
            Guarantee& guarantee = found[name];
            const std::optional<ErrorPower> error = neglected.power(name);
            const int reached = std::min({error ? error->power : known, known, claim});
            guarantee.order = std::max(*guarantee.order, reached);
            const bool stops = reached < known && reached < claim;
            if (stops) refute(guarantee, error->sure, weight, reached);
            output = stops || reached == claim ? open.erase(output) : std::next(output);
        }
    }

    void refute(Guarantee& guarantee, bool sure, int weight, int power) const {
        const System& system = *scene_.system;
        const std::string eps = spell_eps_power(system.weight(power));
        guarantee.refuted = sure;
        guarantee.reason =
            !sure ? "it is not decided whether what the formula leaves out vanishes at " + eps
                  : fmt::format("what the formula leaves out (normal form and map derived through weight "
                                "{}) does not vanish at {}",
                                to_string(system.weight(weight)), eps);
    }

    const Scene& scene_;
    const Solution& solution_;
    const Derive& derive_;
    TruncatedFormula formula_;
    std::shared_ptr<const System> fixed_;
};

} // namespace

Guarantees guarantees(const Scene& scene, const Solution& solution, const Claims& claims,
                      const Derive& derive) {
    const std::optional<int> p = time_power(scene);
    if (!p)
        return unguaranteed(claims, fmt::format("the interval stays below a power of 1/eps (interval = {})",
                                                scene.verify.interval_text));
    return Search(scene, solution, derive, *p).of(claims);
}

} // namespace resonform
