// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients in numbers of D digits: they agree with exact ones, their digits are right, modes without
// closed form are found, and the certificate sees every lie.
#include "model/files/read_system.hpp"
#include "normalize/lies.hpp"
#include "normalize/recursion/numbers.hpp"
#include "normalize/recursion/poincare.hpp"
#include "support/error_when.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

#include <cln/cln.h>

#include <set>

namespace resonform {
namespace {

using test::coefficient_of;

std::string fast(const std::vector<std::pair<std::string, std::string>>& equations,
                 const std::string& more_variables = "", const std::string& more_equations = "",
                 const std::string& near = "") {
    std::string variables, text;
    for (const auto& [name, equation] : equations) {
        variables += name + " = { role = \"fast\" }\n";
        text += name + " = \"" + equation + "\"\n";
    }
    return "[system]\nname = \"numbers\"\n" + near + "[variables]\n" + variables + more_variables +
           "[equations]\n" + text + more_equations;
}

std::shared_ptr<const GradedField> field_of(const std::string& toml, int digits) {
    System system = read_system_text(toml, "system.toml");
    system.digits = digits;
    return std::make_shared<const GradedField>(expand(std::make_shared<const FirstOrderSystem>(
        solve_for_highest(std::make_shared<const System>(std::move(system))))));
}

struct InNumbers {
    std::shared_ptr<const GradedField> field;
    Normalization n;
};

InNumbers normalized(const std::string& toml, int through, int digits) {
    InNumbers result{field_of(toml, digits), {}};
    result.n = normalize_in_numbers(result.field, through);
    result.n.certificate = certify_numbers(result.n, result.field);
    EXPECT_TRUE(result.n.certificate.holds) << result.n.certificate.complaint << "\n" << toml;
    return result;
}

// |a - b| <= 10^-digits |b|
void expect_close(const Rational& a, const RealBall& b, int digits, const std::string& where) {
    RealBall difference(a, 4096);
    arb_sub(difference.get(), difference.get(), b.get(), 4096);
    const std::int64_t allowed = binary_exponent(b) - static_cast<std::int64_t>(3.32 * digits);
    EXPECT_LE(binary_exponent(difference), allowed) << where;
}

// Every coefficient of `rounded` is that of `exact` to all digits, and neither has one more.
void expect_same(const Normalization& exact, const Normalization& rounded, int digits) {
    const RingPtr ring = exact.normal_form.field->ring;
    const NumberDomain numbers(ring, 1, 4096, {});
    const std::vector<GeneratorId> outer = exact.normal_form.field->outer();
    const std::vector<GeneratorId> outer_rounded = rounded.normal_form.field->outer();
    Normalization a = exact, b = rounded;
    const auto left = test::all_series(a), right = test::all_series(b);
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t k = 0; k < left.size(); ++k) {
        const auto terms = ring->collect(left[k].series->total(99), outer);
        const Ring& other = *rounded.normal_form.field->ring;
        const auto found = other.collect(right[k].series->total(99), outer_rounded);
        ASSERT_EQ(terms.size(), found.size()) << left[k].name;
        for (const auto& [monomial, coefficient] : terms) {
            std::vector<int> exponents;
            for (const GeneratorId id : outer) exponents.push_back(ring->exponent(monomial, id));
            const auto same = std::find_if(found.begin(), found.end(), [&](const auto& f) {
                for (std::size_t n = 0; n < outer_rounded.size(); ++n)
                    if (other.exponent(f.first, outer_rounded[n]) != exponents[n]) return false;
                return true;
            });
            ASSERT_NE(same, found.end()) << left[k].name;
            const ComplexBall wanted = numbers.value(coefficient);
            Rational re = 0, im = 0;
            for (const Term& t : same->second.terms())
                (other.exponent(t.monomial, Ring::imaginary_unit) == 1 ? im : re) = t.coefficient;
            if (!wanted.re().is_zero()) expect_close(re, wanted.re(), digits, left[k].name);
            if (!wanted.im().is_zero()) expect_close(im, wanted.im(), digits, left[k].name);
        }
    }
}

// Frequencies 1 and sqrt(3), a drift, a root and a function of numbers; small, and finite with eps.
TEST(Numbers, AgreeWithTheRing) {
    for (const std::string& toml :
         {fast({{"x", "x'' = -x - x^2*y + sqrt(2)*x*y"}, {"y", "y'' = -3*y + x^2/7 - exp(1/2)*y^3"}},
               "X = { role = \"drift\" }\n", "X = \"X' = eps*x^2 + x*y'\"\n"),
          fast({{"x", "x'' = -2*x - x'/3 + x^3 + eps*cos(x)*y"}, {"y", "y' = -y + x*y + 1/3*x^2"}}),
          std::string("[system]\nname = \"finite\"\n[variables]\nx = { role = \"fast\", weight = 0 }\n"
                      "phi = { role = \"angle\" }\n[equations]\nx = \"x'' + 5*x = eps*(1 - x^2)*x' + "
                      "eps*cos(phi)*x^2\"\nphi = \"phi' = sqrt(7)\"\n")}) {
        const auto exact_field = field_of(toml, 0);
        const Normalization exact = normalize_poincare(exact_field, 4);
        const InNumbers rounded = normalized(toml, 4, 25);
        expect_same(exact, rounded.n, 24 + spare_digits);
    }
}

// 1/3, 1/7 and 10^-40 are no binary numbers: digits are those that were asked for and more.
TEST(Numbers, HaveAllDigitsAtAnyPrecision) {
    const std::string toml = fast({{"x", "x'' = -x + x^3/7 + 1e-40*x^2"}});
    const Normalization exact = normalize_poincare(field_of(toml, 0), 5);
    for (const int digits : {fewest_digits, 16, 200, most_digits})
        expect_same(exact, normalized(toml, 5, digits).n, digits + spare_digits - 1);
}

const std::vector<std::pair<std::string, std::string>> chain = {{"a", "a'' = -2*a + b - a^3/6"},
                                                                {"b", "b'' = -3*b + a + c - b^2/5"},
                                                                {"c", "c'' = -5/2*c + b + d"},
                                                                {"d", "d'' = -7/3*d + c + e + d*e"},
                                                                {"e", "e'' = -2*e + d"}};

// The frequencies are the square roots of the eigenvalues of the stiffness matrix: their squares add up to
// its trace, and those of their squares to that of its square. Undamped is undamped, exactly.
TEST(Numbers, ModesWithoutClosedFormAreFound) {
    EXPECT_THROW(field_of(fast(chain), 0), Error);
    const InNumbers found = normalized(fast(chain), 3, 40);
    const GradedField& field = *found.n.normal_form.field;
    ASSERT_EQ(field.modes.size(), 5U);
    Rational trace = 0, squares = 0, last = 0;
    for (const Mode& mode : field.modes) {
        EXPECT_TRUE(mode.growth.empty());
        const Rational omega = mode.omega.terms().front().coefficient;
        EXPECT_GT(omega, last);
        last = omega;
        trace = trace + omega * omega;
        squares = squares + omega * omega * omega * omega;
    }
    const Rational exact = Rational(2) + 3 + Rational(5) / 2 + Rational(7) / 3 + 2;
    const Rational exact_squares = Rational(4) + 9 + Rational(25) / 4 + Rational(49) / 9 + 4 + 8;
    expect_close(trace, RealBall(exact, 4096), 58, "trace");
    expect_close(squares, RealBall(exact_squares, 4096), 58, "trace of squares");
    // |z|^2 z of each pair stays, and it is a frequency: purely imaginary
    const Polynomial shift = coefficient_of(field, found.n.normal_form.mode[0], {{"z1", 2}, {"z2", 1}});
    ASSERT_EQ(shift.size(), 1U);
    EXPECT_EQ(field.ring->exponent(shift.terms().front().monomial, Ring::imaginary_unit), 1);
}

// The same system, found in closed form and in numbers: a third variable that is irreducibly coupled by a
// factor that vanishes makes the block too large for closed forms otherwise.
TEST(Numbers, DampedModesOfOddBlocks) {
    const InNumbers found = normalized(fast({{"x", "x'' = -2*x - x'/10 + y + x^2"},
                                             {"y", "y'' = -3*y + x - y'/7 + w"},
                                             {"w", "w' = -w + x - y*w"}},
                                            "X = { role = \"drift\" }\n", "X = \"X' = eps*x^2\"\n"),
                                       3, 30);
    const GradedField& field = *found.n.normal_form.field;
    ASSERT_EQ(field.modes.size(), 3U);
    EXPECT_TRUE(field.modes[0].is_real());
    Rational trace = field.modes[0].growth.terms().front().coefficient;
    for (std::size_t k = 1; k < 3; ++k) trace = trace + 2 * field.modes[k].growth.terms().front().coefficient;
    expect_close(trace, RealBall(Rational(-1) / 10 - Rational(1) / 7 - 1, 4096), 48, "trace");
}

// Two copies of one chain: their frequencies are equal, and that is known.
TEST(Numbers, EqualBlocksAreResonantExactly) {
    std::vector<std::pair<std::string, std::string>> both;
    for (const std::string copy : {"p", "q"}) {
        const std::string a = copy + "1", b = copy + "2", c = copy + "3", d = copy + "4", e = copy + "5";
        both.emplace_back(a, a + "'' = -2*" + a + " + " + b + (copy == "p" ? " + q1*p2*q3" : ""));
        both.emplace_back(b, b + "'' = -3*" + b + " + " + a + " + " + c);
        both.emplace_back(c, c + "'' = -4*" + c + " + " + b + " + " + d);
        both.emplace_back(d, d + "'' = -2*" + d + " + " + c + " + " + e);
        both.emplace_back(e, e + "'' = -5*" + e + " + " + d);
    }
    const InNumbers found = normalized(fast(both), 3, 20);
    const auto& rate = found.n.normal_form.mode[0];
    // q1 p2 q3 has w11 w11 conj(w1): resonant with w1 only as both frequencies are the same number
    EXPECT_FALSE(coefficient_of(*found.n.normal_form.field, rate, {{"z2", 1}, {"z11", 2}}).empty());
}

// lambda^2 = -s, s^3 - 6 s^2 + 9 s - 3 = 0, and the same for lambda/2: 2 w1 = w2 for a reason that numbers
// cannot see.
std::vector<std::pair<std::string, std::string>> doubled() {
    return {{"a", "a'' = b + a*b"}, {"b", "b'' = c"}, {"c", "c'' = -3*a - 9*b - 6*c"},
            {"p", "p'' = q + a^2"}, {"q", "q'' = r"}, {"r", "r'' = -192*p - 144*q - 24*r"}};
}

// With lambda, -lambda is an eigenvalue of a conservative block: a saddle has its resonances exactly, and so
// has a quadruple +-a +- i b.
TEST(Numbers, OppositeEigenvaluesAreResonantExactly) {
    const auto in_z1 = [](const std::string& toml, const std::vector<std::pair<std::string, int>>& powers) {
        const InNumbers found = normalized(toml, 3, 15);
        const Ring& ring = *found.n.normal_form.field->ring;
        const Monomial wanted = test::monomial(ring, powers).terms().front().monomial;
        const auto record =
            std::find_if(found.n.divisors.begin(), found.n.divisors.end(),
                         [&](const DivisorRecord& d) { return d.variable == "z1" && d.monomial == wanted; });
        return record == found.n.divisors.end() ? DivisorVerdict::ambiguous : record->verdict;
    };
    const std::string saddle = fast(
        {{"x", "x'' - 2*x - y/3 = x^3"}, {"y", "y'' + 3*y - x/3 - w/7 = 0"}, {"w", "w'' + 5*w - y/7 = 0"}});
    EXPECT_EQ(in_z1(saddle, {{"z1", 2}, {"z2", 1}}), DivisorVerdict::kept_exact);
    const std::string gyroscope =
        fast({{"x", "x'' - y' - x + w/5 = x^3"}, {"y", "y'' + x' - 2*y = 0"}, {"w", "w'' + 5*w - x/7 = 0"}});
    EXPECT_EQ(in_z1(gyroscope, {{"z1", 2}, {"z4", 1}}), DivisorVerdict::kept_exact);
}

TEST(Numbers, WhatCannotBeToldFromZeroIsRefusedOrKeptNear) {
    const Error error = test::error_when([&] { normalize_in_numbers(field_of(fast(doubled()), 15), 2); });
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    const std::string text = error.what();
    EXPECT_NE(text.find("told from zero"), std::string::npos) << text;
    EXPECT_NE(text.find("system.toml:"), std::string::npos) << text;
    EXPECT_NE(text.find(" = i*("), std::string::npos) << text;
    EXPECT_NE(text.find("D(z"), std::string::npos) << text;
    const std::string near = "[normal_form]\nnear = 1e-6\n";
    const InNumbers kept = normalized(fast(doubled(), "", "", near), 2, 15);
    EXPECT_TRUE(std::any_of(kept.n.divisors.begin(), kept.n.divisors.end(),
                            [](const DivisorRecord& d) { return d.verdict == DivisorVerdict::kept_near; }));
}

// The force is even in x and w, so that the mode x - w has none: the balls of its coefficients hold zero.
TEST(Numbers, WhatIsZeroForItsStructureHasNoRecord) {
    const std::string system = fast(
        {{"x", "x'' = -2*x + y + (x+w)^2"}, {"y", "y'' = x - 2*y + w"}, {"w", "w'' = y - 2*w + (x+w)^2"}});
    const auto records = [](const Normalization& n) {
        std::set<std::pair<std::string, std::vector<int>>> all;
        for (const DivisorRecord& r : n.divisors) {
            std::vector<int> exponents;
            for (const GeneratorId id : n.normal_form.field->outer())
                exponents.push_back(n.normal_form.field->ring->exponent(r.monomial, id));
            all.insert({r.variable + " " + to_string(r.verdict), std::move(exponents)});
        }
        return all;
    };
    const auto exact = records(normalize_poincare(field_of(system, 0), 3));
    EXPECT_EQ(records(normalized(system, 3, 20).n), exact);
    EXPECT_EQ(exact.count({"z3 removed", {2, 0, 0, 0, 0, 0, 0}}), 0U);
}

// 2*omega_x - omega_y lies on the threshold, but for a part in 10^14 of it.
TEST(Numbers, OnTheThresholdTheMessageNamesMonomialDivisorAndValue) {
    const std::string toml = fast({{"x", "x'' = -x + x*y"}, {"y", "y'' = -(2 + 1/1000)^2*y + x^2"}}, "", "",
                                  "[normal_form]\nnear = 0.00100000000000001\n");
    for (const int digits : {0, 20}) {
        const Error error = test::error_when([&] {
            if (digits == 0)
                normalize_poincare(field_of(toml, 0), 2);
            else
                normalize_in_numbers(field_of(toml, digits), 2);
        });
        EXPECT_EQ(error.kind(), ErrorKind::refused);
        const std::string text = error.what();
        EXPECT_NE(text.find("system.toml:9:"), std::string::npos) << text;
        EXPECT_NE(text.find("D(z2*z3) of z1 = i*(-2*omega_x + omega_y)"), std::string::npos) << text;
        EXPECT_NE(text.find("near = 0.00100000000000001\n"), std::string::npos) << text;
        EXPECT_NE(text.find("change near in [normal_form] a little"), std::string::npos) << text;
    }
}

TEST(Numbers, EveryLieIsFound) {
    const InNumbers chain_of_two = normalized(
        fast({{"x", "x'' = -2*x - x'/10 + y + x^2"}, {"y", "y'' = -3*y + x + w"}, {"w", "w' = -w + x"}}), 2,
        10);
    EXPECT_GT(
        test::expect_all_lies_found(
            chain_of_two.n, [&](const Normalization& n) { return certify_numbers(n, chain_of_two.field); }),
        50);
}

// The last digits that are asked for are in the certificate's sight, and so are monomials out of place.
TEST(Numbers, SmallLiesAndMisplacedTermsAreFound) {
    const InNumbers truth = normalized(fast({{"x", "x'' = -2*x + x^3"}, {"y", "y'' = -5*y + x^2*y"}}), 3, 20);
    const auto holds = [&](const Normalization& n) { return certify_numbers(n, truth.field).holds; };
    Normalization n = truth.n;
    const Polynomial part = n.normal_form.mode[0].part(3);
    n.normal_form.mode[0].set(3, (1 + Rational(1) / cln::expt_pos(Integer(10), 20)) * part);
    EXPECT_FALSE(holds(n));
    n = truth.n; // a resonant term in the map: the residual does not see it, the scan does
    const Ring& ring = *n.normal_form.field->ring;
    n.map.mode[0].set(3, n.map.mode[0].part(3) + Rational(1) * test::monomial(ring, {{"z1", 2}, {"z2", 1}}));
    EXPECT_FALSE(holds(n));
    n = truth.n; // h = 0, N = F
    for (std::size_t k = 0; k < n.map.mode.size(); ++k)
        for (int w = 0; w <= n.map.mode[k].through(); ++w) n.map.mode[k].set(w, {});
    EXPECT_FALSE(holds(n));
}

// Two real modes of one variable have names of their own.
TEST(Numbers, ModesOfOneVariableAreToldApartInMessages) {
    const std::string block =
        test::system_text("n", {{"x0", "fast", "x0' = 3*x1 - 2*x3 + x3*x2/3"},
                                {"x1", "fast", "x1' = 3*x0 - 2*x1 - 3*x3 + 5/3*x1*x2*eps"},
                                {"x2", "fast", "x2' = -2*x1 - 2*x2 + 2*x3 + 4/3*x3*x0"},
                                {"x3", "fast", "x3' = 3*x0 - 3*x1 + 5/3*x3^2"}});
    const Error error = test::error_when([&] { normalized(block, 3, 60); });
    const std::string text = error.what();
    EXPECT_NE(text.find("growth_z"), std::string::npos) << text;
    EXPECT_EQ(text.find("growth_x0"), std::string::npos) << text;
}

// The sizes of terms by which residuals are judged leave the range of doubles on both sides.
TEST(Numbers, OfExtremeSizesAreCertified) {
    const InNumbers far = normalized(fast({{"x", "x'' + 1e-160*x + 2e-80*x*y = 0"},
                                           {"y", "y'' + (2e-80 + 1e80*eps)^2*y + 1e-80*x^2 = 0"}}),
                                     3, 10);
    const Certificate certificate = certify_numbers(far.n, far.field);
    EXPECT_TRUE(certificate.holds) << certificate.complaint;
}

TEST(Numbers, WantNumbers) {
    const auto kind_of = [](const std::string& toml) {
        return test::error_when([&] { normalize_in_numbers(field_of(toml, 20), 3); }, toml).kind();
    };
    EXPECT_EQ(kind_of(test::system_text("p", {{"x", "fast", "x'' = -x + k*x^3"}}, "[parameters]\nk = {}\n")),
              ErrorKind::bad_input);
    EXPECT_EQ(
        kind_of(fast({{"x", "x'' = -x + tau*x^3"}}, "tau = { role = \"slow\" }\n", "tau = \"tau' = eps\"\n")),
        ErrorKind::refused);
    EXPECT_EQ(kind_of(fast({{"x", "x' = y"}, {"y", "y' = x^2"}}, "", "",
                           "[normal_form]\nstyle = \"inner_product\"\n")),
              ErrorKind::refused);
}

} // namespace
} // namespace resonform
