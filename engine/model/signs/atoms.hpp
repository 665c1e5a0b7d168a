// SPDX-License-Identifier: GPL-3.0-or-later
// Real expressions as quotients of polynomials in atoms, with the relations and signs of the atoms.
//
//   3*sin(u) + 4*cos(u) + 6  ->  (2*t^2 + 6*t + 10)/(1 + t^2)      with t the tangent of u/2
//   exp(2*u) - exp(u) + 1    ->  t^2 - t + 1, t > 0                x - sqrt(x)  ->  t^2 - t, t > 0 if x is
#pragma once

#include "algebra/signs/sign_set.hpp"
#include "model/system/system_file.hpp"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace resonform {

class Atoms {
public:
    using SignsOf = std::function<SignSet(const GiNaC::ex&)>;

    // Takes in the atoms of e; `signs` tells those of roots and of opaque parts. false: e is complex, or
    // holds a power with a symbolic exponent.
    bool collect(const GiNaC::ex& e, const SignsOf& signs);

    // For all below the last expression must be collected. Their results are in these symbols.
    [[nodiscard]] std::vector<GiNaC::symbol> symbols() const;
    [[nodiscard]] GiNaC::ex rational(const GiNaC::ex& e) const;
    [[nodiscard]] std::vector<GiNaC::ex> positive() const;
    // root^2 = square, root >= 0; the square holds earlier ones.
    struct Root {
        GiNaC::symbol root;
        GiNaC::ex square;
    };
    [[nodiscard]] std::vector<Root> roots() const;
    // An odd multiple of pi has no tangent of its half. Bit k of the set stands for the k-th angle.
    [[nodiscard]] std::size_t angles() const;
    void set_odd_multiples_of_pi(std::size_t set);

private:
    enum class Kind { value, exponential, angle };
    struct Atom { // of t, the index-th root of key or exp(key), or the tangent of key/(2*index)
        Kind kind;
        GiNaC::ex key;
        GiNaC::numeric index;
        SignSet signs;
        std::vector<GiNaC::symbol> t; // and its square, its fourth power, ... where they are roots, too
        bool at_pi = false;
    };
    struct Multiple { // of the key of an atom
        std::size_t atom;
        GiNaC::numeric ratio;
    };
    struct Unit {
        GiNaC::ex cosine, sine;
    };

    Multiple find(Kind kind, const GiNaC::ex& key);
    [[nodiscard]] std::optional<Multiple> multiple(Kind kind, const GiNaC::ex& key) const;
    [[nodiscard]] std::pair<const Atom&, int> times(Kind kind, const GiNaC::ex& term) const;
    void collect_terms(Kind kind, const GiNaC::ex& argument);
    static std::size_t halvings(const Atom& atom);
    static void refine(Atom& atom, const GiNaC::numeric& index);
    [[nodiscard]] GiNaC::ex exponential(const GiNaC::ex& argument) const;
    [[nodiscard]] Unit angle(const GiNaC::ex& argument) const;

    std::vector<Atom> atoms_;
    GiNaC::exmap known_roots_; // sqrt(b^2) is b or -b
};

} // namespace resonform
