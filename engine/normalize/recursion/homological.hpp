// SPDX-License-Identifier: GPL-3.0-or-later
// One homological equation, weight by weight (design 2.3). For a function u of the old variables,
// u = u_new + c(w, wbar, e^{i theta}, eps; zeta), with rate [F] along the field and N along the normal form:
//
//   D(alpha) c_alpha = R_alpha - N_alpha,
//   R_n = [F]_n - sum_j sum_y d_y c_j . y'_{n + weight(y) - j}
//
// over the new variables y = w, wbar, zeta, theta, where the linear part lambda w of the modes and the
// frequencies of the angles are in D, not in the sum. A HomologicalStyle chooses c and N.
#pragma once

#include "normalize/recursion/divisor.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <set>
#include <vector>

namespace resonform {

// A new variable along which corrections are transported.
struct Carrier {
    GeneratorId id; // of an angle: its phase e^{i theta}, and the derivative is by theta
    bool angle = false;
    int weight = 0;
};
// Modes with their conjugates, slow variables, angles, in the order of the field.
std::vector<Carrier> carriers_of(const GradedField& field);

// Their rates, without the linear part of the modes and the frequencies of the angles. Weights below the
// current one are complete.
template <class Part> using Transport = std::vector<BasicSeries<Part>>;

template <class Domain> class HomologicalEquation {
public:
    using Part = typename Domain::Part;

    // mode: index of the mode, or -1 for another variable.
    HomologicalEquation(const GradedField& field, Domain domain, int mode, std::string variable, Place place);

    // Divisors without an inverse (DivisorTable::missing). If there are any, solve() left no solution.
    [[nodiscard]] const std::vector<Polynomial>& missing_divisors() const { return divisors_.missing(); }

    // R_n, given [F]_n of the composed field.
    [[nodiscard]] Part right_hand_side(int weight, const Part& field_part, const Transport<Part>& transport);
    // To be called after the last right_hand_side(): frees the derivatives of the correction.
    void finish() { slopes_.clear(); }
    struct Shares {
        Part exact, near; // terms with D = 0, and with a small D kept by `near`
        Part quotient;    // all other terms, divided by D
    };
    [[nodiscard]] Shares divided(int weight, const Part& part);
    // c_n and N_n; weights must come in order.
    void accept(int weight, Part correction, Part rate);
    // Makes a record of each new monomial.
    const Divisor<Part>& divisor_of(const Monomial& outer, int weight);

    [[nodiscard]] int mode() const { return mode_; }
    [[nodiscard]] const BasicSeries<Part>& correction() const { return correction_; } // c
    [[nodiscard]] const BasicSeries<Part>& rate() const {
        return rate_;
    } // N without linear part and frequency
    [[nodiscard]] std::vector<DivisorRecord>& records() { return records_; }

private:
    void derive(std::size_t carrier, int weight);

    const GradedField& field_;
    Domain domain_;
    int mode_;
    std::string variable_;
    Place place_; // of the equation of the variable
    DivisorTable<Domain> divisors_;
    std::vector<GeneratorId> outer_; // GradedField::outer()
    BasicSeries<Part> correction_, rate_;
    std::vector<Carrier> carriers_;
    // The derivatives of the correction by each carrier, computed when a rate is there to be multiplied with:
    // the last weights, which hold most of the terms, are never asked for.
    std::vector<BasicSeries<Part>> slopes_;
    std::vector<std::set<int>> derived_;
    std::vector<DivisorRecord> records_;
    std::set<Monomial> seen_; // monomials that have a record
};

// A style of normal form: splits right-hand sides into corrections and normal form, D c + ... = R - N.
template <class Domain> class HomologicalStyle {
public:
    using Part = typename Domain::Part;
    using Equations = std::vector<HomologicalEquation<Domain>*>;

    virtual ~HomologicalStyle() = default;
    // Solves weight n of equations that belong together: all modes of one weight, or one other variable.
    virtual void solve(int weight, const Equations& equations, const std::vector<Part>& right) const = 0;
};

} // namespace resonform
