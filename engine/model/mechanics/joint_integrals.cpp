// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/joint_integrals.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/inverse_function.hpp"
#include "model/exact/substitution.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

class JointSolution {
public:
    JointSolution(const SolvedConstraints& constraints, const Motion& motion,
                  const std::vector<std::size_t>& preferred)
        : constraints_(constraints), motion_(motion), preferred_(preferred) {
        for (const Integral& integral : motion.mechanism().integrals) open_.push_back(&integral);
        for (const Change& change : motion.mechanism().changes) take(change);
    }

    std::vector<SolvedIntegral> run() {
        while (!open_.empty())
            if (!follows() && !solve_one()) give_up();
        for (const auto& [d, change] : changes_)
            bad_input({"what [change] says of a dependent coordinate inverts an integral of the file",
                       in_quotes(coordinate(d).name) + " is dependent, and has no integral",
                       "give it under [integrals], or leave the change out", place_of(change->value.source)});
        std::vector<SolvedIntegral> result;
        for (const auto& [integral, d] : pairs_) result.push_back({integral, d, resolved(coordinate(d).at)});
        return result;
    }

private:
    [[nodiscard]] const Coordinate& coordinate(std::size_t d) const {
        return motion_.mechanism().coordinates[constraints_.dependent[d]];
    }
    [[nodiscard]] ex residual(const Integral& integral) const {
        return resolved(integral.value.value - integral.coordinate.at);
    }
    void take(const Change& change);
    [[nodiscard]] ex resolved(const ex& e) const;
    [[nodiscard]] ex in_new_variables(const ex& e) const { return put(resolved(e), independent_changes_); }
    bool follows();
    bool solve_one();
    bool solve(const Integral& integral, bool by_one_only);
    [[nodiscard]] Inverse inverted(const ex& left, const GiNaC::symbol& y) const;
    void close(const Integral* integral, std::size_t d);
    [[nodiscard]] std::vector<std::size_t> unknowns_in(const ex& e) const;
    [[noreturn]] void give_up() const;
    [[noreturn]] void does_not_invert(const Change& change) const;

    const SolvedConstraints& constraints_;
    const Motion& motion_;
    const std::vector<std::size_t>& preferred_;
    std::vector<const Integral*> open_;
    std::vector<std::pair<const Integral*, std::size_t>> pairs_;
    std::vector<std::pair<std::size_t, const Change*>> changes_; // whose integrals are not met yet
    GiNaC::exmap values_, independent_changes_;
    std::string obstacle_; // to solving the first integral that could not be
};

void JointSolution::take(const Change& change) {
    const auto found =
        std::find(constraints_.dependent.begin(), constraints_.dependent.end(), change.coordinate);
    const ex old = motion_.mechanism().coordinates[change.coordinate].at;
    if (found == constraints_.dependent.end()) {
        independent_changes_[old] = change.value.value;
        return;
    }
    values_[old] = change.value.value;
    changes_.emplace_back(found - constraints_.dependent.begin(), &change);
}

// e with the values of coordinates put in, which may hold other ones.
ex JointSolution::resolved(const ex& e) const {
    if (const auto value = put_through(e, values_)) return *value;
    const Change& change = *changes_.front().second;
    bad_input({"changes of variables do not hold each other in a circle", in_quotes(change.value.text),
               "write it in what remains", place_of(change.value.source)});
}

// Assigns an integral that the known values satisfy to a change of variables. False: there is none.
bool JointSolution::follows() {
    for (const Integral* integral : open_) {
        const auto change = std::find_if(changes_.begin(), changes_.end(), [&](const auto& c) {
            return integral->value.value.has(coordinate(c.first).at);
        });
        if (change == changes_.end() ||
            motion_.form().vanishes(in_new_variables(residual(*integral))) != Zero::yes)
            continue;
        const std::size_t d = change->first;
        changes_.erase(change);
        close(integral, d);
        return true;
    }
    return false;
}

void JointSolution::close(const Integral* integral, std::size_t d) {
    pairs_.emplace_back(integral, d);
    open_.erase(std::find(open_.begin(), open_.end(), integral));
}

std::vector<std::size_t> JointSolution::unknowns_in(const ex& e) const {
    std::vector<std::size_t> unknowns;
    for (const std::size_t d : preferred_)
        if (motion_.form().vanishes(e.diff(coordinate(d).at)) != Zero::yes) unknowns.push_back(d);
    return unknowns;
}

// Integrals with one unknown coordinate first, so that a triangular system stays triangular.
bool JointSolution::solve_one() {
    obstacle_.clear();
    for (const bool by_one_only : {true, false})
        for (const Integral* integral : open_)
            if (solve(*integral, by_one_only)) return true;
    return false;
}

bool JointSolution::solve(const Integral& integral, bool by_one_only) {
    const ex left = motion_.form().simplified(residual(integral));
    const std::vector<std::size_t> unknowns = unknowns_in(left);
    if (by_one_only && unknowns.size() != 1) return false;
    for (const std::size_t d : unknowns) {
        const Inverse inverse = inverted(left, coordinate(d).at);
        if (inverse.value) {
            values_[coordinate(d).at] = *inverse.value;
            close(&integral, d);
            return true;
        }
        if (obstacle_.empty())
            obstacle_ = inverse.obstacle.empty() ? "not for " + coordinate(d).name
                                                 : "for " + coordinate(d).name + " where " +
                                                       inverse.obstacle + ", which is not proved";
    }
    return false;
}

// y/(1 + y) - R is zero where its numerator is; a denominator without roots may have changed that, so that
// the solution is checked in the original.
Inverse JointSolution::inverted(const ex& left, const GiNaC::symbol& y) const {
    ExactForm& form = motion_.form();
    const auto positive = [&](const ex& e) { return motion_.positive_where_expanded(resolved(e)); };
    Inverse inverse = inverse_function(left, y, 0, form, positive);
    if (inverse.value || !inverse.obstacle.empty()) return inverse;
    const ex numerator = form.meaning(form.fraction(left).numerator);
    const Inverse other = inverse_function(numerator, y, 0, form, positive);
    if (other.value && form.vanishes(left.subs(y == *other.value)) == Zero::yes) inverse = other;
    return inverse;
}

void JointSolution::does_not_invert(const Change& change) const {
    bad_input({"a change of variables inverts the integral", in_quotes(change.value.text),
               "correct one of the two", place_of(change.value.source)});
}

void JointSolution::give_up() const {
    const Integral& integral = *open_.front();
    const Place place = place_of(integral.value.source);
    if (obstacle_.empty() && !changes_.empty()) does_not_invert(*changes_.front().second);
    if (obstacle_.empty())
        bad_input({"a constraint has two integrals", in_quotes(integral.coordinate.name) + " is one more",
                   "leave it out", place});
    refuse({"an integral can be solved for a coordinate that it replaces", obstacle_,
            "solve it: write the coordinate as \"...\" in " + integral.coordinate.name + " under [change]",
            place});
}

} // namespace

std::vector<SolvedIntegral> solve_integrals(const SolvedConstraints& constraints, const Motion& motion,
                                            const std::vector<std::size_t>& preferred) {
    return JointSolution(constraints, motion, preferred).run();
}

} // namespace resonform
