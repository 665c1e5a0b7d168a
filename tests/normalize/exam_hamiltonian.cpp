// SPDX-License-Identifier: GPL-3.0-or-later
// The style hamiltonian: certified for centres, saddles, resonances and parameters; every lie about it is
// found; what it does not take is refused.
#include "normalize/certified.hpp"
#include "normalize/hamiltonians.hpp"
#include "normalize/styles/normalize.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using test::certificate_of;

Normalization normalized(const std::string& toml, int order) {
    return normalize_hamiltonian(test::field_from(toml), order);
}

struct EnergyCase {
    const char* name;
    std::string toml;
    int order;
};

std::ostream& operator<<(std::ostream& out, const EnergyCase& c) { return out << c.name; }

class Hamiltonian : public testing::TestWithParam<EnergyCase> {};

TEST_P(Hamiltonian, IsCertified) {
    const Normalization n = normalized(GetParam().toml, GetParam().order);
    const Certificate c = certificate_of(n);
    EXPECT_TRUE(c.holds) << c.complaint;
    EXPECT_LE(c.error_probability, 1e-30);
}

// The generator is real, so that the map is.
TEST_P(Hamiltonian, IsReal) {
    const Normalization n = normalized(GetParam().toml, GetParam().order);
    const Ring& ring = *n.normal_form.field->ring;
    for (const Series* s : {&n.normal_form.hamiltonian->energy, &n.normal_form.hamiltonian->generator})
        for (int k = 0; k <= s->through(); ++k)
            EXPECT_TRUE(ring.vanishes(ring.conjugate(s->part(k)) - s->part(k))) << "weight " << k;
}

const std::string w1_w2 = "w1 = { positive = true }\nw2 = { positive = true }\na = {}\n";

const EnergyCase energies[] = {
    {"Duffing", test::one_degree("px^2/2 + x^2/2 + x^4/4"), 7},
    {"Pendulum", test::one_degree("px^2/2 + g*(1 - cos(x))", "g = { positive = true }\n"), 5},
    {"Saddle", test::one_degree("px^2/2 + cos(x)"), 6},
    {"NegativeEnergy", test::one_degree("-px^2/2 - x^2/2 + x^3"), 5},
    {"Forced", test::one_degree("px^2/2 + x^2/2 + x^3/3 + eps^2*x + eps*x*px^2"), 5},
    {"Finite",
     "[system]\nname = \"test\"\n[variables]\nx = { role = \"fast\", weight = 0 }\n"
     "p = { role = \"fast\", weight = 0 }\n[hamiltonian]\nmomenta = { x = \"p\" }\n"
     "energy = \"p^2/2 + x^2/2 + eps*(x + x^3)\"\n",
     4},
    {"HenonHeiles", test::henon_heiles(), 6},
    {"OneToTwo", test::two_degrees("px^2/2 + py^2/2 + x^2/2 + 2*y^2 + x^2*y + eps*py*x^2"), 5},
    {"CentreAndSaddle", test::two_degrees("px^2/2 + py^2/2 + cos(x) + 2*y^2 + x^2*y"), 5},
    {"TwoFrequencies", test::two_degrees("px^2/2 + py^2/2 + (w1^2*x^2 + w2^2*y^2)/2 + a*x^2*y", w1_w2), 4},
    {"IndefiniteTwoFrequencies",
     test::two_degrees("w1*(px^2 + x^2)/2 - w2*(py^2 + y^2)/2 + a*x^2*y + py^3", w1_w2), 3},
};

INSTANTIATE_TEST_SUITE_P(All, Hamiltonian, testing::ValuesIn(energies),
                         [](const auto& tested) { return tested.param.name; });

TEST(HamiltonianStyle, IsChosenByTheSystem) {
    const Normalization n = normalize(test::field_from(test::one_degree("px^2/2 + x^2/2 + x^4/4") +
                                                       "[normal_form]\nstyle = \"hamiltonian\"\n"),
                                      3);
    EXPECT_EQ(n.normal_form.style, Style::hamiltonian);
    ASSERT_TRUE(n.normal_form.hamiltonian);
    // K = I + 3/8 I^2 with z1 z2 = 2 I
    EXPECT_EQ(
        test::coefficient_of(*n.normal_form.field, n.normal_form.hamiltonian->energy, {{"z1", 2}, {"z2", 2}}),
        Polynomial(Rational(3) / 32));
}

// --- lies ------------------------------------------------------------------------------------------

Polynomial with_coefficient(const Polynomial& p, std::size_t k, const Rational& value) {
    std::vector<Term> terms = p.terms();
    terms[k].coefficient = value;
    return Polynomial::from_terms(std::move(terms));
}

TEST(HamiltonianLies, EveryCoefficient) {
    Normalization n = normalized(test::two_degrees("px^2/2 + py^2/2 + x^2/2 + 2*y^2 + x^2*y"), 3);
    HamiltonianForm& form = *n.normal_form.hamiltonian;
    int lies = 0;
    for (const test::SeriesOfForm& item : test::all_series(n))
        for (int weight = 0; weight <= item.series->through(); ++weight) {
            const Polynomial truth = item.series->part(weight);
            for (std::size_t k = 0; k < truth.size(); ++k)
                for (const Rational& lie : {Rational(truth.terms()[k].coefficient + 1),
                                            Rational(0) - truth.terms()[k].coefficient}) {
                    item.series->set(weight, with_coefficient(truth, k, lie));
                    EXPECT_FALSE(certificate_of(n).holds) << item.name << ", weight " << weight;
                    ++lies;
                }
            item.series->set(weight, truth);
        }
    EXPECT_GT(lies, 90);
    for (HamiltonianForm::Bracket& b : form.brackets) {
        b.value = -b.value;
        EXPECT_FALSE(certificate_of(n).holds);
        b.value = -b.value;
    }
    EXPECT_TRUE(certificate_of(n).holds) << certificate_of(n).complaint;
}

// h = 0 and N = F solve the equations, and with K = H and chi = 0 the map is canonical.
TEST(HamiltonianLies, NothingNormalised) {
    const auto field = test::field_from(test::one_degree("px^2/2 + x^2/2 + x^3/3"));
    Normalization n = normalize_hamiltonian(field, 3);
    const Ring& ring = *field->ring;
    SeriesRun run(*field->program);
    HamiltonianForm& form = *n.normal_form.hamiltonian;
    for (int k = 0; k <= 4; ++k) {
        run.set_input(field->modes[0].input, k, k == 1 ? ring.gen(field->modes[0].z) : Polynomial());
        run.set_input(field->modes[0].input_conjugate, k,
                      k == 1 ? ring.gen(field->modes[0].zbar) : Polynomial());
        run.advance(k);
        form.energy.set(k, run.part(field->energy, k));
        form.generator.set(k, {});
        if (k > 3) continue;
        n.map.mode[0].set(k, {});
        Polynomial rate = run.part(field->modes[0].rate, k);
        if (k == 1)
            rate = rate + ring.multiply(field->eigenvalue(field->modes[0]), ring.gen(field->modes[0].z));
        n.normal_form.mode[0].set(k, rate);
    }
    const Certificate c = certificate_of(n);
    EXPECT_TRUE(c.residual_zero) << c.complaint;
    EXPECT_FALSE(c.normal_form_scan);
    EXPECT_FALSE(c.holds);
}

// A Poincare normal form solves the equations too, but its map is not canonical.
TEST(HamiltonianLies, MapOfAnotherStyle) {
    const auto field = test::field_from(test::one_degree("px^2/2 + x^2/2 + x^4/4"));
    Normalization n = normalize_hamiltonian(field, 5);
    const Normalization other = normalize_poincare(field, 5);
    n.normal_form.mode = other.normal_form.mode;
    n.map = other.map;
    const Certificate c = certificate_of(n);
    EXPECT_FALSE(c.holds);
    EXPECT_NE(c.complaint.find("canonical"), std::string::npos) << c.complaint;
}

TEST(HamiltonianLies, KernelTermInTheGenerator) {
    Normalization n = normalized(test::one_degree("px^2/2 + x^2/2 + x^4/4"), 3);
    const Ring& ring = *n.normal_form.field->ring;
    Series& generator = n.normal_form.hamiltonian->generator;
    generator.set(4, generator.part(4) + Rational(1) / 7 * test::monomial(ring, {{"z1", 2}, {"z2", 2}}));
    const Certificate c = certificate_of(n);
    EXPECT_FALSE(c.holds);
    EXPECT_FALSE(c.normal_form_scan) << c.complaint;
}

TEST(HamiltonianLies, NoEnergyAtAll) {
    Normalization n = normalized(test::one_degree("px^2/2 + x^2/2 + x^4/4"), 5);
    n.normal_form.hamiltonian.reset();
    EXPECT_FALSE(certificate_of(n).holds);
    n.normal_form.style = Style::poincare; // whose map would have no resonant terms
    const Certificate c = certificate_of(n);
    EXPECT_TRUE(c.residual_zero) << c.complaint;
    EXPECT_FALSE(c.normal_form_scan);
}

// --- refusals --------------------------------------------------------------------------------------

std::string message(const std::string& toml) {
    const Error error = test::error_when([&] { normalized(toml, 3); });
    return std::to_string(static_cast<int>(error.kind())) + " " + error.what();
}

TEST(HamiltonianRefusals, SystemWithoutEnergy) {
    EXPECT_EQ(message(test::oscillator_file("x'' + x = 0")),
              "2 test/system.toml: the style hamiltonian is for systems that are given by their energy\n"
              "  found: no [hamiltonian] in test\n"
              "  hint:  write [hamiltonian] with energy and momenta, or take style = \"poincare\"");
}

TEST(HamiltonianRefusals, VariableOutsideOfPairs) {
    EXPECT_EQ(
        message("[system]\nname = \"test\"\n[variables]\nx = { role = \"fast\" }\n"
                "p = { role = \"fast\" }\ntau = { role = \"slow\" }\n[equations]\ntau = \"tau' = eps\"\n"
                "[hamiltonian]\nenergy = \"p^2/2 + (1 + tau^2)*x^2/2\"\nmomenta = { x = \"p\" }\n"),
        "3 test/system.toml:6:1: variables.tau: in the style hamiltonian every variable is a coordinate "
        "or a momentum\n"
        "    tau = { role = \"slow\" }\n"
        "    ^\n"
        "  found: 'tau' is slow and belongs to no pair\n"
        "  hint:  take style = \"poincare\", which works with such equations");
}

TEST(HamiltonianRefusals, ForceOfTheWeightOfTheVariables) {
    EXPECT_EQ(message(test::one_degree("px^2/2 + x^2/2 + eps*x")),
              "3 test/system.toml:8:11: hamiltonian.energy: an energy holds no force as large as the fast "
              "variables themselves\n"
              "    energy = \"px^2/2 + x^2/2 + eps*x\"\n"
              "              ^\n"
              "  found: a term eps*x\n"
              "  hint:  shift to the equilibrium, or scale the force with a higher power of eps");
}

// Equal frequencies, coordinates that are not orthogonal: u = x, v = x + y of two equal oscillators.
TEST(HamiltonianRefusals, ModesThatAreNotIndependent) {
    const std::string text = message(test::two_degrees("(px + py)^2/2 + py^2/2 + x^2/2 + (y - x)^2/2"));
    EXPECT_EQ(text.substr(0, 2), "3 ") << text;
    EXPECT_NE(text.find("hint:"), std::string::npos) << text;
}

TEST(HamiltonianRefusals, ForceAtTheOrigin) {
    EXPECT_EQ(message(test::one_degree("px^2/2 + exp(x)")),
              "2 test/system.toml:8:11: hamiltonian.energy: the origin of the fast variables is not an "
              "equilibrium at eps = 0\n"
              "    energy = \"px^2/2 + exp(x)\"\n"
              "              ^\n"
              "  found: px' = -1 there\n"
              "  hint:  say under [equilibrium] where the fast variables rest, or write \"solve\" there");
}

TEST(HamiltonianRefusals, NotSemisimple) {
    EXPECT_EQ(message(test::one_degree("px^2/2 + x^4/4")).substr(0, 2), "3 ");
}

} // namespace
} // namespace resonform
