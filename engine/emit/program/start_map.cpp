// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/start_map.hpp"

#include "solve/near_identity.hpp"

#include <utility>

namespace resonform {

namespace {

class NodeAlgebra {
public:
    using Real = Graph::Node;
    using Complex = FlowUnit;
    NodeAlgebra(Program& program, int truncation) : program_(program), truncation_(truncation) {}

    [[nodiscard]] Real number(int n) const { return graph().rational(n); }
    [[nodiscard]] Real little() const { return graph().power(program_.small, 2 * truncation_); }
    [[nodiscard]] Real gained(Real x) const {
        return graph().multiply({graph().rational(cln::expt(Rational(4), 1 - truncation_)), x});
    }
    [[nodiscard]] Real rounding(Real x) const {
        return graph().multiply({graph().rational(cln::expt(Rational(10), -20)), x});
    }
    [[nodiscard]] Real sum(std::vector<Real> terms) const { return graph().add(std::move(terms)); }
    [[nodiscard]] Real times(int n, Real x) const { return graph().multiply({number(n), x}); }
    [[nodiscard]] Real square(const Complex& x) const {
        return graph().add({graph().power(x.u, 2), graph().power(x.v, 2)});
    }
    [[nodiscard]] Complex plus(const Complex& a, const Complex& b) const {
        return {graph().add({a.u, b.u}), graph().add({a.v, b.v})};
    }
    [[nodiscard]] Complex minus(const Complex& a, const Complex& b) const {
        return {graph().add({a.u, graph().negate(b.u)}), graph().add({a.v, graph().negate(b.v)})};
    }
    void require(Real positive, const std::string& name) {
        program_.positive.push_back({positive, name, true});
    }

private:
    [[nodiscard]] Graph& graph() const { return program_.graph; }
    Program& program_;
    int truncation_;
};

class StartMap {
public:
    StartMap(Program& program, const Solution& solution, const RealForm& real,
             const Surroundings& surroundings, const StartPair& start)
        : program_(program), real_(real), surroundings_(surroundings), start_(start),
          truncation_(solution.truncation), algebra_(program, truncation_),
          moved_(moved_variables(solution)) {
        std::erase_if(moved_, [&](const MovedVariable& v) {
            return v.kind == MovedVariable::Kind::drift &&
                   (v.index >= start.now.drift.size() || start.now.drift[v.index] < 0);
        });
    }

    void require() {
        pair_up();
        FlowMoment now(program_, real_, surroundings_, start_.now, false);
        for (const MovedVariable& v : moved_) {
            at_.of(v).added = added(now, v);
            for (const Polynomial& harmonic : v.forced)
                at_.of(v).forced.push_back(now.value(harmonic, v.weight, false));
        }
        if (start_.from_constants) add_to_old();
        NearIdentity(algebra_).require(moved_, at_, start_.from_constants);
    }

private:
    [[nodiscard]] FlowUnit real(Graph::Node x) const { return {x, algebra_.number(0)}; }
    [[nodiscard]] FlowUnit added(FlowMoment& at, const MovedVariable& v) const {
        const bool mode = v.kind == MovedVariable::Kind::mode;
        const std::pair whole{v.series, truncation_};
        const bool known = start_.sums != nullptr && start_.sums->contains(whole);
        const FlowUnit value =
            at.value(known ? start_.sums->at(whole) : flow_sum(real_, v.added, v.weight, !mode));
        return mode ? value : real(value.u);
    }
    void pair_up();
    void add_to_old();

    Program& program_;
    const RealForm& real_;
    const Surroundings& surroundings_;
    const StartPair& start_;
    int truncation_;
    NodeAlgebra algebra_;
    std::vector<MovedVariable> moved_;
    StartShifts<FlowUnit> at_;
};

void StartMap::pair_up() {
    const FlowUnit zero = real(algebra_.number(0));
    const FlowValues &old = start_.old, &now = start_.now;
    for (std::size_t k = 0; k < now.modes.size(); ++k)
        at_.modes.push_back({start_.from_constants ? zero : old.modes[k], now.modes[k], zero, zero});
    for (std::size_t k = 0; k < now.slow.size(); ++k)
        at_.slow.push_back({real(old.slow[k]), real(now.slow[k]), zero, zero});
    for (const Graph::Node turn : start_.turns) at_.angles.push_back({zero, real(turn), zero, zero});
    for (std::size_t k = 0; k < now.drift.size(); ++k)
        at_.drift.push_back({real(old.drift[k]), real(now.drift[k]), zero, zero});
    for (std::size_t k = 0; k < start_.drift_terms.size(); ++k)
        for (const Graph::Node term : start_.drift_terms[k]) at_.drift[k].terms.push_back(real(term));
}

void StartMap::add_to_old() {
    FlowValues old = start_.old;
    old.modes.clear();
    for (const StartShift<FlowUnit>& mode : at_.modes)
        old.modes.push_back(algebra_.plus(mode.now, mode.added));
    FlowMoment before(program_, real_, surroundings_, old, false);
    for (const MovedVariable& v : moved_)
        if (v.kind == MovedVariable::Kind::mode) at_.of(v).added_to_old = added(before, v);
}

} // namespace

void require_near_identity(Program& program, const Solution& solution, const RealForm& real,
                           const Surroundings& surroundings, const StartPair& start) {
    StartMap(program, solution, real, surroundings, start).require();
}

void require_close_to_one(Program& program, Graph::Node factor, const std::string& variable) {
    NodeAlgebra algebra(program, 0);
    const FlowUnit one{algebra.number(1), algebra.number(0)};
    if (factor != one.u)
        NearIdentity(algebra).require_close_to_one(algebra.minus({factor, one.v}, one), variable);
}

} // namespace resonform
