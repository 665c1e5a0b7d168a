// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate.hpp"

#include "normalize/certificate_bound.hpp"
#include "normalize/certificate_hamiltonian.hpp"
#include "normalize/certificate_point.hpp"
#include "normalize/certificate_scan.hpp"
#include "normalize/certificate_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace resonform {

namespace {

constexpr int fewest_points = 2;
constexpr double wanted_error = 1e-30;
constexpr int unlucky_points_allowed = 64;

using Matrix = std::vector<std::vector<Residue>>;

bool is_singular(const PrimeField& f, Matrix a) {
    for (std::size_t column = 0; column < a.size(); ++column) {
        std::size_t pivot = column;
        while (pivot < a.size() && a[pivot][column] == 0) ++pivot;
        if (pivot == a.size()) return true;
        std::swap(a[pivot], a[column]);
        const Residue inverse = f.inverse(a[column][column]);
        for (std::size_t row = column + 1; row < a.size(); ++row) {
            const Residue factor = f.multiply(a[row][column], inverse);
            for (std::size_t k = column; k < a.size(); ++k)
                a[row][k] = f.subtract(a[row][k], f.multiply(factor, a[column][k]));
        }
    }
    return false;
}

using Jacobian = std::vector<std::vector<GiNaC::ex>>;

// Of the equations by the highest derivatives.
Jacobian jacobian_of(const System& system) {
    Jacobian jacobian;
    for (const Equation& equation : system.equations) {
        jacobian.emplace_back();
        for (const Variable& v : system.variables)
            jacobian.back().push_back(equation.residual.diff(v.jet[static_cast<std::size_t>(v.order)]));
    }
    return jacobian;
}

// Substitution at one point.
class PointCheck {
public:
    PointCheck(const NormalForm& normal_form, const NearIdentityMap& map, const Jacobian& jacobian,
               CertificateRoots& roots, Point point)
        : normal_form_(normal_form), system_(normal_form.field->system()), jacobian_(jacobian), roots_(roots),
          algebra_(*normal_form.field->ring, std::move(point), normal_form.through),
          jets_(Flow(algebra_, roots_, normal_form, map).jets()) {}

    // The lowest weight at which something does not vanish, as a sentence; "" if all vanish.
    std::string complaint() {
        require_regular_equations();
        check_linear_part();
        for (const auto& [variable, defect] : jets_.velocity_defects) {
            const std::string& name = system_.variables[variable].name;
            must_vanish(defect, fmt::format("d/dt of {} along the normal form is not {}'", name, name));
        }
        for (const Equation& equation : system_.equations)
            must_vanish(evaluate(equation.residual, equation),
                        fmt::format("the residual of the equation of {} is not zero", equation.variable));
        return lowest_weight_ > normal_form_.through
                   ? ""
                   : fmt::format("weight {}: {}", to_string(system_.weight(lowest_weight_)), sentence_);
    }

    FrequencySample frequencies() const {
        FrequencySample sample{algebra_.field(), {}, {}, {}, {}};
        for (const Mode& m : normal_form_.field->modes) {
            sample.growth.push_back(value(m.growth)[0]);
            sample.omega.push_back(value(m.omega)[0]);
        }
        for (const AngleVariable& a : normal_form_.field->angles)
            sample.angle.push_back(value(a.frequency)[0]);
        return sample;
    }

private:
    PointAlgebra::Value value(const Polynomial& p) const {
        return algebra_.gradient(Series({p}), Side::itself).value;
    }

    PointAlgebra::Value evaluate(const GiNaC::ex& e, const Equation& equation) {
        return EquationEvaluator(algebra_, roots_, jets_.values, equation)(e);
    }

    // A residual that vanishes through M says that the highest derivatives are right through M only if
    // they are determined at weight 0. A non-zero determinant at one point proves it.
    void require_regular_equations() {
        Matrix here;
        for (std::size_t k = 0; k < jacobian_.size(); ++k) {
            here.emplace_back();
            for (const GiNaC::ex& e : jacobian_[k])
                here.back().push_back(evaluate(e, system_.equations[k])[0]);
        }
        if (is_singular(algebra_.field(), std::move(here))) throw UnluckyPoint();
    }

    void check_linear_part() {
        const GradedField& field = *normal_form_.field;
        const PointAlgebra::Value i = algebra_.generator(Ring::imaginary_unit, 1);
        for (std::size_t k = 0; k < normal_form_.mode.size(); ++k) {
            const Mode& m = field.modes[k];
            const auto lambda = algebra_.add(value(m.growth), algebra_.multiply(i, value(m.omega)));
            auto lead = algebra_.multiply(lambda, algebra_.generator(m.z, 1));
            for (const ModeCoupling& c : field.couplings(k))
                lead = algebra_.add(lead, algebra_.multiply(algebra_.number(c.factor),
                                                            algebra_.generator(field.modes[c.mode].z, 1)));
            check_lead(normal_form_.mode[k], lead, field.ring->generator(m.z).weight,
                       fmt::format("the linear part of {}' is not lambda*{}{}", m.name, m.name,
                                   field.couplings(k).empty() ? "" : " with its couplings"));
        }
        for (std::size_t k = 0; k < normal_form_.angle.size(); ++k)
            check_lead(normal_form_.angle[k], value(field.angles[k].frequency), 0,
                       fmt::format("{}' does not begin with its frequency", field.angles[k].name));
    }

    // The weights 0 ... `weight` of a rate are `lead`.
    void check_lead(const Series& rate, const PointAlgebra::Value& lead, int weight,
                    const std::string& sentence) {
        const auto head = static_cast<std::size_t>(weight) + 1;
        auto difference = algebra_.gradient(rate, Side::itself).value;
        for (std::size_t n = 0; n < head; ++n)
            difference[n] = algebra_.field().subtract(difference[n], lead[n]);
        difference.resize(head);
        must_vanish(difference, sentence);
    }

    void must_vanish(const PointAlgebra::Value& value, const std::string& sentence) {
        for (int n = 0; n < static_cast<int>(value.size()) && n < lowest_weight_; ++n) {
            if (value[static_cast<std::size_t>(n)] == 0) continue;
            lowest_weight_ = n;
            sentence_ = sentence;
        }
    }

    const NormalForm& normal_form_;
    const System& system_;
    const Jacobian& jacobian_;
    CertificateRoots& roots_;
    PointAlgebra algebra_;
    Jets<PointAlgebra::Value> jets_;
    int lowest_weight_ = normal_form_.through + 1;
    std::string sentence_;
};

int points_needed(double bound) {
    if (!(bound < 0.1))
        refuse({"one random point of the certificate leaves an error probability below 0.1",
                fmt::format("{:.2g}", bound),
                "ask for a lower order",
                {}});
    return std::max(fewest_points, static_cast<int>(std::ceil(std::log(wanted_error) / std::log(bound))));
}

// Part (a); the frequencies at the points are kept for part (b).
template <class Source>
std::string residual_complaint(Source& source, std::uint64_t seed, Certificate& certificate,
                               std::vector<FrequencySample>& samples) {
    const std::shared_ptr<const GradedField> field = source.normal_form().field;
    CertificateRoots roots(*field);
    const Jacobian jacobian = jacobian_of(field->system());
    const double bound = point_error_bound(source.normal_form(), source.map(), roots) + source.error();
    const int points = points_needed(bound);
    // The bound itself follows the shape in which the expression library keeps an equation, which may
    // differ from run to run: what is said is what there are points for.
    certificate.error_probability = wanted_error;
    PointSampler sampler(*field->ring, seed);
    std::string complaint;
    int unlucky = 0;
    while (certificate.points < points) {
        try {
            Point point = sampler.next();
            const std::uint64_t prime = point.field.prime();
            const std::vector<Residue> generators = point.values;
            source.go_to(point);
            PointCheck check(source.normal_form(), source.map(), jacobian, roots, point);
            std::string here = check.complaint();
            if (here.empty() && source.normal_form().hamiltonian)
                here = canonical_complaint(source.normal_form(), source.map(), roots, point);
            if (complaint.empty()) complaint = here;
            samples.push_back(check.frequencies());
            samples.back().generators = generators;
            certificate.primes.push_back(prime);
            ++certificate.points;
        } catch (const UnluckyPoint&) {
            if (++unlucky > unlucky_points_allowed)
                refuse(
                    {"at the origin no denominator of the equations vanishes and their highest derivatives "
                     "are determined",
                     field->system().name,
                     "divide the equations by what vanishes at the origin",
                     {}});
        }
    }
    sampler.prove_roots_independent();
    return complaint;
}

template <class Source> Certificate certified(Source& source, std::uint64_t seed) {
    const NormalForm& normal_form = source.normal_form();
    Certificate certificate;
    certificate.through_weight = normal_form.field->system().weight(normal_form.through);
    certificate.complaint = shape_complaint(normal_form, source.map());
    if (!certificate.complaint.empty()) return certificate;

    std::vector<FrequencySample> samples;
    const std::string residual = residual_complaint(source, seed, certificate, samples);
    const std::string scan = scan_complaint(normal_form, source.map(), samples);
    certificate.residual_zero = residual.empty();
    certificate.normal_form_scan = scan.empty();
    certificate.holds = certificate.residual_zero && certificate.normal_form_scan;
    certificate.complaint = residual + (residual.empty() || scan.empty() ? "" : "; ") + scan;
    return certificate;
}

} // namespace

Certificate certify(const NormalForm& normal_form, const NearIdentityMap& map, std::uint64_t seed) {
    RingSource source(normal_form, map);
    return certified(source, seed);
}

Certificate certify(const GraphNormalization& normalization, std::uint64_t seed) {
    GraphSource source(normalization);
    PointSampler sampler(*source.normal_form().field->ring,
                         seed + 1); // for the shape; points of its own follow
    constexpr int tries = 8;
    for (int n = 0; n < tries; ++n) {
        try {
            source.go_to(sampler.next());
            return certified(source, seed);
        } catch (const UnluckyPoint&) {
            continue;
        }
    }
    throw std::logic_error("certify: no random point at which all divisors are non-zero");
}

} // namespace resonform
