// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/equilibrium_roots.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/question.hpp"
#include "model/exact/substitution.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/regular.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

using GiNaC::ex;

// One unknown after the other, each with all its values.
class Elimination {
public:
    explicit Elimination(const RootsOfForces& task) : task_(task) {}

    std::vector<GiNaC::exmap> run() {
        std::vector<std::size_t> left;
        for (std::size_t k = 0; k < task_.unknowns.size(); ++k) left.push_back(k);
        go_on(task_.forces, left, {});
        return std::move(found_);
    }

private:
    struct Choice {
        std::size_t unknown;
        ex numerator;
    };
    void go_on(const std::vector<ex>& forces, const std::vector<std::size_t>& left,
               const GiNaC::exmap& known);
    [[nodiscard]] std::optional<Choice> choose(const std::vector<ex>& forces,
                                               const std::vector<std::size_t>& left) const;
    [[nodiscard]] std::vector<ex> roots(const Choice& choice) const;
    void add_roots(std::vector<ex>& roots, const ex& factor, std::size_t unknown) const;
    void require_nonzero(const ex& divisor, std::size_t unknown) const;
    [[noreturn]] void refuse_kind(std::size_t unknown, const std::string& why) const;

    const RootsOfForces& task_;
    std::vector<GiNaC::exmap> found_;
};

// What the expression is zero with, its functions and roots as they are; nullopt: it divides by zero.
std::optional<ex> numerator_of(const ex& force) {
    return where_regular([&] {
        GiNaC::exmap functions;
        const ex rational = force.to_rational(functions);
        return put(rational.normal().numer().expand(), functions);
    });
}

// The factors over the rational numbers, in the order of their spelling, with functions and roots as symbols.
std::vector<ex> factors_over_numbers(const ex& polynomial, const GiNaC::symbol& unknown) {
    GiNaC::exmap functions;
    const ex plain = polynomial.to_polynomial(functions);
    std::vector<ex> factors;
    for (const ex& factor : factors_of(GiNaC::factor(plain))) {
        const bool power = GiNaC::is_a<GiNaC::power>(factor);
        const ex base = put(power ? factor.op(0) : factor, functions);
        if (base.has(unknown)) factors.push_back(base.expand());
    }
    return factors;
}

void Elimination::go_on(const std::vector<ex>& forces, const std::vector<std::size_t>& left,
                        const GiNaC::exmap& known) {
    if (left.empty()) {
        found_.push_back(known);
        return;
    }
    const auto choice = choose(forces, left);
    if (!choice) refuse_kind(left.front(), "no equation is linear in it, or a polynomial in it alone");
    std::vector<std::size_t> rest = left;
    std::erase(rest, choice->unknown);
    for (const ex& root : roots(*choice)) {
        const GiNaC::exmap here{{task_.unknowns[choice->unknown], root}};
        const auto put_in = [&](const ex& e) { return where_regular([&] { return put(e, here).normal(); }); };
        std::vector<ex> next;
        for (const ex& force : forces)
            if (const auto value = put_in(force)) next.push_back(*value);
        GiNaC::exmap values = here;
        for (const auto& [symbol, value] : known) values[symbol] = put_in(value).value_or(value);
        if (next.size() == forces.size()) go_on(next, rest, values); // else a pole: no equilibrium
    }
}

// First an equation in one unknown, then one that is linear in an unknown with a factor free of the others.
std::optional<Elimination::Choice> Elimination::choose(const std::vector<ex>& forces,
                                                       const std::vector<std::size_t>& left) const {
    std::optional<Choice> linear;
    for (const ex& force : forces) {
        const auto numerator = numerator_of(force);
        if (!numerator) continue;
        std::vector<std::size_t> in;
        for (const std::size_t k : left)
            if (numerator->has(task_.unknowns[k])) in.push_back(k);
        for (const std::size_t k : in) {
            const GiNaC::symbol& u = task_.unknowns[k];
            if (!numerator->is_polynomial(u)) continue;
            if (in.size() == 1) return Choice{k, *numerator};
            const bool alone = std::none_of(in.begin(), in.end(), [&](std::size_t other) {
                return numerator->coeff(u, 1).has(task_.unknowns[other]);
            });
            if (!linear && numerator->degree(u) == 1 && alone) linear = Choice{k, *numerator};
        }
    }
    return linear;
}

std::vector<ex> Elimination::roots(const Choice& choice) const {
    std::vector<ex> roots;
    for (const ex& factor : factors_over_numbers(choice.numerator, task_.unknowns[choice.unknown]))
        add_roots(roots, factor, choice.unknown);
    return roots;
}

void Elimination::add_roots(std::vector<ex>& roots, const ex& factor, std::size_t unknown) const {
    const GiNaC::symbol& u = task_.unknowns[unknown];
    const int degree = factor.degree(u);
    if (degree > 2)
        refuse_kind(unknown, "a factor of its equation has degree " + std::to_string(degree) + " in it");
    const ex a = factor.coeff(u, degree), b = factor.coeff(u, degree - 1);
    require_nonzero(a, unknown);
    if (degree == 1) {
        roots.push_back((-b / a).normal());
        return;
    }
    const ex discriminant = (b * b - 4 * a * factor.coeff(u, 0)).expand();
    const SignProver prover(task_.system);
    const SignSet signs = prover.signs(discriminant);
    if (signs.negative && !signs.zero && !signs.positive) return; // no real root
    if (vanishes(discriminant, task_.system) == Zero::yes) {
        roots.push_back((-b / (2 * a)).normal());
        return;
    }
    if (!signs.is_positive())
        refuse(Reason::undecided, {"the discriminant of a quadratic equation for " + in_quotes(u.get_name()) +
                                       " is proved positive or negative",
                                   excerpt(spell(discriminant)),
                                   "declare it in [domain], or write the equilibrium in place of \"solve\"",
                                   task_.places[unknown]});
    const ex root = GiNaC::sqrt(discriminant);
    roots.push_back(((-b - root) / (2 * a)).normal());
    roots.push_back(((-b + root) / (2 * a)).normal());
}

void Elimination::require_nonzero(const ex& divisor, std::size_t unknown) const {
    if (provably_nonzero(divisor, task_.system)) return;
    refuse(Reason::undecided,
           {"what is divided by to solve for an equilibrium is proved to be nonzero",
            excerpt(spell(divisor)) + ", the factor of " + in_quotes(task_.unknowns[unknown].get_name()),
            "declare it positive or nonzero, in [parameters], [variables] or [domain], or write the "
            "equilibrium in place of \"solve\"",
            task_.places[unknown]});
}

void Elimination::refuse_kind(std::size_t unknown, const std::string& why) const {
    refuse(
        {"\"solve\" is for equations that are linear, or polynomials with factors of degree 1 and 2 in one "
         "variable, at eps = 0",
         in_quotes(task_.unknowns[unknown].get_name()) + ": " + why,
         "write the equilibrium in place of \"solve\"", task_.places[unknown]});
}

} // namespace

std::vector<GiNaC::exmap> RootsOfForces::find() const { return Elimination(*this).run(); }

} // namespace resonform
