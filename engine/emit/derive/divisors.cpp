// SPDX-License-Identifier: GPL-3.0-or-later
// The divisors of a normal form with their verdicts, and the resonance surfaces, where one of the removed
// divisors vanishes.
#include "algebra/ring/fractions.hpp"
#include "emit/derive/derive.hpp"
#include "emit/display/display.hpp"
#include "emit/display/json.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/page.hpp"
#include "emit/display/vanishing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

namespace resonform {

namespace {

// Real and imaginary part of a divisor a + i b vanish together on a surface.
struct Surface {
    std::vector<Polynomial> vanishing; // primitive parts
    std::vector<std::pair<std::string, Monomial>> in;
};

Polynomial part_of(const Ring& ring, const Polynomial& p, int power_of_i) {
    std::vector<Term> terms;
    for (const Term& t : p.terms())
        if (ring.exponent(t.monomial, Ring::imaginary_unit) == power_of_i)
            terms.push_back({t.monomial - ring.monomial(Ring::imaginary_unit, power_of_i), t.coefficient});
    return Polynomial::from_terms(std::move(terms));
}

// One polynomial for each surface of a real divisor, or two that vanish together.
std::vector<std::vector<Polynomial>> surfaces_of(const GradedField& field, Vanishing& vanishing_of,
                                                 const Polynomial& divisor) {
    std::vector<std::vector<Polynomial>> result{{}};
    for (const int power_of_i : {0, 1}) {
        const Polynomial part = part_of(*field.ring, divisor, power_of_i);
        if (part.empty()) continue;
        std::vector<std::vector<Polynomial>> longer;
        for (const std::vector<Polynomial>& vanishing : result)
            for (const Polynomial& factor : vanishing_of.factors(part)) {
                longer.push_back(vanishing);
                longer.back().push_back(factor);
            }
        result = std::move(longer);
    }
    return result;
}

std::vector<Surface> surfaces(const GradedField& field, const std::vector<DivisorRecord>& divisors,
                              int order) {
    std::vector<Surface> found;
    Vanishing vanishing_of(field);
    for (const DivisorRecord& record : divisors) {
        if (record.weight > order || record.verdict != DivisorVerdict::removed) continue;
        for (std::vector<Polynomial>& vanishing : surfaces_of(field, vanishing_of, record.divisor)) {
            auto known = std::find_if(found.begin(), found.end(),
                                      [&](const Surface& s) { return s.vanishing == vanishing; });
            if (known == found.end()) known = found.insert(found.end(), Surface{std::move(vanishing), {}});
            known->in.emplace_back(record.variable, record.monomial);
        }
    }
    return found;
}

const char* meaning(const DivisorRecord& record) {
    switch (record.verdict) {
    case DivisorVerdict::removed: return "divided by";
    case DivisorVerdict::kept_exact: return "resonant";
    case DivisorVerdict::kept_near:
        return record.divisor.empty() ? "zero in all digits, for no reason that is known"
                                      : "below the threshold of [normal_form] near";
    case DivisorVerdict::ambiguous: return "undecided";
    }
    return "";
}

// A total order, of no meaning.
struct InSomeOrder {
    bool operator()(const Polynomial& a, const Polynomial& b) const {
        const auto key = [](const Fractions& f) {
            return std::tie(f.monomials, f.negative, f.limbs, f.magnitudes, f.denominator);
        };
        return key(a.fractions()) < key(b.fractions());
    }
};

Json exponents_json(const GradedField& field, const std::string& variable, const Monomial& m) {
    return {{"variable", variable}, {"exponents", json_exponents(*field.ring, m, field.outer())}};
}

} // namespace

Page divisors_page(const GradedField& field, const std::vector<DivisorRecord>& divisors, int order) {
    const Ring& ring = *field.ring;
    const Substitutes harmonics = phases(ring);
    Page page;
    page.title =
        fmt::format("divisors of {} through weight {}: D of a monomial is <alpha, lambda> - lambda_j",
                    field.system().name_with_settings(), to_string(field.system().weight(order)));
    std::map<DivisorVerdict, int> count;
    for (const DivisorRecord& record : divisors) {
        if (record.weight > order) continue;
        ++count[record.verdict];
        const std::string heading =
            fmt::format("{}, {} ({})", record.variable, to_string(record.verdict), meaning(record));
        auto section = std::find_if(page.sections.begin(), page.sections.end(),
                                    [&](const Section& s) { return s.heading == heading; });
        if (section == page.sections.end())
            section = page.sections.insert(page.sections.end(), Section{heading, {}});
        section->formulas.push_back(
            {side(factor_sum(function_factor("D", display(ring, Polynomial(record.monomial, 1), harmonics)))),
             record.divisor.empty() ? zero_side() : side(display(ring, record.divisor))});
    }
    Section resonances{"resonance surfaces", {}};
    for (const Surface& surface : surfaces(field, divisors, order)) {
        std::vector<Formula> equations;
        for (const Polynomial& vanishing : surface.vanishing)
            equations.push_back({side(display_without_sign(ring, vanishing)), zero_side()});
        equations.front().together.assign(equations.begin() + 1, equations.end());
        resonances.formulas.push_back(equations.front());
    }
    if (resonances.formulas.empty())
        page.remarks.emplace_back("no divisor that was divided by can vanish");
    else
        page.sections.push_back(std::move(resonances));
    std::string counts;
    for (const auto& [verdict, times] : count)
        counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", times, to_string(verdict));
    page.remarks.push_back(counts);
    return page;
}

Json divisors_json(const GradedField& field, const std::vector<DivisorRecord>& divisors, int order) {
    Json list = Json::array();
    std::map<Polynomial, std::string, InSomeOrder> texts; // many monomials have the same divisor
    for (const DivisorRecord& record : divisors) {
        if (record.weight > order) continue;
        Json entry = exponents_json(field, record.variable, record.monomial);
        std::string& text = texts[record.divisor];
        if (text.empty()) text = json_expression(*field.ring, record.divisor);
        entry["divisor"] = text;
        entry["verdict"] = to_string(record.verdict);
        list.push_back(std::move(entry));
    }
    return list;
}

Json divisors_document(const GradedField& field, const std::vector<DivisorRecord>& divisors, int order) {
    Json list = Json::array();
    for (const Surface& surface : surfaces(field, divisors, order)) {
        Json vanishing = Json::array(), in = Json::array();
        for (const Polynomial& p : surface.vanishing) vanishing.push_back(json_expression(*field.ring, p));
        for (const auto& [variable, monomial] : surface.in)
            in.push_back(exponents_json(field, variable, monomial));
        list.push_back({{"vanishing", std::move(vanishing)}, {"divisors", std::move(in)}});
    }
    Json document = json_head("resonform.divisors/1", field.system());
    document.update(Json{{"order", json_rational(field.system().weight(order))},
                         {"divisors", divisors_json(field, divisors, order)},
                         {"surfaces", std::move(list)}});
    return document;
}

} // namespace resonform
