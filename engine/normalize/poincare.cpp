// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/poincare.hpp"

#include "normalize/homological.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

constexpr int largest_weight = 99;

// Goes through the weights once: fast equations, then (their h known) the drifts.
class Normalizer {
public:
    Normalizer(std::shared_ptr<const GradedField> field, int through)
        : field_(std::move(field)), through_(through), run_(*field_->program) {
        for (std::size_t m = 0; m < field_->modes.size(); ++m)
            modes_.emplace_back(*field_, static_cast<int>(m), field_->modes[m].name,
                                equation_place(field_->modes[m].variable));
        for (const DriftVariable& d : field_->drift)
            drifts_.emplace_back(*field_, -1, d.name, equation_place(d.variable));
        transport_.mode.resize(modes_.size());
        transport_.conjugate.resize(modes_.size());
        for (const SlowVariable& s : field_->slow)
            transport_.slow.push_back(Series::split(*field_->ring, s.rate, through));
    }

    void advance(int weight) {
        for (std::size_t m = 0; m < modes_.size(); ++m) set_inputs(m, weight);
        run_.advance(weight);
        for (std::size_t m = 0; m < modes_.size(); ++m) {
            modes_[m].solve(weight, run_.part(field_->modes[m].rate, weight), transport_);
        }
        for (std::size_t m = 0; m < modes_.size(); ++m) {
            transport_.mode[m].set(weight, modes_[m].rate().part(weight));
            transport_.conjugate[m].set(weight, field_->ring->conjugate(modes_[m].rate().part(weight)));
            set_inputs(m, weight);
        }
        run_.correct(weight);
        for (std::size_t d = 0; d < drifts_.size(); ++d)
            drifts_[d].solve(weight, run_.part(field_->drift[d].rate, weight), transport_);
    }

    // What the ring must learn to divide by before the last weight can be solved.
    [[nodiscard]] std::vector<Polynomial> missing_divisors() const {
        std::vector<Polynomial> missing;
        for (const auto* equations : {&modes_, &drifts_})
            for (const HomologicalEquation& e : *equations)
                missing.insert(missing.end(), e.missing_divisors().begin(), e.missing_divisors().end());
        return missing;
    }

    [[nodiscard]] std::size_t terms() const {
        std::size_t count = 0;
        const auto add = [&](const HomologicalEquation& e) {
            for (int n = 0; n <= e.correction().through(); ++n)
                count += e.correction().part(n).size() + e.rate().part(n).size();
        };
        for (const auto& e : modes_) add(e);
        for (const auto& e : drifts_) add(e);
        return count;
    }

    Normalization result() {
        Normalization n;
        n.normal_form.field = field_;
        n.normal_form.through = through_;
        n.map.through = through_;
        for (std::size_t m = 0; m < modes_.size(); ++m) {
            Series rate = modes_[m].rate();
            rate.set(1, rate.part(1) + linear_part(field_->modes[m]));
            n.normal_form.mode.push_back(std::move(rate));
            n.map.mode.push_back(modes_[m].correction());
            n.divisors.push_back(kept(field_->modes[m].name, field_->ring->monomial(field_->modes[m].z), 1));
            append(n.divisors, modes_[m].records());
        }
        n.normal_form.slow = transport_.slow;
        for (const SlowVariable& s : field_->slow) append_rate(n.divisors, s);
        for (auto& drift : drifts_) {
            n.normal_form.drift.push_back(drift.rate());
            n.map.drift.push_back(drift.correction());
            append(n.divisors, drift.records());
        }
        return n;
    }

private:
    [[nodiscard]] Place equation_place(std::size_t variable) const {
        return place_of(field_->system().equations[variable].source);
    }

    // z = w + h: part `weight` as far as h is known.
    void set_inputs(std::size_t m, int weight) {
        const Mode& mode = field_->modes[m];
        Polynomial z = modes_[m].correction().part(weight);
        if (weight == 1) z = z + field_->ring->gen(mode.z);
        run_.set_input(mode.input_conjugate, weight, field_->ring->conjugate(z));
        run_.set_input(mode.input, weight, std::move(z));
    }

    [[nodiscard]] Polynomial linear_part(const Mode& mode) const {
        const Ring& ring = *field_->ring;
        return ring.multiply(ring.multiply(ring.imaginary(), mode.omega), ring.gen(mode.z));
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
    int through_;
    SeriesRun run_;
    std::vector<HomologicalEquation> modes_, drifts_;
    Transport transport_;
};

// Returns the divisors that are missing at the first weight that needs any.
std::vector<Polynomial> advance_through(Normalizer& normalizer, int through,
                                        const NormalizeOptions& options) {
    for (int weight = 0; weight <= through; ++weight) {
        normalizer.advance(weight);
        if (std::vector<Polynomial> missing = normalizer.missing_divisors(); !missing.empty()) return missing;
        if (options.progress) options.progress(weight, normalizer.terms());
    }
    return {};
}

} // namespace

Normalization normalize_poincare(std::shared_ptr<const GradedField> field, int through,
                                 const NormalizeOptions& options) {
    if (through < 1 || through > largest_weight)
        bad_input({fmt::format("the order of a normal form is from 1 to {}", largest_weight),
                   fmt::format("{}", through),
                   "choose an order in this range",
                   {}});
    // With several frequencies, divisors turn up as the weights go by: the ring is built anew with their
    // inverses, and the few weights below are done again.
    while (true) {
        Normalizer normalizer(field, through);
        const std::vector<Polynomial> missing = advance_through(normalizer, through, options);
        if (missing.empty()) return normalizer.result();
        field = std::make_shared<const GradedField>(with_divisors(*field, missing));
    }
}

} // namespace resonform
