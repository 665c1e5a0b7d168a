// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/integrals.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/substitution.hpp"
#include "model/exact/written_form.hpp"
#include "model/integrals/antiderivative.hpp"
#include "model/mechanics/joint_integrals.hpp"
#include "model/system/mechanism.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

class Search {
public:
    Search(const SolvedConstraints& constraints, Motion& motion)
        : constraints_(constraints), motion_(motion), form_(motion.form()),
          found_(constraints.dependent.size()) {}

    std::vector<Constant> run() {
        take_those_of_the_file();
        GiNaC::exmap values; // of the integrals that the engine finds
        for (std::size_t d = 0; d < found_.size(); ++d) {
            if (found_[d]) continue;
            found_[d] = stays(d) ? itself(d) : integrated(d);
            values[dependent(d).at] = found_[d]->value;
        }
        std::vector<Constant> constants;
        for (const auto& found : found_) {
            constants.push_back(*found);
            constants.back().value = put(found->value, values);
        }
        return constants;
    }

private:
    const Coordinate& dependent(std::size_t d) const {
        return motion_.mechanism().coordinates[constraints_.dependent[d]];
    }
    const Coordinate& independent(std::size_t i) const {
        return motion_.mechanism().coordinates[constraints_.independent[i]];
    }
    ex slope(std::size_t d, std::size_t i) const { return motion_.unperturbed(constraints_.slope[d][i]); }
    bool zero(const ex& e) const { return form_.vanishes(e) == Zero::yes; }
    ex rest(std::size_t d) const { return motion_.unperturbed(constraints_.rest[d]); }
    bool stays(std::size_t d) const {
        if (!zero(rest(d))) return false;
        for (std::size_t i = 0; i < constraints_.independent.size(); ++i)
            if (!zero(slope(d, i))) return false;
        return true;
    }
    Constant itself(std::size_t d) const { return {dependent(d), dependent(d).at, d, dependent(d).at, true}; }

    // The derivatives of phi along an independent coordinate, and along the prescribed motions, at eps = 0.
    ex along(const ex& phi, std::size_t i) const;
    ex along_time(const ex& phi) const;
    void require_constant(const Integral& integral, const ex& rate, const std::string& velocity) const;
    void take_those_of_the_file();
    Constant integrated(std::size_t d);
    ex potential(std::size_t d) const;
    ex moving_part(std::size_t d, const ex& sum) const;
    std::optional<ex> integral_of(const ex& slope, const GiNaC::symbol& x) const;
    [[noreturn]] void not_found(std::size_t d) const;

    const SolvedConstraints& constraints_;
    Motion& motion_;
    ExactForm& form_;
    std::vector<std::optional<Constant>> found_;
};

ex Search::along(const ex& phi, std::size_t i) const {
    ex sum = phi.diff(independent(i).at);
    for (std::size_t d = 0; d < found_.size(); ++d) sum += slope(d, i) * phi.diff(dependent(d).at);
    return motion_.unperturbed(sum);
}

ex Search::along_time(const ex& phi) const {
    ex sum = 0;
    for (const Prescribed& p : motion_.mechanism().prescribed) sum += p.rate * phi.diff(p.coordinate.at);
    for (std::size_t d = 0; d < found_.size(); ++d) sum += rest(d) * phi.diff(dependent(d).at);
    return motion_.unperturbed(sum);
}

void Search::require_constant(const Integral& integral, const ex& rate, const std::string& velocity) const {
    const Zero constant = form_.vanishes(rate);
    if (constant == Zero::yes) return;
    const std::string value = "its derivative holds (" + excerpt(written(form_, rate)) + ")" + velocity;
    const Place place = place_of(integral.value.source);
    if (constant == Zero::no) bad_input({"an integral is constant at eps = 0", value, "correct it", place});
    refuse(Reason::undecided,
           {"an integral is seen to be constant at eps = 0", value, "write it in a plainer form", place});
}

void Search::take_those_of_the_file() {
    for (const Integral& integral : motion_.mechanism().integrals) {
        const ex phi = integral.value.value;
        for (std::size_t i = 0; i < constraints_.independent.size(); ++i)
            require_constant(integral, along(phi, i), "*" + independent(i).name + "'");
        require_constant(integral, along_time(phi), "");
    }
    std::vector<std::size_t> preferred; // those that are not constant themselves come first
    for (const bool constant : {false, true})
        for (std::size_t d = 0; d < found_.size(); ++d)
            if (stays(d) == constant) preferred.push_back(d);
    for (const auto& [integral, d, value] : solve_integrals(constraints_, motion_, preferred))
        found_[d] = Constant{integral->coordinate, integral->value.value, d, value, false};
}

void Search::not_found(std::size_t d) const {
    refuse({"an integral of the constraints at eps = 0 is found where it is elementary",
            "none for " + dependent(d).name, "give it, as R = \"...\" under [integrals]",
            place_of(motion_.mechanism().constraints.front().condition.source)});
}

// W in independent and prescribed coordinates: dW/dx_i = slope, and along the prescribed motions W' = rest.
ex Search::potential(std::size_t d) const {
    ex sum = 0;
    for (std::size_t i = 0; i < constraints_.independent.size(); ++i) {
        const auto part = integral_of(slope(d, i) - sum.diff(independent(i).at), independent(i).at);
        if (!part) not_found(d);
        sum += *part;
    }
    sum += moving_part(d, sum);
    if (!zero(along_time(sum) - rest(d))) not_found(d);
    for (std::size_t i = 0; i < constraints_.independent.size(); ++i)
        if (!zero(sum.diff(independent(i).at) - slope(d, i))) not_found(d);
    return sum;
}

std::optional<ex> Search::integral_of(const ex& slope, const GiNaC::symbol& x) const {
    const ex plain = form_.simplified(slope);
    for (std::size_t k = 0; k < found_.size(); ++k)
        if (plain.has(dependent(k).at)) return std::nullopt;
    const auto positive = [&](const ex& e) { return motion_.positive_where_expanded(e); };
    const auto f = antiderivative(plain, x, positive);
    return f && zero(f->diff(x) - plain) ? f : std::nullopt;
}

// The part of W that depends on coordinates moving at eps = 0, where `sum` is the other part: first from the
// terms c*s' of the constraint, then from the rest of the rate by one of the laws, c/V*s'.
ex Search::moving_part(std::size_t d, const ex& sum) const {
    ex part = 0;
    const std::vector<const Prescribed*> moving = motion_.moving();
    for (const Prescribed* p : moving) {
        const ex c = motion_.unperturbed(constraints_.rest[d].diff(p->coordinate.velocity));
        if (const auto f = integral_of(c - (sum + part).diff(p->coordinate.at), p->coordinate.at)) part += *f;
    }
    const ex left = form_.simplified(rest(d) - along_time(sum + part));
    for (const Prescribed* p : moving)
        if (const auto f = integral_of(left / motion_.unperturbed(p->rate), p->coordinate.at);
            f && zero(along_time(*f) - left))
            return part + *f;
    return part;
}

Constant Search::integrated(std::size_t d) {
    const ex sum = potential(d);
    Coordinate r = dependent(d);
    r.name = name_of_integral(r);
    r.at = GiNaC::symbol(r.name);
    r.velocity = GiNaC::symbol(r.name + "'");
    r.acceleration = GiNaC::symbol(r.name + "''");
    motion_.add(r);
    return {r, dependent(d).at - sum, d, r.at + sum, false};
}

} // namespace

std::vector<Constant> find_constants(const SolvedConstraints& constraints, Motion& motion) {
    return Search(constraints, motion).run();
}

} // namespace resonform
