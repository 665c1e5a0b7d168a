// SPDX-License-Identifier: GPL-3.0-or-later
// The normal form as JSON where coefficients are nodes of a graph: each is written out only when printed.
#include "algebra/graph/expansion.hpp"
#include "emit/derive/derive.hpp"
#include "emit/display/display.hpp"
#include "emit/display/json.hpp"
#include "emit/display/normal_form_json.hpp"
#include "emit/display/normal_form_parts.hpp"

#include <fmt/format.h>

#include <map>

namespace resonform {

namespace {

class GraphPrinter {
public:
    GraphPrinter(const GraphNormalization& normalization, int order)
        : domain_(normalization.domain), field_(*normalization.result.normal_form.field), order_(order) {}

    void append(Json& list, const std::string& variable, const BasicSeries<GraphPart>& series) const {
        for (int weight = 0; weight <= order_; ++weight) append(list, variable, series.part(weight));
    }

private:
    // Real and imaginary coefficient of one monomial.
    struct Entry {
        Coefficient re, im;
    };

    void append(Json& list, const std::string& variable, const GraphPart& part) const {
        const Ring& ring = *field_.ring;
        std::map<Monomial, Entry> entries;
        std::vector<Polynomial> monomials;
        for (std::size_t k = 0; k < part.size(); ++k) {
            const Monomial m = ring.restricted(domain_.monomial(part.keys[k]), field_.outer());
            monomials.emplace_back(m, 1);
            Entry& entry = entries[m];
            (OuterKeys::has_i(part.keys[k]) ? entry.im : entry.re) = part.coefficients[k];
        }
        for (const auto& [m, count] : collect_in_order(ring, sum(monomials), field_.outer()))
            list.push_back({{"variable", variable},
                            {"exponents", json_exponents(ring, m, field_.outer())},
                            {"weight", json_weight(ring, m)},
                            {"coefficient", expression(entries.at(m))}});
    }

    [[nodiscard]] std::string expression(const Entry& entry) const {
        const std::string re = entry.re.is_zero() ? "" : quotient(entry.re);
        const std::string im = entry.im.is_zero() ? "" : "I*" + quotient(entry.im);
        return re.empty() ? im : im.empty() ? re : re + " + " + im;
    }

    // "(w1 - 2*w2)/(2*w1*(w1 + w2)**2)"
    [[nodiscard]] std::string quotient(Coefficient c) const {
        const ExpandedCoefficient expanded = expand(domain_.graph(), c);
        const std::string numerator = "(" + text(expanded.numerator) + ")";
        std::string denominator;
        for (const auto& [divisor, times] : expanded.denominator)
            denominator += fmt::format("{}({}){}", denominator.empty() ? "" : "*",
                                       text(domain_.graph().divisor(divisor)),
                                       times == 1 ? "" : fmt::format("**{}", times));
        return denominator.empty() ? numerator : numerator + "/(" + denominator + ")";
    }

    [[nodiscard]] std::string text(const LeafPolynomial& p) const {
        return json_expression(*field_.ring, domain_.polynomial(p));
    }

    const GraphDomain& domain_;
    const GradedField& field_;
    int order_;
};

} // namespace

Json normal_form_json(const GraphNormalization& normalization, int order) {
    const NormalizationOf<GraphPart>& result = normalization.result;
    const GradedField& field = *result.normal_form.field;
    const GraphPrinter printer(normalization, order);
    const auto list = [&](const auto& from, bool is_map) {
        Json terms = Json::array();
        visit_variables(field, from, is_map, [&](const std::string& name, const auto& series) {
            printer.append(terms, name, series);
        });
        return terms;
    };
    return normal_form_document(field, order, result.normal_form.through, result.normal_form.style,
                                list(result.normal_form, false), list(result.map, true), result.divisors,
                                result.certificate);
}

} // namespace resonform
