// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/styles/hamiltonian.hpp"

#include "algebra/number/error.hpp"
#include "expand/expansion/graded_field.hpp"
#include "normalize/recursion/homological.hpp"
#include "normalize/styles/lie_series.hpp"
#include "normalize/styles/poisson.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

// An order is a weight above that of the quadratic part of the energy.
class HamiltonianNormalizer {
public:
    HamiltonianNormalizer(std::shared_ptr<const GradedField> field, int through)
        : field_(std::move(field)), through_(through), run_(*field_->program),
          generator_(field_->ring, brackets_of_modes(*field_)),
          equation_(*field_, RingDomain(field_->ring), -1, "H",
                    place_of(field_->system().hamiltonian->source)),
          at_rest_(carriers_of(*field_).size()), energy_(generator_),
          weight_(field_->ring->generator(field_->modes.front().z).weight),
          coordinates_(field_->modes.size(), LieSeries(generator_)), rates_(field_->modes.size()),
          map_(field_->modes.size()) {}

    [[nodiscard]] int orders() const { return through_ - weight_; }
    [[nodiscard]] int rate_weight(int order) const { return weight_ + order; }

    void advance(int order) {
        if (order == 0)
            for (int n = 0; n < 2 * weight_; ++n) advance_run(n);
        const int weight = 2 * weight_ + order;
        advance_run(weight);
        const Polynomial known = energy_.advance(run_.part(field_->energy, weight));
        solve(weight, known);
        const Polynomial& kept = equation_.rate().part(weight);
        const Polynomial& chi = equation_.correction().part(weight);
        if (order == 0) check_start(chi);
        if (order > 0) generator_.append(chi);
        energy_.complete(kept - known);
        const HamiltonianVector rates(*field_->ring, generator_.brackets(), kept);
        for (std::size_t m = 0; m < coordinates_.size(); ++m) {
            const GeneratorId z = field_->modes[m].z;
            rates_[m].set(rate_weight(order), rates.at(z));
            advance_map(m, order == 0 ? field_->ring->gen(z) : Polynomial(), order);
        }
    }

    [[nodiscard]] const std::vector<Polynomial>& missing_divisors() const {
        return equation_.missing_divisors();
    }

    [[nodiscard]] std::size_t terms() const {
        std::size_t count = 0;
        const auto add = [&](const Series& s) {
            for (int n = 0; n <= s.through(); ++n) count += s.part(n).size();
        };
        add(equation_.rate());
        add(equation_.correction());
        for (const Series& s : map_) add(s);
        return count;
    }

    Normalization result() {
        Normalization n;
        n.normal_form.field = field_;
        n.normal_form.through = through_;
        n.normal_form.style = Style::hamiltonian;
        n.normal_form.mode = std::move(rates_);
        n.map.through = through_;
        n.map.mode = std::move(map_);
        Series energy = equation_.rate();
        for (int k = 0; k < 2 * weight_; ++k) energy.set(k, run_.part(field_->energy, k));
        n.normal_form.hamiltonian =
            HamiltonianForm{generator_.brackets(), std::move(energy), equation_.correction()};
        n.divisors = std::move(equation_.records());
        for (DivisorRecord& record : n.divisors) record.weight -= weight_; // the weight in the rates
        return n;
    }

private:
    void solve(int weight, const Polynomial& known) {
        const Polynomial right = equation_.right_hand_side(weight, known, at_rest_);
        auto shares = equation_.divided(weight, right);
        equation_.accept(weight, std::move(shares.quotient), shares.exact + shares.near);
    }

    void advance_run(int weight) {
        for (const Mode& mode : field_->modes) {
            const bool here = weight == weight_;
            run_.set_input(mode.input, weight, here ? field_->ring->gen(mode.z) : Polynomial());
            if (!mode.is_real())
                run_.set_input(mode.input_conjugate, weight,
                               here ? field_->ring->gen(mode.zbar) : Polynomial());
        }
        run_.advance(weight);
    }

    void advance_map(std::size_t m, const Polynomial& part, int order) {
        Polynomial h = coordinates_[m].advance(part);
        if (order == 0) return;
        const Polynomial newest = coordinates_[m].newest();
        coordinates_[m].complete(newest);
        map_[m].set(rate_weight(order), h + newest);
    }

    void check_start(const Polynomial& generator) const {
        if (generator.empty()) return;
        refuse({"an energy holds no force as large as the fast variables themselves",
                "a term eps*" + field_->system().variables[field_->modes.front().variable].name,
                "shift to the equilibrium, or scale the force with a higher power of eps",
                place_of(field_->system().hamiltonian->source)});
    }

    std::shared_ptr<const GradedField> field_;
    int through_;
    SeriesRun run_;
    LieGenerator generator_;
    HomologicalEquation<RingDomain> equation_; // rate: K, correction: chi
    Transport<Polynomial> at_rest_;            // empty: brackets take the place of transport
    LieSeries energy_;
    int weight_; // of the modes
    std::vector<LieSeries> coordinates_;
    std::vector<Series> rates_, map_;
};

} // namespace

Normalization normalize_hamiltonian(std::shared_ptr<const GradedField> field, int through,
                                    const NormalizeOptions& options) {
    check_order(*field, through);
    field = with_derivatives(field, through + 1);
    while (true) {
        HamiltonianNormalizer normalizer(field, through);
        std::vector<Polynomial> missing;
        for (int order = 0; order <= normalizer.orders() && missing.empty(); ++order) {
            normalizer.advance(order);
            missing = normalizer.missing_divisors();
            if (missing.empty() && options.progress)
                options.progress(normalizer.rate_weight(order), normalizer.terms());
        }
        if (missing.empty()) return normalizer.result();
        field = std::make_shared<const GradedField>(with_divisors(*field, missing));
    }
}

} // namespace resonform
