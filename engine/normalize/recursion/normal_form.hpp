// SPDX-License-Identifier: GPL-3.0-or-later
// The results of normalisation: normal form, near-identity map, divisors.
//   z = w + h,          w' = lambda w + N
//   phi = theta + m,    theta' = omega(zeta) + N
//   xi = zeta + k,      zeta' = N
//   X = Z + l,          Z' = N
// h, m, k, l, N in (w, wbar, e^{i theta}, eps; zeta): the generators stand for the new variables.
#pragma once

#include "algebra/graph/domain.hpp"
#include "expand/expansion/graded_field.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

enum class DivisorVerdict { removed, kept_exact, kept_near, ambiguous };
const char* to_string(DivisorVerdict verdict);

struct DivisorRecord {
    std::string variable; // "z1", "x"
    Monomial monomial;    // powers of modes, phases and eps
    int weight;           // as all here, to be read by System::weight()
    Polynomial divisor;   // <alpha, lambda> - lambda_j
    DivisorVerdict verdict;
};

// Additional results of the style hamiltonian (normalize/styles/hamiltonian.hpp). With the weight w of the
// modes:
//   K = H(old variables), {w_a, K} = rates;   old = exp(L_chi) new,  L_chi f = {f, chi}
struct HamiltonianForm {
    struct Bracket { // {left, right} = value of modal coordinates, a constant; each has one partner
        GeneratorId left, right;
        Polynomial value;
    };
    std::vector<Bracket> brackets;
    Series energy;    // K, weights 2 w ... M + w; below stand constants only
    Series generator; // chi, weights 2 w + 1 ... M + w
};

// rates[...] through weight `through`, the linear part of modes and the frequencies of angles included.
template <class Part> struct NormalFormOf {
    std::shared_ptr<const GradedField> field;
    int through = 0; // M
    Style style = Style::poincare;
    std::vector<BasicSeries<Part>> mode; // N of each mode (of a conjugate pair only the first)
    std::vector<BasicSeries<Part>> angle;
    std::vector<BasicSeries<Part>> slow; // as given where they are not driven
    std::vector<BasicSeries<Part>> drift;
    std::optional<HamiltonianForm> hamiltonian; // style hamiltonian
};
using NormalForm = NormalFormOf<Polynomial>;

// The old variable minus the new one.
template <class Part> struct NearIdentityMapOf {
    int through = 0;
    // h, above the weight of the modes; at it a term without modes may stand (forcing eps e^{i k phi})
    std::vector<BasicSeries<Part>> mode;
    std::vector<BasicSeries<Part>> angle; // m, weights 1 ... through
    std::vector<BasicSeries<Part>> slow;  // k, likewise; zero where it is not driven
    std::vector<BasicSeries<Part>> drift; // l, likewise
};
using NearIdentityMap = NearIdentityMapOf<Polynomial>;

struct Certificate {
    bool holds = false;            // substitution and scan
    bool residual_zero = false;    // (a)
    bool normal_form_scan = false; // (b)
    Rational through_weight = 0;   // as the user counts it
    std::string route = "substitution, modular";
    int points = 0;
    std::vector<std::uint64_t> primes;
    double error_probability = 1;
    std::string complaint; // empty when it holds: which equation, which weight
};

template <class Part> struct NormalizationOf {
    NormalFormOf<Part> normal_form;
    NearIdentityMapOf<Part> map;
    std::vector<DivisorRecord> divisors;
    Certificate certificate; // filled by certify()
};
using Normalization = NormalizationOf<Polynomial>;

// The same with coefficients in a graph (algebra/graph/coefficient_graph.hpp).
struct GraphNormalization {
    GraphDomain domain;
    NormalizationOf<GraphPart> result;
};

} // namespace resonform
