// SPDX-License-Identifier: GPL-3.0-or-later
// Functions given by samples: the spline through them, the proof of its sign, and errors of the data file.
#include "algebra/number/error.hpp"
#include "model/files/read_scene.hpp"
#include "model/files/spline.hpp"
#include "support/error_when.hpp"
#include "support/shell.hpp"

#include <cln/cln.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

Rational exact(double x) { return cln::rational(cln::cl_F(x)); }

std::vector<double> points(int count, double step) {
    std::vector<double> x;
    for (int k = 0; k < count; ++k) x.push_back(k * step);
    return x;
}

template <class F> std::vector<double> values(const std::vector<double>& x, const F& f) {
    std::vector<double> y;
    for (const double at : x) y.push_back(f(at));
    return y;
}

// A polynomial of its degree is its own spline, whatever the knots.
TEST(Splines, ArePolynomialsThroughPolynomials) {
    const std::vector<double> x{0, 0.5, 1, 2, 2.5, 4, 5, 5.5, 7, 8};
    for (const int degree : {1, 3, 5, 7, 9}) {
        const auto f = [&](double t) { return 1 - t + std::pow(t, degree) / 64; };
        const PiecewisePolynomial s = spline_through(x, values(x, f), degree);
        EXPECT_EQ(s.pieces(), x.size() - static_cast<std::size_t>(degree));
        for (const double t : {0.25, 3.0, 6.0, 7.75})
            EXPECT_NEAR(to_double(s.at(exact(t), 0)), f(t), 1e-11 * std::abs(f(t))) << degree;
    }
}

TEST(Splines, PassThroughTheirSamplesAndAreSmooth) {
    const std::vector<double> x = points(12, 0.25), y = values(x, [](double t) { return std::sin(t); });
    const PiecewisePolynomial s = spline_through(x, y, 5);
    for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(to_double(s.at(exact(x[k]), 0)), y[k], 1e-15);
    const Rational edge = exact(s.breakpoints[2]);
    const Rational near = Rational(1) / Rational(1000000000);
    for (int derivative = 0; derivative < 5; ++derivative)
        EXPECT_NEAR(to_double(s.at(edge, derivative)), to_double(s.at(edge - near, derivative)), 1e-7);
    EXPECT_GT(std::abs(to_double(s.at(edge, 5) - s.at(edge - near, 5))), 1e-6);
}

// Halving the step divides the error by 2^(degree + 1).
TEST(Splines, ConvergeAsTheirDegreeSays) {
    for (const int degree : {3, 5}) {
        double error[2] = {0, 0};
        for (const int k : {0, 1}) {
            const std::vector<double> x = points(k == 0 ? 33 : 65, k == 0 ? 0.25 : 0.125);
            const PiecewisePolynomial s =
                spline_through(x, values(x, [](double t) { return std::exp(-t); }), degree);
            for (double t = 3.5; t < 4.5; t += 1.0 / 64)
                error[k] = std::max(error[k], std::abs(to_double(s.at(exact(t), 0)) - std::exp(-t)));
        }
        EXPECT_NEAR(std::log2(error[0] / error[1]), degree + 1, 0.5);
    }
}

TEST(Splines, HaveTheirSignBetweenSamplesToo) {
    const std::vector<double> x = points(6, 1);
    EXPECT_EQ(spline_through(x, {1, 1, 1, 1, 1, 1}, 1).sign(), 1);
    EXPECT_EQ(spline_through(x, {-1, -2, -1, -2, -1, -2}, 3).sign(), -1);
    EXPECT_EQ(spline_through(x, {1, 1, 0, 1, 1, 1}, 1).sign(), 0);
    EXPECT_EQ(spline_through(x, {1, 1, 1e-3, 1e-3, 1, 1}, 3).sign(), 0); // it dips below zero in between
    EXPECT_EQ(spline_through(x, {1, 1, 0.2, 0.2, 1, 1}, 3).sign(), 1);
}

class Samples : public testing::Test {
protected:
    Scene read(const std::string& data, const std::string& value,
               const std::string& start = "\"x'\" = 0\ns = 0") {
        test::write(systems_ / "m/system.toml",
                    "[system]\nname = \"m\"\n[functions]\nf = { of = [\"s\"], positive = true }\n"
                    "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n"
                    "[equations]\nx = \"x'' + f(s)*x = 0\"\ns = \"s' = eps\"\n");
        test::write(systems_ / "m/scenes/f.csv", data);
        test::write(systems_ / "m/scenes/m.toml",
                    "order = 1\n[functions]\nf = " + value + "\n[start]\nx = \"eps\"\n" + start + "\n");
        return read_scene(systems_ / "m/scenes/m.toml", systems_);
    }

    std::string message(const std::string& data, const std::string& value,
                        const std::string& start = "\"x'\" = 0\ns = 0") {
        const Error error = test::error_when([&] { read(data, value, start); });
        EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
        return error.what();
    }

private:
    test::Scratch scratch_;
    std::filesystem::path systems_ = scratch_.path() / "systems";
};

const std::string plain = "s, f\n0,1\n1,2\n2,4\n3,3\n",
                  cubic = "{ data = \"f.csv\", columns = [\"s\", \"f\"], degree = 3 }";

TEST_F(Samples, AreTheSameWhicheverWayTheyStand) {
    const Scene up = read(plain, cubic), down = read("f,s,more\n3,3,x\n\n4,2,\n2,1,\r\n1,0,y\n", cubic);
    EXPECT_EQ(up.system->functions.front().data->text(), down.system->functions.front().data->text());
    EXPECT_EQ(up.system->functions.front().data_text, "spline of degree 3 through 4 points of f.csv (s, f)");
}

TEST_F(Samples, AreNumbersInStartValues) {
    const Scene scene = read(plain, cubic, "\"x'\" = \"eps*f(2)\"\ns = \"f'(0) - f'(0)\"");
    EXPECT_TRUE(scene.start_of("x'")->value.is_equal(
        GiNaC::numeric(cln::cl_N(scene.system->functions.front().data->at(2, 0))) * scene.system->eps));
    EXPECT_NEAR(to_double(scene.system->functions.front().data->at(2, 0)), 4, 1e-14);
}

TEST_F(Samples, AreRefusedInOneMessage) {
    struct Wrong {
        std::string data, value, message;
    };
    const auto with = [](const std::string& from, const std::string& to) {
        std::string text = cubic;
        return text.replace(text.find(from), from.size(), to);
    };
    for (const Wrong& wrong : std::vector<Wrong>{
             {"s,f\n0,1\n1,2\n2,4\n", cubic, "a spline of degree 3 goes through 4 to 1000 points"},
             {"", cubic, "a spline of degree 3 goes through 4 to 1000 points"},
             {"s,f\n0,1\n1,2\n1,4\n3,3\n", cubic, "f.csv:4: every argument of the data stands there once"},
             {"s,f\n0,1\n2,2\n1,4\n3,3\n", cubic,
              "f.csv:4: the arguments of the data rise from line to line"},
             {"s,f\n0,1\n1,two\n2,4\n3,3\n", cubic, "f.csv:3: data are finite numbers"},
             {"s,f\n0,1\n1,nan\n2,4\n3,3\n", cubic, "f.csv:3: data are finite numbers"},
             {"s,f\n0,1\n1,1e999\n2,4\n3,3\n", cubic, "f.csv:3: data are finite numbers"},
             {"s,f\n0,1\n1\n2,4\n3,3\n", cubic,
              "f.csv:3: every line of the data has a value for each column"},
             {"s,g\n0,1\n", cubic, "a column is named in the first line of f.csv"},
             {plain, with("f.csv", "none.csv"), "no such file"},
             {plain, with("3 }", "4 }"), "the degree of a spline is odd"},
             {plain, with(", degree = 3", ""), "data of a function have the keys data, columns and degree"},
             {plain, with("[\"s\", \"f\"]", "\"s\""), "'columns' names the column of the arguments"},
             {"s,f\n0,1\n1,2\n2,-4\n3,3\n", cubic,
              "the system declares f positive, and the spline through the data"}})
        EXPECT_NE(message(wrong.data, wrong.value).find(wrong.message), std::string::npos)
            << message(wrong.data, wrong.value) << "\nwanted: " << wrong.message;
    EXPECT_NE(message(plain, cubic, "\"x'\" = 0\ns = 5").find("the data of f reach from 0 to 3"),
              std::string::npos)
        << message(plain, cubic, "\"x'\" = 0\ns = 5");
    EXPECT_NE(message(plain, cubic, "\"x'\" = 0\ns = \"f(7)\"").find("the data of f reach from 0 to 3"),
              std::string::npos);
}

} // namespace
} // namespace resonform
