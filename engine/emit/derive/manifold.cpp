// SPDX-License-Identifier: GPL-3.0-or-later
// The centre manifold: the flow on it, the manifold in the old variables, its fibres.
#include "emit/derive/derive.hpp"
#include "emit/display/display.hpp"
#include "emit/display/json.hpp"
#include "emit/display/normal_form_json.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/page.hpp"
#include "emit/display/slow_rate.hpp"
#include "emit/display/spelling.hpp"
#include "emit/display/vanishing.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

class ManifoldPage {
public:
    ManifoldPage(const CentreManifold& result, int order)
        : result_(result), field_(*result.flow.field), order_(order), write_(writer()),
          phases_(phases(*field_.ring)) {}

    [[nodiscard]] Section flow() const {
        Section section;
        for (std::size_t k = 0; k < field_.modes.size(); ++k)
            if (!result_.slaved[k]) add(section, rate_of(field_.modes[k].name), {}, result_.flow.mode[k]);
        visit_others(field_, result_.flow, false, [&](const std::string& name, const Series& rate) {
            add(section, rate_of(name), {}, rate);
        });
        return section;
    }

    [[nodiscard]] Section manifold() const {
        Section section{"manifold", {}};
        for (std::size_t k = 0; k < field_.modes.size(); ++k)
            add(section, old_mode(field_, k), result_.slaved[k] ? "" : field_.modes[k].name,
                result_.manifold.mode[k]);
        add_others(section, "old", result_.manifold);
        return section;
    }

    [[nodiscard]] Section fibres() const {
        Section section{"base point of a state (z1, ... are the old modes here)", {}};
        for (std::size_t k = 0; k < field_.modes.size(); ++k)
            if (!result_.slaved[k])
                add(section, function_of("base", field_.modes[k].name), field_.modes[k].name,
                    result_.fibres.mode[k]);
        add_others(section, "base", result_.fibres);
        return section;
    }

private:
    static DisplaySum rate_of(const std::string& name) { return symbol_sum(name + "'"); }

    [[nodiscard]] SeriesWriter writer() const {
        std::vector<Polynomial> all;
        for (const auto* list : {&result_.flow.mode, &result_.flow.angle, &result_.flow.slow,
                                 &result_.flow.drift, &result_.manifold.mode, &result_.manifold.angle,
                                 &result_.manifold.slow, &result_.manifold.drift, &result_.fibres.mode,
                                 &result_.fibres.angle, &result_.fibres.slow, &result_.fibres.drift})
            for (const Series& series : *list) all.push_back(series.total(order_));
        return {field_.ring, field_.eps, field_.outer(), only_rate_with_eps(field_), all};
    }

    // left = name + series, or the series alone.
    void add(Section& section, DisplaySum left, const std::string& name, const Series& series) const {
        Side right = written(series, order_, write_, phases_);
        if (!name.empty()) right.groups.insert(right.groups.begin(), symbol_sum(name));
        section.formulas.push_back({side(std::move(left)), std::move(right)});
    }

    void add_others(Section& section, const std::string& function, const NearIdentityMap& map) const {
        visit_others(field_, map, true, [&](const std::string& name, const Series& series) {
            add(section, function_of(function, name), name, series);
        });
    }

    const CentreManifold& result_;
    const GradedField& field_;
    int order_;
    SeriesWriter write_;
    Substitutes phases_;
};

// Warns that the manifold has more dimensions where a growth rate vanishes.
std::vector<std::string> growth_remarks(const CentreManifold& manifold) {
    const GradedField& field = *manifold.flow.field;
    std::vector<std::string> remarks;
    Vanishing vanishing(field);
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (manifold.slaved[k] && !vanishing.nowhere(field.modes[k].growth))
            remarks.push_back(fmt::format(
                "{} is slaved: its growth rate is taken to vanish nowhere, {}", field.modes[k].name,
                spell(display(*field.ring, field.modes[k].growth), text_spelling())));
    return remarks;
}

} // namespace

Page manifold_page(const CentreManifold& manifold, const Certificate& certificate, int order) {
    const ManifoldPage parts(manifold, order);
    Page page;
    const System& system = manifold.flow.field->system();
    page.title = fmt::format("centre manifold of {} through weight {}", system.name_with_settings(),
                             to_string(system.weight(order)));
    append_sections(page, {parts.flow(), parts.manifold(), parts.fibres()});
    page.remarks = growth_remarks(manifold);
    page.remarks.push_back(certificate_remark(certificate));
    return page;
}

Json manifold_json(const CentreManifold& manifold, const Certificate& certificate, int order) {
    const GradedField& field = *manifold.flow.field;
    Json document = json_head("resonform.manifold/1", field.system());
    Json slaved = Json::array(), flow = Json::array(), map = Json::array(), fibres = Json::array();
    const auto append = [&](Json& list, const std::string& name, const Series& series) {
        append_json_terms(list, *field.ring, name, series.total(order), field.outer());
    };
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const std::string& name = field.modes[k].name;
        append(map, name, manifold.manifold.mode[k]);
        if (manifold.slaved[k]) {
            slaved.push_back(name);
            continue;
        }
        append(flow, name, manifold.flow.mode[k]);
        append(fibres, name, manifold.fibres.mode[k]);
    }
    const auto append_others = [&](Json& list, const auto& from, bool is_map) {
        visit_others(field, from, is_map,
                     [&](const std::string& name, const Series& series) { append(list, name, series); });
    };
    append_others(flow, manifold.flow, false);
    append_others(map, manifold.manifold, true);
    append_others(fibres, manifold.fibres, true);
    document.update(Json{{"order", json_rational(field.system().weight(order))},
                         {"slaved", std::move(slaved)},
                         {"flow", std::move(flow)},
                         {"manifold", std::move(map)},
                         {"fibres", std::move(fibres)},
                         {"certificate", certificate_json(certificate)}});
    return document;
}

} // namespace resonform
