// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/frobenius.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/written_form.hpp"
#include "model/text/diagnostic.hpp"

#include <functional>

namespace resonform {

namespace {

using GiNaC::ex;

using Reading = std::function<ex(const ex&)>;

class Distribution {
public:
    Distribution(const SolvedConstraints& constraints, const Motion& motion, const Reading& change)
        : constraints_(constraints), motion_(motion), slope_(constraints.slope) {
        for (auto& row : slope_)
            for (ex& e : row) e = change(e);
        for (const ex& e : constraints.rest) rest_.push_back(change(e));
        for (const Prescribed& p : motion.mechanism().prescribed) rate_.push_back(change(p.rate));
    }
    [[nodiscard]] const ex& rest(std::size_t d) const { return rest_[d]; }

    // X_i(f)
    [[nodiscard]] ex along(std::size_t i, const ex& f) const {
        ex sum = f.diff(coordinate(constraints_.independent[i]).at);
        for (std::size_t d = 0; d < slope_.size(); ++d)
            sum += slope_[d][i] * f.diff(coordinate(constraints_.dependent[d]).at);
        return sum;
    }
    // X_0(f)
    [[nodiscard]] ex along_time(const ex& f) const {
        ex sum = 0;
        for (std::size_t p = 0; p < rate_.size(); ++p)
            sum += rate_[p] * f.diff(motion_.mechanism().prescribed[p].coordinate.at);
        for (std::size_t d = 0; d < slope_.size(); ++d)
            sum += rest_[d] * f.diff(coordinate(constraints_.dependent[d]).at);
        return sum;
    }
    [[nodiscard]] ex term(std::size_t d, std::size_t i, std::size_t k) const {
        return along(i, slope_[d][k]) - along(k, slope_[d][i]);
    }
    [[nodiscard]] ex term_of_time(std::size_t d, std::size_t i) const {
        return along(i, rest_[d]) - along_time(slope_[d][i]);
    }
    [[nodiscard]] const Coordinate& coordinate(std::size_t k) const {
        return motion_.mechanism().coordinates[k];
    }

private:
    const SolvedConstraints& constraints_;
    const Motion& motion_;
    std::vector<std::vector<ex>> slope_;
    std::vector<ex> rest_, rate_;
};

[[noreturn]] void not_integrable(const Motion& motion, const std::string& rule, const std::string& value) {
    refuse({rule, value,
            "scale what cannot be integrated by eps: the method is for weakly nonholonomic systems",
            place_of(motion.mechanism().constraints.front().condition.source)});
}

void require_zero(const Motion& motion, const ex& term, const std::string& rule, const std::string& where) {
    const Zero zero = motion.form().vanishes(term);
    if (zero == Zero::yes) return;
    not_integrable(motion, zero == Zero::no ? rule : rule + ", and are seen to be",
                   where + excerpt(written(motion.form(), term)));
}

} // namespace

void require_integrable_unperturbed(const SolvedConstraints& constraints, const Motion& motion) {
    const Distribution unperturbed(constraints, motion, [&](const ex& e) { return motion.unperturbed(e); });
    const auto name = [&](std::size_t k) { return unperturbed.coordinate(k).name; };
    const auto independent = [&](std::size_t i) { return name(constraints.independent[i]); };
    const bool at_rest = motion.moving().empty();
    for (std::size_t d = 0; at_rest && d < constraints.dependent.size(); ++d)
        require_zero(motion, unperturbed.rest(d), "at eps = 0 constraints are linear in the velocities",
                     name(constraints.dependent[d]) + "' = ... + ");
    for (std::size_t d = 0; d < constraints.dependent.size(); ++d) {
        const auto require_term = [&](const ex& term, std::size_t i, const std::string& other) {
            require_zero(motion, term, "the constraints are integrable at eps = 0",
                         "the Frobenius term of " + name(constraints.dependent[d]) + "' for (" +
                             independent(i) + ", " + other + ") is ");
        };
        for (std::size_t i = 0; i < constraints.independent.size(); ++i) {
            for (std::size_t k = i + 1; k < constraints.independent.size(); ++k)
                require_term(unperturbed.term(d, i, k), i, independent(k));
            require_term(unperturbed.term_of_time(d, i), i, "time");
        }
    }
}

bool integrable_for_every_eps(const SolvedConstraints& constraints, const Motion& motion) {
    const Distribution all(constraints, motion, [&](const ex& e) { return motion.with_laws(e); });
    const auto zero = [&](const ex& e) { return motion.form().vanishes(e) == Zero::yes; };
    for (std::size_t d = 0; d < constraints.dependent.size(); ++d)
        for (std::size_t i = 0; i < constraints.independent.size(); ++i) {
            if (!zero(all.term_of_time(d, i))) return false;
            for (std::size_t k = i + 1; k < constraints.independent.size(); ++k)
                if (!zero(all.term(d, i, k))) return false;
        }
    return true;
}

} // namespace resonform
