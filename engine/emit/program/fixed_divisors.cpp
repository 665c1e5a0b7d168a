// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/fixed_divisors.hpp"

#include "algebra/number/error.hpp"
#include "algebra/ring/constant.hpp"
#include "emit/display/display.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/spelling.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/regular.hpp"
#include "model/text/zero_test.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

Zero zero_when_fixed(const GiNaC::ex& e, const Scene& scene) {
    const auto value = where_regular([&] { return scene.fixed(e).expand(); });
    if (!value) return Zero::no; // its own denominator is a divisor, too
    if (is_constant(*value) && sign_of_constant(*value) != ConstantSign::unknown) return Zero::no;
    const Zero zero = vanishes(*value);
    return zero == Zero::unknown && !is_constant(*value) ? Zero::no : zero; // parameters are left
}

// "w1, w2"
std::string fixed_in(const GiNaC::ex& e, const Scene& scene) {
    std::string names;
    for (const Parameter& p : scene.system->parameters)
        if (scene.fix.count(p.name) > 0 && e.has(p.symbol)) names += (names.empty() ? "" : ", ") + p.name;
    return names;
}

[[noreturn]] void refuse_fixed(const Ring& ring, const DivisorRecord& record, const std::string& names,
                               const Scene& scene, bool certain) {
    const auto text = [&](const Polynomial& p) {
        return spell(display(ring, p, phases(ring)), text_spelling());
    };
    Place place = whole_file(scene.file);
    place.key = "fix";
    refuse(
        certain ? Reason::resonance : Reason::undecided,
        {"a divisor that was divided by is zero with the values under [fix]",
         fmt::format("D({}) of {} = {}{}", text(Polynomial(record.monomial, 1)), record.variable,
                     text(record.divisor), certain ? " = 0" : ", which may be zero"),
         fmt::format("change {} under [fix], or declare the resonance in [relations] of the system", names),
         place});
}

} // namespace

void require_divisors(const Normalization& normalization, const Scene& scene) {
    const GradedField& field = *normalization.normal_form.field;
    const Ring& ring = *field.ring;
    std::vector<Polynomial> seen;
    for (const DivisorRecord& record : normalization.divisors) {
        if (record.verdict != DivisorVerdict::removed ||
            std::find(seen.begin(), seen.end(), record.divisor) != seen.end())
            continue;
        seen.push_back(record.divisor);
        const Polynomial conjugate = ring.conjugate(record.divisor);
        const GiNaC::ex re = field.coefficients->expression(record.divisor + conjugate);
        const GiNaC::ex im =
            field.coefficients->expression(ring.multiply(-ring.imaginary(), record.divisor - conjugate));
        const Zero real = zero_when_fixed(re, scene), imaginary = zero_when_fixed(im, scene);
        if (real == Zero::no || imaginary == Zero::no) continue;
        refuse_fixed(ring, record, fixed_in(re + im, scene), scene,
                     real == Zero::yes && imaginary == Zero::yes);
    }
}

} // namespace resonform
