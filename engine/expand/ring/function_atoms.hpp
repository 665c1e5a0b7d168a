// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of weight 0 as polynomials in a few of them, the atoms, which become generators of the
// coefficient ring:
//
//   exp(2*tau) + exp(-tau/2)  ->  E^4 + 1/E                 E = exp(tau/2)
//   sin(tau + 2*alpha)        ->  s u + c v                 s, c of tau; v, u of 2*alpha
//   sin(2*alpha) + cos(alpha) ->  2 u v + u                 v, u of alpha
//   log(4*x^2*y)              ->  2 log(2) + 2 log(x) + log(y)
//   tanh(tau)                 ->  (E^2 - 1)/(E^2 + 1)       E = exp(tau)
//   cos(tau + pi/3)           ->  c/2 - 3^(1/2) s/2         pi itself is a symbol
//
// The arguments of rationally related exponentials, and of sines and cosines, have one common part, the
// largest possible, so that atoms are independent of each other where this can be proved;
// FunctionAtom::independent tells whether it is.
#pragma once

#include "algebra/ring/ring.hpp"
#include "expand/ring/power_product.hpp"

#include <ginac/ginac.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

struct FunctionAtom {
    Function function = Function::exponential;
    GiNaC::symbol symbol; // named as the function is spelled
    GiNaC::ex argument;   // in parameters, slow variables, earlier atoms, and their roots
    std::size_t sine = 0; // cosine: index of the sine
    std::string name;     // named: omega
    int derivative = 0;   // named
    bool independent = true;
    Place place; // where it was met first
};

class FunctionAtoms {
public:
    // derivatives: how many of each function known by its name only are needed beyond those written.
    FunctionAtoms(std::shared_ptr<const System> system, int derivatives, InverseOfNumber inverse);

    // Learns the atoms of e, an expression of weight 0. The common parts of arguments are known when all
    // expressions were learned and none of them changed any: until then, learn all again.
    // Errors (refused): a logarithm whose argument is not proved positive, and those of split_power.
    void learn(const GiNaC::ex& e, const Place& place);
    bool forget_unless_settled(); // false: all atoms are forgotten, learn again
    void judge_independence();    // of all atoms, when settled

    // e in the symbols of atoms. Errors (refused): a function that was not learned.
    [[nodiscard]] GiNaC::ex rewrite(const GiNaC::ex& e, const Place& place) const;

    [[nodiscard]] const std::vector<FunctionAtom>& atoms() const { return atoms_; }
    [[nodiscard]] const CoefficientDomain& domain() const { return domain_; }
    // The symbol that stands for the number pi, if that was met.
    [[nodiscard]] const GiNaC::symbol* pi() const { return has_pi_ ? &pi_ : nullptr; }

private:
    friend class FunctionRewriter;

    [[nodiscard]] CoefficientDomain new_domain() const;

    std::shared_ptr<const System> system_;
    int derivatives_;
    InverseOfNumber inverse_;
    bool settled_ = true, has_pi_ = false;
    GiNaC::symbol pi_{"pi"};
    std::vector<FunctionAtom> atoms_;
    std::map<std::string, Rational> units_; // of the multiples of one argument that occur
    CoefficientDomain domain_;
};

} // namespace resonform
