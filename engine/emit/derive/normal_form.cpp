// SPDX-License-Identifier: GPL-3.0-or-later
// (20): the normal form with the definitions of its variables, and the near-identity map.
#include "emit/derive/derive.hpp"
#include "emit/derive/hamiltonian.hpp"
#include "emit/display/display.hpp"
#include "emit/display/drift_frame.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/page.hpp"
#include "emit/display/slow_rate.hpp"
#include "emit/display/spelling.hpp"
#include "emit/display/vanishing.hpp"
#include "expand/expansion/graded_field.hpp"

#include <fmt/format.h>
#include <utility>

namespace resonform {

namespace {

class NormalFormPage {
public:
    NormalFormPage(const Normalization& normalization, int order, const Solution* solution)
        : normal_form_(normalization.normal_form), map_(normalization.map), field_(*normal_form_.field),
          order_(order), frames_(drift_frames(field_, solution)), write_(writer()),
          phases_(phases(*field_.ring)) {}

    [[nodiscard]] Section rates() const {
        Section section;
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const Mode& mode = field_.modes[k];
            add_rate(section, mode.name, normal_form_.mode[k]);
            if (!mode.is_real()) add_rate(section, mode.conjugate_name, conjugate(normal_form_.mode[k]));
        }
        for (std::size_t k = 0; k < field_.angles.size(); ++k)
            add_rate(section, field_.angles[k].name, normal_form_.angle[k]);
        for (std::size_t k = 0; k < frames_.size(); ++k) {
            Series rate = normal_form_.drift[k];
            if (frames_[k].removed) rate.set(1, without_known_drift(*field_.ring, field_.eps, rate.part(1)));
            add_rate(section, frames_[k].normal, rate);
        }
        for (std::size_t k = 0; k < field_.slow.size(); ++k) {
            const SlowVariable& slow = field_.slow[k];
            if (slow.driven) {
                add_rate(section, slow.name, normal_form_.slow[k]);
            } else {
                define(section, slow.name + "'", display(*field_.ring, slow.rate));
            }
        }
        return section;
    }

    [[nodiscard]] Section definitions() const {
        Section section{"where", {}};
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const Mode& mode = field_.modes[k];
            define(section, mode.name, side(old_mode(field_, k), first_weight(map_.mode[k])));
            if (!mode.is_real()) define(section, mode.conjugate_name, function_of("conj", mode.name));
            if (mode.oscillator)
                define(section, frequency_name(field_, k), display(*field_.ring, mode.omega));
        }
        for (std::size_t k = 0; k < frames_.size(); ++k) {
            define(section, frames_[k].normal,
                   side(symbol_sum(frames_[k].name), first_weight(map_.drift[k])));
            define_frame(section, frames_[k]);
        }
        return section;
    }

    [[nodiscard]] Section map() const {
        Section section{"near-identity map", {}};
        for (std::size_t k = 0; k < field_.modes.size(); ++k)
            add_map(section, old_mode(field_, k), field_.modes[k].name, map_.mode[k]);
        for (std::size_t k = 0; k < field_.angles.size(); ++k)
            add_map(section, function_of("old", field_.angles[k].name), field_.angles[k].name, map_.angle[k]);
        for (std::size_t k = 0; k < field_.slow.size(); ++k)
            if (field_.slow[k].driven)
                add_map(section, function_of("old", field_.slow[k].name), field_.slow[k].name, map_.slow[k]);
        for (std::size_t k = 0; k < frames_.size(); ++k)
            add_map(section, symbol_sum(frames_[k].name), frames_[k].normal, map_.drift[k]);
        return section;
    }

private:
    // The first weight in which a map differs from the identity, as far as it is known.
    [[nodiscard]] Rational first_weight(const Series& series) const {
        int n = 1;
        while (n <= map_.through && series.part(n).empty()) ++n;
        return field_.system().weight(n);
    }

    [[nodiscard]] SeriesWriter writer() const {
        std::vector<Polynomial> all;
        for (const auto* list : {&normal_form_.mode, &normal_form_.angle, &normal_form_.slow,
                                 &normal_form_.drift, &map_.mode, &map_.angle, &map_.slow, &map_.drift})
            for (const Series& series : *list) all.push_back(series.total(order_));
        return {field_.ring, field_.eps, field_.outer(), only_rate_with_eps(field_), all};
    }

    [[nodiscard]] Series conjugate(const Series& series) const {
        Series result;
        for (int n = 0; n <= series.through(); ++n) result.set(n, field_.ring->conjugate(series.part(n)));
        return result;
    }

    void add_rate(Section& section, const std::string& name, const Series& rate) const {
        define(section, name + "'", written(rate, order_, write_, phases_));
    }

    void add_map(Section& section, DisplaySum old, const std::string& name, const Series& difference) const {
        Side right = written(difference, order_, write_, phases_);
        right.groups.insert(right.groups.begin(), symbol_sum(name));
        section.formulas.push_back({side(std::move(old)), std::move(right)});
    }

    const NormalForm& normal_form_;
    const NearIdentityMap& map_;
    const GradedField& field_;
    int order_;
    std::vector<DriftFrame> frames_;
    SeriesWriter write_;
    Substitutes phases_;
};

// Lists the small divisors that are not proved to vanish nowhere; "" if there are none.
std::string divisor_remark(const GradedField& field) {
    std::string text;
    Vanishing vanishing(field);
    for (const Polynomial& divisor : small_divisors(field))
        if (!vanishing.nowhere(divisor))
            text += (text.empty() ? "" : ", ") +
                    spell(display_without_sign(*field.ring, divisor), text_spelling());
    return text.empty() ? "" : "small divisors, taken to vanish nowhere: " + text;
}

} // namespace

Page normal_form_page(const Normalization& normalization, int order, const Solution* solution) {
    const NormalFormPage parts(normalization, order, solution);
    Page page;
    page.title = normal_form_title(normalization.normal_form, order);
    std::vector<Section> sections{parts.rates(), equilibrium_section(*normalization.normal_form.field),
                                  parts.definitions(), parts.map()};
    if (normalization.normal_form.hamiltonian)
        for (Section& section : hamiltonian_sections(normalization.normal_form, order))
            sections.push_back(std::move(section));
    append_sections(page, std::move(sections));
    const std::string divisors = divisor_remark(*normalization.normal_form.field);
    if (!divisors.empty()) page.remarks.push_back(divisors);
    page.remarks.push_back(certificate_remark(normalization.certificate));
    return page;
}

} // namespace resonform
