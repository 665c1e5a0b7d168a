// SPDX-License-Identifier: GPL-3.0-or-later
// What is equal is written the same; what is zero is seen to be zero.
#include "model/exact/written_form.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using GiNaC::ex;

class Exact : public testing::Test {
protected:
    Exact() {
        domain_.parameters.push_back({"g", true, true, "", g, {}});
        domain_.parameters.push_back({"r", true, true, "", r, {}});
        using Kind = ExactForm::Kind;
        form_.add(psi2, Kind::acceleration);
        form_.add(psi1, Kind::velocity);
        form_.add(psi, Kind::coordinate);
        form_.add(xi1, Kind::rate);
        form_.add(xi, Kind::slow);
        form_.add(g, Kind::parameter);
        form_.add(r, Kind::parameter);
        form_.add(domain_.eps, Kind::eps);
    }
    std::string text(const ex& e) { return written(form_, e); }

    GiNaC::symbol g{"g"}, r{"r"}, psi{"psi"}, psi1{"psi'"}, psi2{"psi''"}, xi{"xi"}, xi1{"xi'"};
    System domain_;
    ExactForm form_{domain_};
};

TEST_F(Exact, AnglesOfSumsAreTakenApart) {
    const ex phi = psi + GiNaC::atan(xi / r);
    EXPECT_EQ(text(sin(phi)), "r*sin(psi)/sqrt(xi^2 + r^2) + xi*cos(psi)/sqrt(xi^2 + r^2)");
    EXPECT_EQ(text(g * r * sin(phi) - g * xi * cos(phi)), "g*sqrt(xi^2 + r^2)*sin(psi)");
    EXPECT_EQ(text(GiNaC::sin(psi + GiNaC::Pi / 2)), "cos(psi)");
    EXPECT_EQ(text(GiNaC::tan(xi - psi)),
              "(-cos(xi)*sin(psi) + sin(xi)*cos(psi))/(sin(xi)*sin(psi) + cos(xi)*cos(psi))");
}

TEST_F(Exact, RelationsAreKnown) {
    EXPECT_EQ(text(pow(sin(2 * psi), 2) + pow(cos(2 * psi), 2)), "1");
    EXPECT_EQ(text(sinh(psi) / cosh(psi) - tanh(psi)), "0");
    EXPECT_EQ(text(GiNaC::exp(2 * psi - xi) * GiNaC::exp(xi)), "exp(psi)^2");
    EXPECT_EQ(text(GiNaC::sqrt(4 * r * r + 4 * xi * xi) * GiNaC::sqrt(1 + xi * xi / r / r)),
              "(2*xi^2 + 2*r^2)/r");
    EXPECT_EQ(text(GiNaC::cos(GiNaC::asin(psi)) - GiNaC::sqrt(1 - psi * psi)), "0");
}

TEST_F(Exact, RootsOfNumbersAreTakenApartByPrimes) {
    const auto root = [](int n) { return GiNaC::sqrt(ex(n)); };
    EXPECT_EQ(text(root(2) * psi + psi), "(sqrt(2) + 1)*psi");
    EXPECT_EQ(text(root(6) - root(2) * root(3)), "0");
    EXPECT_EQ(text(root(8) / 2), "sqrt(2)");
    EXPECT_EQ(text(psi / root(2)), "psi/sqrt(2)");
    EXPECT_EQ(text(GiNaC::pow(ex(16), GiNaC::numeric(1, 3)) - 2 * GiNaC::pow(ex(2), GiNaC::numeric(1, 3))),
              "0");
    EXPECT_EQ(text(pow(cos(psi + GiNaC::Pi / 4), 2) + pow(sin(psi + GiNaC::Pi / 4), 2)), "1");
}

TEST_F(Exact, SignsOfArgumentsAreTakenOut) {
    EXPECT_EQ(text(GiNaC::atan(psi - xi) + GiNaC::atan(xi - psi)), "0");
    EXPECT_EQ(text(GiNaC::sin(psi - xi) + GiNaC::sin(xi - psi)), "0");
}

TEST_F(Exact, TermsAreWrittenByWhatMoves) {
    EXPECT_EQ(text(psi1 + GiNaC::diff(GiNaC::atan(xi / r), xi) * xi1), "psi' + r*xi'/(xi^2 + r^2)");
    EXPECT_EQ(text((r * r + xi * xi) * psi2 + g * r * psi / 2 - xi * xi1 * psi1),
              "(xi^2 + r^2)*psi'' - xi*xi'*psi' + g*r*psi/2");
    EXPECT_EQ(text(1 / (1 + pow(domain_.eps * psi, 2)) + psi), "(eps^2*psi^3 + psi + 1)/(eps^2*psi^2 + 1)");
}

TEST_F(Exact, ZeroHasThreeAnswers) {
    EXPECT_EQ(form_.vanishes(GiNaC::sin(psi + xi) - sin(psi) * cos(xi) - cos(psi) * sin(xi)), Zero::yes);
    EXPECT_EQ(form_.vanishes(GiNaC::sin(psi + xi) - sin(psi)), Zero::no);
    EXPECT_EQ(form_.vanishes(GiNaC::log(r * g) - GiNaC::log(r) - GiNaC::log(g)), Zero::unknown);
}

} // namespace
} // namespace resonform
