// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/lies.hpp"

#include "certify/certificate.hpp"
#include "normalize/recursion/named_series.hpp"
#include "solve/flow/named_parts.hpp"
#include "solve/flow_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

namespace resonform {

bool Lies::is_below(const Lie& lie) const {
    return lie.caught_by.empty() && lie.effect_ulp <= clear_of_threshold();
}

std::size_t Lies::survivors() const {
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [&](const Lie& lie) { return survives(lie); }));
}

std::vector<Lie> lies_in_formulas(const Normalization& normalization) {
    Normalization n = normalization;
    const Certifier certifier(n.normal_form.field);
    std::vector<Lie> lies;
    for (const SeriesOfForm& item : all_series(n))
        for (int weight = 0; weight <= item.series->through(); ++weight) {
            const Polynomial truth = item.series->part(weight);
            for (std::size_t k = 0; k < truth.size(); ++k) {
                std::vector<Term> terms = truth.terms();
                terms[k].coefficient = -terms[k].coefficient;
                item.series->set(weight, Polynomial::from_terms(std::move(terms)));
                Lie lie{"", fmt::format("{}, weight {}, term {}", item.name, weight, k + 1), "sign"};
                if (!certifier(n.normal_form, n.map).holds) lie.caught_by = "certificate";
                lies.push_back(std::move(lie));
            }
            item.series->set(weight, truth);
        }
    return lies;
}

std::vector<Lie> lies_in_flow(const Solution& solution) {
    Solution lying = solution;
    std::vector<Lie> lies;
    for (const NamedPart<SlowFlow>& part : named_parts(*solution.flow))
        for (std::size_t k = 0; k < part.truth.size(); ++k) {
            SlowFlow flow = *solution.flow;
            part.put(flow, part.truth - Rational(2) * Polynomial::from_terms({part.truth.terms()[k]}));
            lying.flow = std::make_shared<const SlowFlow>(std::move(flow));
            Lie lie{"", fmt::format("solution, {}, term {}", part.name, k + 1), "sign"};
            if (!flow_complaint(lying).empty()) lie.caught_by = "certificate";
            lies.push_back(std::move(lie));
        }
    return lies;
}

Lies liars(const std::shared_ptr<const FirstOrderSystem>& system, const Scene& scene,
           const Solution& solution, const VerifyOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    Lies lies;
    lies.threshold = scene.verify.ulp;
    std::size_t told = 0;
    const auto tell = [&](const char* where) {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
        if (options.progress)
            options.progress(
                fmt::format("{} lies in {} after {:.1f} s", lies.all.size() - told, where, passed.count()));
        told = lies.all.size();
    };
    lies.all = lies_in_formulas(*solution.normalization);
    tell("normal form and map");
    if (solution.flow) {
        const std::vector<Lie> told_by_flow = lies_in_flow(solution);
        lies.all.insert(lies.all.end(), told_by_flow.begin(), told_by_flow.end());
    } else
        lies_in_solution(system, scene, solution, options, lies);
    tell("the solution");
    lies_in_emitted(scene, solution, options, lies);
    tell("emitted code");
    return lies;
}

} // namespace resonform
