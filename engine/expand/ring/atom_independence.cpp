// SPDX-License-Identifier: GPL-3.0-or-later
// Which atoms are proved to be algebraically independent. The reason is Ax's theorem (and Lindemann's for
// numbers): exponentials are, if their arguments are linearly independent over the rationals modulo
// constants, as different products of independent atoms are; logarithms are, if no product of powers
// of their arguments and of exponentials is constant, as with different irreducible polynomials. Functions
// known by their name only are independent of everything. The number pi is transcendental; nothing is known
// about a function of numbers beside it.
#include "expand/ring/function_atoms.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::is_a;

struct Shape {
    bool constant = true;       // no parameter and no slow variable in it
    bool sums_inverted = false; // a sum under a root or in a denominator
    bool roots = false;
    bool circles = false, atoms = false;
    bool inverses = false; // exp(asinh(u)) and cos(atan(u)) are algebraic
};

// Whose arguments do not factor uniquely: atan, asinh, ...
bool is_inverse(const FunctionAtom& a) {
    return a.function != Function::named && a.function != Function::logarithm &&
           !row_of(a.function).slope.empty();
}

Shape shape_of(const ex& e, const std::vector<FunctionAtom>& atoms, const GiNaC::symbol* pi) {
    Shape shape;
    for (auto it = e.preorder_begin(); it != e.preorder_end(); ++it) {
        if (is_a<GiNaC::power>(*it)) {
            const bool plain = it->op(1).info(GiNaC::info_flags::nonnegint);
            shape.sums_inverted = shape.sums_inverted || (!plain && is_a<GiNaC::add>(it->op(0)));
            shape.roots = shape.roots || !it->op(1).info(GiNaC::info_flags::integer);
        }
        if (!is_a<GiNaC::symbol>(*it) || (pi != nullptr && it->is_equal(*pi))) continue;
        const auto atom = std::find_if(atoms.begin(), atoms.end(),
                                       [&](const FunctionAtom& a) { return it->is_equal(a.symbol); });
        if (atom == atoms.end()) {
            shape.constant = false;
            continue;
        }
        shape.atoms = true;
        shape.circles =
            shape.circles || atom->function == Function::sine || atom->function == Function::cosine;
        shape.inverses = shape.inverses || is_inverse(*atom);
        shape.constant = shape.constant && shape_of(atom->argument, atoms, pi).constant;
    }
    return shape;
}

} // namespace

void FunctionAtoms::judge_independence() {
    std::vector<Shape> shapes;
    for (const FunctionAtom& a : atoms_) shapes.push_back(shape_of(a.argument, atoms_, pi()));
    const auto count = [&](const auto& is_meant) {
        int n = 0;
        for (std::size_t k = 0; k < atoms_.size(); ++k) n += is_meant(atoms_[k], shapes[k]) ? 1 : 0;
        return n;
    };
    // Inverse functions, and logarithms of arguments with circular functions, roots or inverted sums.
    const int odd = count([&](const FunctionAtom& a, const Shape& s) {
        return is_inverse(a) ||
               (a.function == Function::logarithm && (s.circles || s.roots || s.sums_inverted));
    });
    const int logarithms =
        count([](const FunctionAtom& a, const Shape&) { return a.function == Function::logarithm; });
    const int constants = count([](const FunctionAtom&, const Shape& s) { return s.constant; });
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
        FunctionAtom& a = atoms_[k];
        const Shape& s = shapes[k];
        const bool plain = !s.sums_inverted;
        switch (a.function) {
        case Function::exponential:
        case Function::sine:
        case Function::cosine: a.independent = plain && !s.inverses && (!s.constant || !s.atoms); break;
        case Function::logarithm:
            a.independent = plain && !s.roots && (!s.circles || odd == 1) && (!s.constant || constants == 1);
            break;
        case Function::named: a.independent = plain && !s.roots; break;
        default:
            a.independent = plain && !s.roots && !s.circles && odd == 1 && !s.constant;
            if (a.function != Function::arc_tangent && s.atoms) a.independent = false;
            // (log(1 + u) - log(1 - u))/2
            if (a.function == Function::inverse_hyperbolic_tangent && logarithms > 0) a.independent = false;
            break;
        }
        if (has_pi_ && s.constant && a.function != Function::named) a.independent = false;
    }
}

} // namespace resonform
