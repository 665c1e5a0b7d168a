// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/frobenius.hpp"

#include "model/written_form.hpp"

#include <functional>

namespace resonform {

namespace {

using GiNaC::ex;

class Distribution {
public:
    Distribution(const SolvedConstraints& constraints, const Motion& motion)
        : constraints_(constraints), motion_(motion), slope_(constraints.slope), rest_(constraints.rest) {}

    void put(const std::function<ex(const ex&)>& change) {
        for (auto& row : slope_)
            for (ex& e : row) e = change(e);
        for (ex& e : rest_) e = change(e);
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
        for (const Prescribed& p : motion_.mechanism().prescribed)
            sum += motion_.with_laws(p.rate) * f.diff(p.coordinate.at);
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
    std::vector<ex> rest_;
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

void require_integrable_at_rest(const SolvedConstraints& constraints, const Motion& motion) {
    Distribution at_rest(constraints, motion);
    at_rest.put([&](const ex& e) { return motion.unperturbed(e); });
    const auto name = [&](std::size_t k) { return at_rest.coordinate(k).name; };
    for (std::size_t d = 0; d < constraints.dependent.size(); ++d)
        require_zero(motion, at_rest.rest(d), "at eps = 0 constraints are linear in the velocities",
                     name(constraints.dependent[d]) + "' = ... + ");
    for (std::size_t d = 0; d < constraints.dependent.size(); ++d)
        for (std::size_t i = 0; i < constraints.independent.size(); ++i)
            for (std::size_t k = i + 1; k < constraints.independent.size(); ++k)
                require_zero(motion, at_rest.term(d, i, k), "the constraints are integrable at eps = 0",
                             "the Frobenius term of " + name(constraints.dependent[d]) + "' for (" +
                                 name(constraints.independent[i]) + ", " + name(constraints.independent[k]) +
                                 ") is ");
}

bool integrable_for_every_eps(const SolvedConstraints& constraints, const Motion& motion) {
    Distribution all(constraints, motion);
    all.put([&](const ex& e) { return motion.with_laws(e); });
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
