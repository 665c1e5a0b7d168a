// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/first_order_system.hpp"

#include "algebra/number/elimination.hpp"
#include "algebra/number/error.hpp"
#include "model/exact/question.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/expression_field.hpp"
#include "model/text/growth.hpp"
#include "model/text/lexer.hpp"
#include "model/text/nearest.hpp"
#include "model/text/regular.hpp"

#include <algorithm>
#include <functional>
#include <optional>

namespace resonform {

namespace {

using GiNaC::ex;

// One equation on the way to its solution, with the highest derivatives found so far put in.
struct Pending {
    const Equation* equation;
    ex residual;
    std::vector<std::size_t> unknowns; // variables whose highest derivative still occurs
    std::vector<ex> coefficients;      // of the unknowns, free of all of them
    ex rest;                           // residual with all unknowns zero
};

// Solves triangular parts first (a slow rate xi' = eps v goes into the other equations, where xi' may
// then stand in any power), what remains as one linear system.
class HighestDerivatives {
public:
    explicit HighestDerivatives(const System& system) : system_(system), solved_(system.variables.size()) {
        for (const Equation& equation : system.equations) {
            pending_.push_back({&equation, equation.residual, {}, {}, {}});
        }
    }

    std::vector<ex> solve();

private:
    [[nodiscard]] const GiNaC::symbol& highest(std::size_t variable) const {
        return system_.variables[variable].jet.back();
    }
    bool solve_a_single();
    void solve_the_rest();
    void find_unknowns(Pending& p) const;
    // Fills coefficients and rest; or returns the variable in whose highest derivative it is not linear.
    [[nodiscard]] std::optional<std::size_t> linearise(Pending& p) const;
    void check_coefficient(const Pending& p, const ex& coefficient) const;
    void substitute(std::size_t variable);

    const System& system_;
    std::vector<Pending> pending_;
    std::vector<std::optional<ex>> solved_; // per variable
};

[[noreturn]] void complain(const Equation& equation, const std::string& rule, const std::string& value,
                           const std::string& hint) {
    bad_input({rule, value, hint, place_of(equation.source)});
}

// a' = 2, b' = a'^1000, c' = b'^1000, ... must not be computed.
void check_growth(const Equation& equation, const Growth& growth) {
    constexpr double most_bits = 1e6, highest_degree = 1e5;
    constexpr double deepest = 1000; // walks over expressions are recursive
    if (growth.depth > deepest)
        complain(equation, "an equation is at most 1000 levels deep when the other rates are put in",
                 excerpt(equation.text), "flatten the rates");
    if (growth.bits <= most_bits && growth.degree <= highest_degree) return;
    complain(equation, "an equation stays moderate when the other rates are put in", excerpt(equation.text),
             "use smaller exponents");
}

// Runs `build`, and complains where GiNaC divides by zero.
ex guarded(const Equation& equation, const std::function<ex()>& build) {
    const auto value = where_regular(build);
    if (!value)
        complain(equation, "an equation stays regular when the other rates are put in",
                 excerpt(equation.text), "a denominator becomes zero: correct it");
    return *value;
}

// Marks the first occurrence of a derivative in the text of its equation.
[[noreturn]] void complain_nonlinear(const Equation& equation, const Variable& variable) {
    const int primes = variable.order;
    Diagnostic d;
    d.rule = "an equation is linear in the highest derivatives, once the known rates are put in";
    d.value = variable.jet.back().get_name();
    d.hint = "solve it for " + d.value + " by hand, or introduce a variable for its lower derivative";
    d.place = place_of(equation.source);
    for (const Token& token : tokenize(equation.text, equation.source)) {
        if (token.kind == TokenKind::name && token.primes == primes &&
            equation.text.compare(token.begin, token.name_end - token.begin, variable.name) == 0) {
            d.place = place_at(equation.source, equation.text, token.begin);
            break;
        }
    }
    bad_input(d);
}

using EquationRow = std::vector<ex>; // coefficients of the unknowns, then the right-hand side

// Of expressions in the domain of a system.
struct InDomain : ExpressionField {
    explicit InDomain(const System& s) : system(s) {}
    [[nodiscard]] Zero zero(const ex& a) const { return vanishes(a, system); }

    const System& system;
};

std::vector<ex> HighestDerivatives::solve() {
    while (solve_a_single()) {
    }
    if (!pending_.empty()) solve_the_rest();
    std::vector<ex> result;
    for (const std::optional<ex>& rate : solved_) result.push_back(*rate);
    return result;
}

void HighestDerivatives::find_unknowns(Pending& p) const {
    p.unknowns.clear();
    for (std::size_t v = 0; v < solved_.size(); ++v) {
        if (!solved_[v] && p.residual.has(highest(v))) p.unknowns.push_back(v);
    }
    if (!p.unknowns.empty()) return;
    complain(*p.equation, "the equations do not determine every highest derivative",
             "none is left in the equation of '" + p.equation->variable + "'",
             "write " + system_.variable(p.equation->variable)->jet.back().get_name() + " in this equation");
}

std::optional<std::size_t> HighestDerivatives::linearise(Pending& p) const {
    const auto nonlinear_in = [&]() -> std::optional<std::size_t> {
        p.coefficients.clear();
        for (std::size_t v : p.unknowns) p.coefficients.push_back(p.residual.diff(highest(v)));
        for (std::size_t v : p.unknowns) {
            for (const ex& c : p.coefficients) {
                if (c.has(highest(v))) return v;
            }
        }
        return std::nullopt;
    };
    if (nonlinear_in()) { // perhaps only as written
        p.residual = p.residual.expand();
        if (const auto v = nonlinear_in()) return v;
    }
    GiNaC::exmap zero;
    for (std::size_t v : p.unknowns) zero[highest(v)] = 0;
    p.rest = guarded(*p.equation, [&] { return p.residual.subs(zero); });
    return std::nullopt;
}

void HighestDerivatives::check_coefficient(const Pending& p, const ex& coefficient) const {
    const std::string name = highest(p.unknowns.front()).get_name();
    const Zero zero = vanishes(coefficient, system_);
    if (zero == Zero::no) return;
    if (zero == Zero::yes) {
        complain(*p.equation, "the equations cannot be solved for the highest derivatives",
                 "the coefficient of " + name + " is zero", "correct the equations");
    }
    refuse(Reason::undecided, {"the coefficients of the highest derivatives are not proved nonzero",
                               "the one of " + name + " can be told neither zero nor nonzero",
                               "simplify the equation", place_of(p.equation->source)});
}

// The first equation that is linear in a single unknown gives it. False: there is none.
bool HighestDerivatives::solve_a_single() {
    for (std::size_t i = 0; i < pending_.size(); ++i) {
        Pending& p = pending_[i];
        find_unknowns(p);
        if (p.unknowns.size() != 1 || linearise(p)) continue;
        check_coefficient(p, p.coefficients.front());
        const std::size_t variable = p.unknowns.front();
        solved_[variable] =
            guarded(*p.equation, [&] { return ex(-p.rest * GiNaC::pow(p.coefficients.front(), -1)); });
        pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
        substitute(variable);
        return true;
    }
    return false;
}

void HighestDerivatives::substitute(std::size_t variable) {
    const Growth growth = of_expression(*solved_[variable]);
    for (Pending& p : pending_) {
        check_growth(*p.equation, of_substitution(p.residual, highest(variable), growth));
        p.residual =
            guarded(*p.equation, [&] { return p.residual.subs(highest(variable) == *solved_[variable]); });
    }
}

void HighestDerivatives::solve_the_rest() {
    std::vector<std::size_t> unknowns;
    for (std::size_t v = 0; v < solved_.size(); ++v) {
        if (!solved_[v]) unknowns.push_back(v);
    }
    const std::size_t n = unknowns.size();
    std::vector<EquationRow> rows;
    for (Pending& p : pending_) {
        if (const auto v = linearise(p)) complain_nonlinear(*p.equation, system_.variables[*v]);
        EquationRow row(n + 1, ex(0));
        for (std::size_t k = 0; k < p.unknowns.size(); ++k) {
            const auto at = std::find(unknowns.begin(), unknowns.end(), p.unknowns[k]);
            row[static_cast<std::size_t>(at - unknowns.begin())] = p.coefficients[k];
        }
        row[n] = -p.rest;
        rows.push_back(std::move(row));
    }
    if (!solve_rows(rows, InDomain(system_))) {
        complain(*pending_.front().equation, "the equations cannot be solved for the highest derivatives",
                 "the determinant of their coefficients is not known to differ from zero",
                 "correct or simplify the equations");
    }
    for (std::size_t k = 0; k < n; ++k) solved_[unknowns[k]] = rows[k].front();
}

} // namespace

const State& FirstOrderSystem::state(const std::string& name) const {
    const auto found =
        std::find_if(states.begin(), states.end(), [&](const State& s) { return s.name == name; });
    if (found == states.end()) {
        std::vector<std::string> names;
        for (const State& s : states) names.push_back(s.name);
        bad_input({"unknown state", excerpt(name), suggest(name, names), Place{}});
    }
    return *found;
}

std::size_t FirstOrderSystem::index(std::size_t variable, int derivative) const {
    std::size_t first = 0;
    for (std::size_t v = 0; v < variable; ++v) first += static_cast<std::size_t>(system->variables[v].order);
    return first + static_cast<std::size_t>(derivative);
}

std::vector<TimeDerivative> motion_of(const FirstOrderSystem& system) {
    std::vector<TimeDerivative> motion;
    for (const State& state : system.states) motion.push_back({state.symbol, state.rate});
    return motion;
}

FirstOrderSystem solve_for_highest(std::shared_ptr<const System> system) {
    const std::vector<ex> highest = HighestDerivatives(*system).solve();
    FirstOrderSystem result;
    for (std::size_t v = 0; v < system->variables.size(); ++v) {
        const Variable& variable = system->variables[v];
        for (int k = 0; k < variable.order; ++k) {
            const auto at = static_cast<std::size_t>(k);
            State state;
            state.name = variable.jet[at].get_name();
            state.variable = v;
            state.derivative = k;
            state.symbol = variable.jet[at];
            state.rate = k + 1 == variable.order ? highest[v] : ex(variable.jet[at + 1]);
            result.states.push_back(std::move(state));
        }
    }
    result.system = std::move(system);
    return result;
}

} // namespace resonform
