// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/numbers.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/real_ball.hpp"
#include "expand/expansion/graded_field.hpp"
#include "expand/modes/number_index.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "normalize/recursion/divisor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace resonform {

namespace {

// The precision is doubled up to these multiples of the first one, before the derivation is refused, and
// before an undecided divisor is.
constexpr std::int64_t most_bits = 64, decisive = 4;

std::int64_t bits_of(int digits) { return static_cast<std::int64_t>(bits_of_digit * digits) + 2; }

using Part = NumberPart;

// Rounds balls to D + spare_digits digits.
class Rounding {
public:
    Rounding(const GradedField& field, const NumberDomain& domain)
        : field_(field), domain_(domain), digits_(field.system().digits + spare_digits) {}

    [[nodiscard]] Rational number(const RealBall& c) const {
        return c.contains_zero() ? Rational(0) : rounded(c, digits_);
    }
    // growth + i frequency
    [[nodiscard]] Polynomial constant(const Polynomial& p) const {
        const ComplexBall c = domain_.value(p);
        return Polynomial(number(c.re())) + number(c.im()) * field_.ring->imaginary();
    }
    // Are all coefficients known to all digits, or so small that they are left out?
    [[nodiscard]] bool is_certain(const BasicSeries<Part>& series) const {
        const std::int64_t scale = scale_of(series);
        for (int n = 0; n <= series.through(); ++n)
            for (const RealBall& c : series.part(n).coefficients)
                if (!is_certain(c, scale)) return false;
        return true;
    }
    [[nodiscard]] bool is_certain(const GivenNumbers& given) const {
        return std::all_of(given.generators.begin(), given.generators.end(),
                           [&](const auto& entry) { return is_certain(entry.second, 0); }) &&
               std::all_of(given.numbers.begin(), given.numbers.end(), [&](const ComplexBall& c) {
                   return is_certain(c.re(), 0) && is_certain(c.im(), 0);
               });
    }
    [[nodiscard]] Series series(const BasicSeries<Part>& from) const {
        Series result;
        for (int n = 0; n <= from.through(); ++n) {
            std::vector<Term> terms;
            const Part& part = from.part(n);
            for (std::size_t k = 0; k < part.size(); ++k)
                if (!part.coefficients[k].contains_zero())
                    terms.push_back(
                        {domain_.monomials().monomial(part.keys[k]), number(part.coefficients[k])});
            result.set(n, Polynomial::from_terms(std::move(terms)));
        }
        return result;
    }
    [[nodiscard]] std::vector<Series> all(const std::vector<BasicSeries<Part>>& from) const {
        std::vector<Series> result;
        for (const BasicSeries<Part>& s : from) result.push_back(series(s));
        return result;
    }

private:
    // All digits of c are certain, or c is negligible beside 2^scale.
    [[nodiscard]] bool is_certain(const RealBall& c, std::int64_t scale) const {
        return c.contains_zero() ? binary_exponent(c) <= scale - bits_of(digits_)
                                 : accurate_bits(c) >= bits_of(digits_);
    }
    static std::int64_t scale_of(const BasicSeries<Part>& series) {
        std::int64_t scale = 0; // >= 0: coefficients far below 1 are negligible anyway
        for (int n = 0; n <= series.through(); ++n)
            for (const RealBall& c : series.part(n).coefficients) scale = std::max(scale, binary_exponent(c));
        return scale;
    }

    const GradedField& field_;
    const NumberDomain& domain_;
    int digits_;
};

bool is_certain(const NormalizationOf<Part>& n, const Rounding& rounding) {
    const auto known = [&](const auto& lists) {
        return std::all_of(lists.begin(), lists.end(), [&](const auto* list) {
            return std::all_of(list->begin(), list->end(),
                               [&](const BasicSeries<Part>& s) { return rounding.is_certain(s); });
        });
    };
    return known(std::array{&n.normal_form.mode, &n.normal_form.angle, &n.normal_form.drift, &n.map.mode,
                            &n.map.angle, &n.map.drift});
}

// Modes and frequencies of the field as rounded numbers.
GradedField rounded_field(const GradedField& field, const GivenNumbers& given, const NumberDomain& domain,
                          const Rounding& rounding) {
    GradedField result = field;
    const auto complex = [&](const ComplexBall& c) {
        return Complex{to_ginac(rounding.number(c.re())), to_ginac(rounding.number(c.im()))};
    };
    const Place place = whole_file(field.system().file);
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        Mode& mode = result.modes[k];
        mode.growth = rounding.constant(mode.growth);
        mode.omega = rounding.constant(mode.omega);
        ModeShape& shape = result.basis.modes[k];
        shape.eigenvalue = complex(domain.value(field.eigenvalue(field.modes[k])));
        const auto evaluated = [&](std::vector<Complex>& vector, NumberOf what) {
            const std::size_t states = field.basis.states.size();
            vector.resize(states);
            for (std::size_t s = 0; s < states; ++s)
                vector[s] = complex(field.basis.numeric
                                        ? given.numbers[number_index(k, s, states, what)]
                                        : domain.value(field.coefficients->convert(vector[s], place)));
        };
        evaluated(shape.column, NumberOf::column);
        evaluated(shape.row, NumberOf::row);
    }
    for (AngleVariable& angle : result.angles) {
        const RealBall frequency = domain.value(angle.frequency).re();
        angle.frequency = rounding.constant(angle.frequency);
        angle.law = to_ginac(rounding.number(frequency));
    }
    result.basis.numeric = nullptr;
    result.basis.numbers.clear();
    return result;
}

// The monomials of a rate and its correction.
void add_monomials(const GradedField& field, const Series& series, std::set<Monomial>& monomials) {
    for (int n = 0; n <= series.through(); ++n)
        for (const Term& t : series.part(n).terms())
            monomials.insert(field.ring->restricted(t.monomial, field.outer()));
}

// Keeps the records of monomials that occur: a coefficient that vanishes structurally is zero in its ball and
// makes no term. The linear terms w_j of modes and the constants of angles keep their records in any case.
std::vector<DivisorRecord> records_of_terms(const Normalization& n, std::vector<DivisorRecord> records) {
    const GradedField& field = *n.normal_form.field;
    std::map<std::string, std::set<Monomial>> there; // by variable
    const auto add = [&](const auto& variables, const std::vector<Series>& rates,
                         const std::vector<Series>& corrections) {
        for (std::size_t k = 0; k < variables.size(); ++k)
            for (const Series* series : {&rates[k], &corrections[k]})
                add_monomials(field, *series, there[variables[k].name]);
    };
    add(field.modes, n.normal_form.mode, n.map.mode);
    add(field.angles, n.normal_form.angle, n.map.angle);
    add(field.drift, n.normal_form.drift, n.map.drift);
    for (const Mode& mode : field.modes) there[mode.name].insert(field.ring->monomial(mode.z));
    for (const AngleVariable& angle : field.angles) there[angle.name].insert(Monomial{});
    const auto is_absent = [&](const DivisorRecord& r) {
        const auto found = there.find(r.variable);
        return found != there.end() && found->second.count(r.monomial) == 0;
    };
    records.erase(std::remove_if(records.begin(), records.end(), is_absent), records.end());
    return records;
}

Normalization rounded_normalization(NormalizationOf<Part> n, const GivenNumbers& given,
                                    const NumberDomain& domain, const Rounding& rounding) {
    Normalization result;
    const GradedField& field = *n.normal_form.field;
    result.normal_form.field =
        std::make_shared<const GradedField>(rounded_field(field, given, domain, rounding));
    result.normal_form.through = result.map.through = n.normal_form.through;
    result.normal_form.mode = rounding.all(n.normal_form.mode);
    result.normal_form.angle = rounding.all(n.normal_form.angle);
    result.normal_form.drift = rounding.all(n.normal_form.drift);
    result.map.mode = rounding.all(n.map.mode);
    result.map.angle = rounding.all(n.map.angle);
    result.map.drift = rounding.all(n.map.drift);
    result.divisors = records_of_terms(result, std::move(n.divisors));
    for (DivisorRecord& record : result.divisors) record.divisor = rounding.constant(record.divisor);
    return result;
}

[[noreturn]] void refuse_undecided(const UndecidedDivisor& undecided, std::int64_t bits) {
    if (undecided.near)
        refuse(Reason::undecided,
               {"a divisor is larger or smaller than near, by more than rounding errors", undecided.divisor,
                "change near in [normal_form] a little", undecided.place});
    refuse(Reason::undecided,
           {"a divisor in numbers is told from zero, or is zero for a reason that is known",
            fmt::format("{} is zero to {} bits", undecided.divisor, bits),
            "keep its monomials with near = 1e-6 in [normal_form], or give the modes in closed form in "
            "[modes]",
            undecided.place});
}

} // namespace

Normalization normalize_in_numbers(const std::shared_ptr<const GradedField>& field, int through,
                                   const NormalizeOptions& options) {
    const std::int64_t first_bits = bits_of(field->system().digits + spare_digits) + 64;
    for (std::int64_t bits = first_bits; bits <= most_bits * first_bits; bits *= 2) {
        const std::optional<GivenNumbers> given = given_numbers(*field, bits);
        if (!given) continue;
        const NumberDomain domain(field->ring, through + 1, bits, *given);
        const Rounding rounding(*field, domain);
        try {
            auto result = normalize_over(field, through, domain, options);
            if (rounding.is_certain(*given) && is_certain(result, rounding))
                return rounded_normalization(std::move(result), *given, domain, rounding);
        } catch (const UndecidedDivisor& divisor) {
            if (bits >= decisive * first_bits) refuse_undecided(divisor, bits);
        }
    }
    refuse(Reason::size, {"the digits of all coefficients are certain",
                          fmt::format("{} bits are not enough", most_bits * first_bits),
                          "ask for fewer --digits, or a lower order",
                          {}});
}

} // namespace resonform
