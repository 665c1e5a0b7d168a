// SPDX-License-Identifier: GPL-3.0-or-later
// The recursion over the weights, whatever the domain of the coefficients and the style.
#pragma once

#include "algebra/number/error.hpp"
#include "expand/expansion/graded_field.hpp"
#include "model/system/style.hpp"
#include "normalize/recursion/homological.hpp"
#include "normalize/recursion/options.hpp"

#include <fmt/format.h>

#include <memory>

namespace resonform {

// A rate without lambda w has no linear terms in w: they cancel exactly where coefficients are exact.
template <class Domain, class Part> Part without_linear(const Domain&, Part p, int) { return p; }
inline NumberPart without_linear(const NumberDomain& domain, const NumberPart& p, int weight) {
    return domain.without_linear(p, weight);
}

// Goes through the weights once. At each weight, equations are solved after those they depend on:
// small fast variables, those of larger weight first -> slow -> fast variables of weight 0 -> angles ->
// drift. (k_n reaches the angles at weight n as omega' k_n, and finite fast variables as A' k_n w; small ones
// reach slow rates, and those of fast variables of lower weight, as g_u h_n.)
template <class Domain> class Normalizer {
public:
    using Part = typename Domain::Part;
    using Equation = HomologicalEquation<Domain>;
    using Style = HomologicalStyle<Domain>;

    Normalizer(std::shared_ptr<const GradedField> field, const Domain& domain, std::unique_ptr<Style> style,
               int through)
        : field_(std::move(field)), domain_(domain), style_(std::move(style)), through_(through),
          weights_(field_->mode_weights()), run_(*field_->program, domain) {
        for (std::size_t m = 0; m < field_->modes.size(); ++m)
            modes_.push_back(equation(static_cast<int>(m), field_->modes[m].name, field_->modes[m].variable));
        for (const SlowVariable& s : field_->slow) slow_.push_back(equation(-1, s.name, s.variable));
        for (const AngleVariable& a : field_->angles) angles_.push_back(equation(-1, a.name, a.variable));
        for (const DriftVariable& d : field_->drift) drifts_.push_back(equation(-1, d.name, d.variable));
        for (const Mode& m : field_->modes) {
            transport_.emplace_back();
            if (!m.is_real()) transport_.emplace_back();
        }
        for (const SlowVariable& s : field_->slow)
            transport_.push_back(s.driven ? BasicSeries<Part>() : split(s.rate));
        transport_.resize(transport_.size() + angles_.size());
    }

    void advance(int weight) {
        for (std::size_t m = 0; m < modes_.size(); ++m) set_mode(m, weight);
        for (std::size_t s = 0; s < slow_.size(); ++s) set_slow(s, weight);
        for (std::size_t a = 0; a < angles_.size(); ++a) run_.set_input(field_->angles[a].input, weight, {});
        run_.advance(weight);
        for (const int of_modes : weights_)
            if (of_modes > 0) solve_modes(weight, of_modes);
        solve_slow(weight);
        if (!weights_.empty() && weights_.back() == 0) solve_modes(weight, 0);
        for (std::size_t a = 0; a < angles_.size(); ++a) {
            solve({&angles_[a]}, {field_->angles[a].rate}, weight);
            transport_[first_angle() + a].set(weight, angles_[a].rate().part(weight));
            run_.set_input(field_->angles[a].input, weight, angles_[a].correction().part(weight));
        }
        if (!angles_.empty()) run_.correct(weight);
        for (std::size_t d = 0; d < drifts_.size(); ++d)
            solve({&drifts_[d]}, {field_->drift[d].rate}, weight);
        run_.forget();
    }

    // Divisors that the ring must get an inverse for before the last weight can be solved.
    [[nodiscard]] std::vector<Polynomial> missing_divisors() const {
        std::vector<Polynomial> missing;
        for (const auto* equations : {&modes_, &slow_, &angles_, &drifts_})
            for (const Equation& e : *equations)
                missing.insert(missing.end(), e.missing_divisors().begin(), e.missing_divisors().end());
        return missing;
    }

    [[nodiscard]] std::size_t terms() const {
        std::size_t count = 0;
        for (const auto* equations : {&modes_, &slow_, &angles_, &drifts_})
            for (const Equation& e : *equations)
                for (int n = 0; n <= e.correction().through(); ++n)
                    count += e.correction().part(n).size() + e.rate().part(n).size();
        return count;
    }

    NormalizationOf<Part> result() {
        NormalizationOf<Part> n;
        n.normal_form.field = field_;
        n.normal_form.through = through_;
        n.map.through = through_;
        const Ring& ring = *field_->ring;
        for (std::size_t m = 0; m < modes_.size(); ++m) {
            const Mode& mode = field_->modes[m];
            const int weight = ring.generator(mode.z).weight;
            BasicSeries<Part> rate = modes_[m].rate();
            rate.set(weight, plus(rate.part(weight), field_->linear_part(m)));
            n.normal_form.mode.push_back(std::move(rate));
            n.map.mode.push_back(modes_[m].correction());
            n.divisors.push_back(kept(mode.name, ring.monomial(mode.z), weight));
            for (const ModeCoupling& c : field_->couplings(m))
                n.divisors.push_back(kept(mode.name, ring.monomial(field_->modes[c.mode].z), weight));
            append(n.divisors, modes_[m].records());
        }
        for (std::size_t a = 0; a < angles_.size(); ++a) {
            BasicSeries<Part> rate = angles_[a].rate();
            rate.set(0, plus(rate.part(0), field_->angles[a].frequency));
            n.normal_form.angle.push_back(std::move(rate));
            n.map.angle.push_back(angles_[a].correction());
            n.divisors.push_back(kept(field_->angles[a].name, {}, 0));
            append(n.divisors, angles_[a].records());
        }
        for (std::size_t s = 0; s < slow_.size(); ++s) {
            n.normal_form.slow.push_back(transport_[first_slow() + s]);
            n.map.slow.push_back(slow_[s].correction());
            if (!field_->slow[s].driven) append_rate(n.divisors, field_->slow[s]);
            append(n.divisors, slow_[s].records());
        }
        for (auto& drift : drifts_) {
            n.normal_form.drift.push_back(drift.rate());
            n.map.drift.push_back(drift.correction());
            append(n.divisors, drift.records());
        }
        return n;
    }

private:
    [[nodiscard]] Equation equation(int mode, const std::string& name, std::size_t variable) const {
        return {*field_, domain_, mode, name, place_of(field_->system().equations[variable].source)};
    }

    [[nodiscard]] Part plus(const Part& part, const Polynomial& p) const {
        const Part addend = domain_.constant(p);
        return domain_.combination({{1, &part}, {1, &addend}});
    }

    [[nodiscard]] BasicSeries<Part> split(const Polynomial& p) const {
        BasicSeries<Part> series;
        const std::vector<Polynomial> parts = field_->ring->by_weight(p, through_);
        for (int n = 0; n <= through_; ++n)
            series.set(n, domain_.constant(parts[static_cast<std::size_t>(n)]));
        return series;
    }

    [[nodiscard]] std::size_t first_angle() const { return transport_.size() - angles_.size(); }
    [[nodiscard]] std::size_t first_slow() const { return first_angle() - slow_.size(); }

    // z = w + h: part `weight` as far as h is known.
    void set_mode(std::size_t m, int weight) {
        const Mode& mode = field_->modes[m];
        Part z = modes_[m].correction().part(weight);
        if (weight == field_->ring->generator(mode.z).weight) z = plus(z, field_->ring->gen(mode.z));
        if (!mode.is_real()) run_.set_input(mode.input_conjugate, weight, domain_.conjugate(z));
        run_.set_input(mode.input, weight, std::move(z));
    }

    // xi = zeta + k
    void set_slow(std::size_t s, int weight) {
        const SlowVariable& slow = field_->slow[s];
        if (!slow.driven) return;
        run_.set_input(slow.input, weight,
                       weight == 0 ? domain_.constant(field_->ring->gen(slow.generator))
                                   : slow_[s].correction().part(weight));
    }

    // Equations that belong together, given the nodes of their rates.
    void solve(const std::vector<Equation*>& equations, const std::vector<SeriesProgram::Node>& rates,
               int weight) {
        std::vector<Part> right;
        for (std::size_t k = 0; k < equations.size(); ++k) {
            right.push_back(equations[k]->right_hand_side(weight, run_.part(rates[k], weight), transport_));
            if (const int m = equations[k]->mode(); m >= 0 && weight == weight_of(m))
                right.back() = without_linear(domain_, std::move(right.back()), weight);
        }
        if (weight == through_)
            for (Equation* e : equations) e->finish();
        style_->solve(weight, equations, right);
    }

    [[nodiscard]] int weight_of(int mode) const {
        return field_->ring->generator(field_->modes[static_cast<std::size_t>(mode)].z).weight;
    }

    void solve_modes(int weight, int weight_of_modes) {
        std::vector<Equation*> equations;
        std::vector<SeriesProgram::Node> rates;
        const auto is_one = [&](const Mode& mode) {
            return field_->ring->generator(mode.z).weight == weight_of_modes;
        };
        for (std::size_t m = 0; m < modes_.size(); ++m) {
            if (!is_one(field_->modes[m])) continue;
            equations.push_back(&modes_[m]);
            rates.push_back(field_->modes[m].rate);
        }
        solve(equations, rates, weight);
        std::size_t carrier = 0;
        for (std::size_t m = 0; m < modes_.size(); ++m) {
            const std::size_t own = carrier;
            carrier += field_->modes[m].is_real() ? 1 : 2;
            if (!is_one(field_->modes[m])) continue;
            if (weight == weight_of_modes) check_start(m, weight);
            const Part& rate = modes_[m].rate().part(weight);
            transport_[own].set(weight, rate);
            if (!field_->modes[m].is_real()) transport_[own + 1].set(weight, domain_.conjugate(rate));
            set_mode(m, weight);
        }
        run_.correct(weight);
    }

    // Requires that the normal form of a mode has no terms at its own weight besides lambda w + n w.
    void check_start(std::size_t m, int weight) const {
        const Part& rate = modes_[m].rate().part(weight);
        if (rate.empty()) return;
        const Mode& mode = field_->modes[m];
        const bool one_weight = weights_.size() == 1;
        refuse(Reason::resonance,
               {one_weight ? "a forcing as large as the fast variables themselves is not resonant with them"
                           : "a term of the weight of the fast variable in whose rate it stands is not "
                             "resonant with it",
                fmt::format("in the normal form of {} at weight {}", mode.name,
                            to_string(field_->system().weight(weight))),
                one_weight ? "scale the forcing with a higher power of eps"
                           : "give the variable a lower weight, or scale the term with a power of eps",
                place_of(field_->system().equations[mode.variable].source)});
    }

    void solve_slow(int weight) {
        bool any = false;
        for (std::size_t s = 0; s < slow_.size(); ++s) {
            if (!field_->slow[s].driven) continue;
            solve({&slow_[s]}, {field_->slow[s].rate_node}, weight);
            any = true;
        }
        if (!any) return;
        for (std::size_t s = 0; s < slow_.size(); ++s) {
            if (!field_->slow[s].driven) continue;
            transport_[first_slow() + s].set(weight, slow_[s].rate().part(weight));
            if (weight > 0) set_slow(s, weight);
        }
        run_.correct(weight);
    }

    // Divisors that no equation had to ask for: lambda_j of a mode's own linear term, and 0 of rates that
    // hold no fast variable.
    static DivisorRecord kept(const std::string& variable, const Monomial& monomial, int weight) {
        return {variable, monomial, weight, {}, DivisorVerdict::kept_exact};
    }

    void append_rate(std::vector<DivisorRecord>& records, const SlowVariable& slow) const {
        const Ring& ring = *field_->ring;
        for (const auto& [monomial, coefficient] : ring.collect(slow.rate, {field_->eps}))
            records.push_back(kept(slow.name, monomial, ring.weight(monomial)));
    }

    static void append(std::vector<DivisorRecord>& to, std::vector<DivisorRecord>& from) {
        std::move(from.begin(), from.end(), std::back_inserter(to));
    }

    std::shared_ptr<const GradedField> field_;
    Domain domain_;
    std::unique_ptr<Style> style_;
    int through_;
    std::vector<int> weights_; // of the modes, descending
    BasicSeriesRun<Domain> run_;
    std::vector<Equation> modes_, slow_, angles_, drifts_;
    Transport<Part> transport_; // by carrier: modes with their conjugates, slow variables, angles
};

// Returns the divisors that are missing at the first weight that needs any.
template <class Domain>
std::vector<Polynomial> advance_through(Normalizer<Domain>& normalizer, int through,
                                        const NormalizeOptions& options) {
    for (int weight = 0; weight <= through; ++weight) {
        normalizer.advance(weight);
        if (std::vector<Polynomial> missing = normalizer.missing_divisors(); !missing.empty()) return missing;
        if (options.progress) options.progress(weight, normalizer.terms());
    }
    return {};
}

// With coefficients in the ring of the field, to which small divisors are added as they turn up;
// StyleOf(field) makes the style.
template <class StyleOf>
Normalization normalize_in_ring(std::shared_ptr<const GradedField> field, int through,
                                const NormalizeOptions& options, const StyleOf& style_of) {
    // With several frequencies, divisors turn up as the weights go by: the ring is built anew with their
    // inverses, and the few weights below are done again.
    field = with_derivatives(field, through + 1);
    while (true) {
        Normalizer<RingDomain> normalizer(field, RingDomain(field->ring), style_of(*field), through);
        const std::vector<Polynomial> missing = advance_through(normalizer, through, options);
        if (missing.empty()) return normalizer.result();
        field = std::make_shared<const GradedField>(with_divisors(*field, missing));
    }
}

} // namespace resonform
