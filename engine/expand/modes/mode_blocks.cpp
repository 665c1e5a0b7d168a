// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/mode_blocks.hpp"

#include "algebra/number/error.hpp"
#include "expand/ring/power_product.hpp"
#include "model/text/canonical.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/zero_test.hpp"

#include <fmt/format.h>

#include <optional>

namespace resonform {

namespace {

using GiNaC::ex;

enum class Sign { negative, zero, positive };

[[noreturn]] void refuse_nilpotent(const std::string& value, const BlockName& name) {
    refuse(
        Reason::not_semisimple,
        {"the linear part of the fast variables is semisimple (has as many eigenvectors as variables)", value,
         "write style = \"inner_product\" in [normal_form], give the variable a restoring force, or unfold "
         "the block",
         name.place});
}

// x'' + 2 d x' + d^2 x, between an oscillation and two real rates.
[[noreturn]] void refuse_critical(const ex& eigenvalue, const System& system, const BlockName& name) {
    const bool decays = provably_positive(-eigenvalue, system);
    refuse(Reason::not_semisimple,
           {decays ? "the linear part of the fast variables is semisimple; at critical damping it is not"
                   : "the linear part of the fast variables is semisimple (has as many eigenvectors as "
                     "variables)",
            fmt::format("{} has the eigenvalue {} twice, with one eigenvector", name.variables,
                        spell(eigenvalue)),
            decays
                ? "take a little more or less damping; or write style = \"inner_product\" in [normal_form], "
                  "which derives the normal form and has no scenes"
                : "take another coefficient of the velocity; or write style = \"inner_product\" in "
                  "[normal_form], which derives the normal form and has no scenes",
            name.place});
}

// The sign of an expression that decides whether eigenvalues, of mean `middle`, are real.
Sign sign_of(const ex& e, const ex& middle, const std::string& what, const System& system,
             const BlockName& name) {
    if (provably_positive(e, system)) return Sign::positive;
    if (provably_positive(-e, system)) return Sign::negative;
    const std::string value = fmt::format("{} = {} for {}", what, spell(e), name.variables);
    if (vanishes(e) == Zero::yes) {
        if (system.style == Style::inner_product) return Sign::zero;
        if (name.oscillator && vanishes(middle) != Zero::yes) refuse_critical(middle, system, name);
        refuse_nilpotent(
            name.oscillator ? value : "two equal eigenvalues with one eigenvector: " + name.variables, name);
    }
    refuse(Reason::undecided,
           {name.oscillator
                ? "the square of a frequency is proved to be positive (an oscillator), or negative"
                : "eigenvalues are proved to be real or to be complex",
            value, how_to_make_positive(e), name.place});
}

struct Eigenvalues {
    ex middle, root; // middle +- root, or middle +- i root
    Sign square;     // of the imaginary part: negative where they are real
};

// Its root is half of the difference of the eigenvalues.
ex discriminant_of(const Matrix& a) {
    const ex difference = (a[0][0] - a[1][1]) / 2;
    return (difference * difference + a[0][1] * a[1][0]).normal();
}

// (n/d)^e = n^e d^-e, for n, d > 0: GiNaC may write (1/p)^(1/2) as (-1/(-p))^(1/2), of which no sign is
// proved.
struct RootsOfFractions : public GiNaC::map_function {
    explicit RootsOfFractions(const System& of) : system(of) {}
    ex operator()(const ex& e) override {
        const bool root = GiNaC::is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer);
        if (!root) return e.map(*this);
        const ex fraction = e.op(0).numer_denom();
        for (const int sign : {1, -1})
            if (const ex below = (sign * fraction.op(1)).expand(); provably_positive(below, system))
                return GiNaC::pow((sign * fraction.op(0)).expand(), e.op(1)) * GiNaC::pow(below, -e.op(1));
        return e;
    }
    const System& system;
};

// Half the difference of two eigenvalues that are rational in the roots and functions of a, as f and g of
// x'' + (f + g) x' + f g x; positive, if its sign is proved. The root of its square would be one more root,
// which depends on these.
std::optional<ex> known_root(const Matrix& a, const System& system) {
    const GiNaC::symbol lambda;
    const ex polynomial = (lambda - a[0][0]) * (lambda - a[1][1]) - a[0][1] * a[1][0];
    if (!holds_functions_or_roots(polynomial)) return std::nullopt;
    GiNaC::exmap roots; // and functions, kept as symbols
    std::vector<ex> eigenvalues;
    for (const ex& f : factors_of(GiNaC::factor(polynomial.numer().to_polynomial(roots))))
        if (f.degree(lambda) == 1) eigenvalues.push_back(-f.coeff(lambda, 0) / f.coeff(lambda, 1));
    if (eigenvalues.size() != 2) return std::nullopt;
    const ex half = (eigenvalues[0] - eigenvalues[1]) / 2;
    const ex difference = half.subs(roots, GiNaC::subs_options::no_pattern).normal();
    for (const ex& positive : {difference, ex(-difference)})
        if (provably_positive(positive, system)) return positive;
    return canonical_sign(difference);
}

Eigenvalues eigenvalues_of(Matrix a, const System& system, const BlockName& name) {
    RootsOfFractions split(system);
    for (auto& row : a)
        for (ex& entry : row) entry = split(entry);
    const ex middle = ((a[0][0] + a[1][1]) / 2).normal();
    const auto known = known_root(a, system);
    if (known && provably_nonzero(*known, system)) return {middle, *known, Sign::negative};
    const ex square = (-discriminant_of(a)).normal();
    const std::string what = name.oscillator ? "omega^2" : "(Im lambda)^2";
    const Sign sign = sign_of(square, middle, what, system, name);
    if (sign == Sign::zero) return {middle, 0, sign};
    if (known) return {middle, *known, Sign::negative};
    return {middle, GiNaC::sqrt(sign == Sign::negative ? (-square).normal() : square), sign};
}

// lambda = middle + i omega: column (1/2, (lambda - a)/(2 b)), row (1 + i (middle - a)/omega, -i b/omega)
BlockMode complex_pair(const Matrix& a, const Eigenvalues& e) {
    const ex shift = (e.middle - a[0][0]).normal();
    const Complex below{(shift / (2 * a[0][1])).normal(), e.root / (2 * a[0][1])};
    return {{e.middle, e.root}, {{ex(1) / 2, 0}, below}, {{1, shift / e.root}, {0, -a[0][1] / e.root}}};
}

// lambda_k, the other one mu: column (1, (lambda - a)/b), row (a - mu, b)/(lambda - mu)
BlockMode real_mode(const Matrix& a, const Eigenvalues& e, int sign) {
    const ex lambda = e.middle + sign * e.root, mu = e.middle - sign * e.root;
    const ex gap = 2 * sign * e.root;
    return {{lambda, 0},
            {{1, 0}, {(lambda - a[0][0]) / a[0][1], 0}},
            {{(a[0][0] - mu) / gap, 0}, {a[0][1] / gap, 0}}};
}

// z1 = u1, z2 = (a - lambda) u1 + b u2: z1' = lambda z1 + z2, z2' = lambda z2
BlockModes chain(const Matrix& a, const ex& lambda) {
    const ex shift = (a[0][0] - lambda).normal(), &b = a[0][1];
    return {{{{lambda, 0}, {{1, 0}, {-shift / b, 0}}, {{1, 0}, {0, 0}}},
             {{lambda, 0}, {{0, 0}, {1 / b, 0}}, {{shift, 0}, {b, 0}}}},
            true};
}

// Real eigenvalues, the one with the sign `first` of the root first.
BlockModes real_modes(const Matrix& a, const Eigenvalues& e, int first) {
    if (e.square == Sign::zero) return chain(a, e.middle);
    return {{real_mode(a, e, first), real_mode(a, e, -first)}};
}

BlockModes modes_with(const Matrix& a, const Eigenvalues& e) {
    if (e.square == Sign::positive) return {{complex_pair(a, e)}};
    return real_modes(a, e, 1);
}

// sqrt(|kappa|) for kappa = middle + sign root. Of numbers sqrt(2 + sqrt(2)) and sqrt(2 - sqrt(2)) would be
// two roots, the second of which depends on the first: their product is the root of a rational number. The
// smaller is written by the larger.
std::optional<ex> root_by_the_larger(const Eigenvalues& e, int sign) {
    const ex own = e.middle + sign * e.root, other = e.middle - sign * e.root;
    const bool smaller = !GiNaC::is_a<GiNaC::numeric>(e.root) && is_constant(own) &&
                         sign_of_constant(sign * e.middle * e.root) == ConstantSign::negative;
    if (!smaller) return std::nullopt;
    const auto absolute = [](const ex& kappa) {
        return sign_of_constant(kappa) == ConstantSign::negative ? ex(-kappa) : kappa;
    };
    const ex product = (e.middle * e.middle - e.root * e.root).expand();
    return GiNaC::sqrt(absolute(other)) * absolute(own) / GiNaC::sqrt(absolute(product));
}

} // namespace

BlockModes modes_of_block(const Matrix& a, const System& system, const BlockName& name) {
    if (a.size() == 1) return {{{{a[0][0], 0}, {{1, 0}}, {{1, 0}}}}};
    return modes_with(a, eigenvalues_of(a, system, name));
}

bool has_plain_frequencies(const Matrix& k, const System& system) {
    const auto known = [&](const ex& e) {
        return provably_positive(e, system) || provably_positive(-e, system);
    };
    const ex middle = ((k[0][0] + k[1][1]) / 2).normal(), square = discriminant_of(k);
    if (vanishes(square) == Zero::yes) return true;
    if (!provably_positive(square, system)) return provably_positive(-square, system);
    const ex root = GiNaC::sqrt(square);
    return known(middle + root) && known(middle - root);
}

// With K phi = kappa phi and rho K = kappa rho: positions phi q, q'' = -kappa q, q = rho u.
BlockModes modes_of_coupled_oscillators(const Matrix& k, const System& system, const BlockName& name) {
    const Eigenvalues e = eigenvalues_of(k, system, name);
    if (e.square == Sign::positive)
        refuse(Reason::eigenvalues,
               {"coupled oscillators have real squares of their frequencies",
                fmt::format("those of {} are complex", name.variables), "use other variables", name.place});
    const BlockModes normal_coordinates = real_modes(k, e, -1); // the lower frequency first
    BlockModes modes{{}, normal_coordinates.chained};
    int sign = -1;
    for (const BlockMode& normal_coordinate : normal_coordinates.modes) {
        BlockName one = name;
        one.oscillator = true;
        const ex kappa = normal_coordinate.eigenvalue.re;
        const Matrix oscillator{{0, 1}, {-kappa, 0}};
        Eigenvalues eigenvalues = eigenvalues_of(oscillator, system, one);
        if (const auto root = root_by_the_larger(e, sign)) eigenvalues.root = *root;
        sign = 1;
        for (const BlockMode& mode : modes_with(oscillator, eigenvalues).modes) {
            BlockMode both{mode.eigenvalue, {}, {}};
            for (std::size_t variable = 0; variable < 2; ++variable) {
                for (std::size_t state = 0; state < 2; ++state) {
                    both.column.push_back(normal_coordinate.column[variable] * mode.column[state]);
                    both.row.push_back(normal_coordinate.row[variable] * mode.row[state]);
                }
            }
            modes.modes.push_back(std::move(both));
        }
    }
    return modes;
}

} // namespace resonform
