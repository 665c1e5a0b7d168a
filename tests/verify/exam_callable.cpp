// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes whose functions are given to the emitted code by objects: the same numbers as with expressions.
#include "algebra/number/error.hpp"
#include "emit/cpp/cpp.hpp"
#include "own_system.hpp"
#include "support/error_when.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <string>

namespace resonform {
namespace {

constexpr const char* two_functions =
    "[functions]\nomega = { of = [\"s\"], positive = true }\nk = { of = [\"s\"] }\n"
    "[parameters]\nq = {}\n"
    "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n"
    "[equations]\nx = \"x'' + eps*k(s)*x' + omega(s)^2*x + q*x^3 = 0\"\n"
    "s = \"s' = eps\"\n";

class Callable : public test::OwnSystem {
protected:
    std::string header(const std::string& functions, const std::string& system = two_functions) {
        const Scene scene =
            written(system, "order = 2\n[functions]\n" + functions +
                                "\n[start]\nx = \"eps\"\n\"x'\" = \"-eps*omega(1/3)\"\ns = 0\n");
        return emit_cpp(*test::program_of(scene));
    }
    std::string message(const std::string& functions, const std::string& system = two_functions) {
        return test::message_when([&] { header(functions, system); });
    }
};

// Prints what differs. Of the closures one has a member, so that it can neither be default constructed nor
// assigned.
constexpr const char* both = R"(
#include "called.hpp"
#include "written.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace called = resonform::generated::s::s;
namespace written = resonform::generated::s::written;
using resonform::Status;

struct Omega { // 2 + sin(s)
    double sign = 1;
    template <class R> R operator()(int derivative, const R& s) const {
        using namespace resonform::math;
        const R value = derivative % 2 == 0 ? R(sin(s)) : R(cos(s));
        return R(sign) * ((derivative == 0 ? R(2) : R(0)) + (derivative % 4 > 1 ? -value : value));
    }
};

template <class Real> bool near(const Real& a, const Real& b, const Real& scale) {
    return std::abs(a - b) <= 4 * std::numeric_limits<Real>::epsilon() * scale;
}

template <class Real> int differences(const Real& eps) {
    const double half = 0.5;
    const auto k = [half](int derivative, const auto& s) { // exp(s)/2
        using namespace resonform::math;
        using R = std::decay_t<decltype(s)>;
        (void)derivative;
        return R(half) * R(exp(s));
    };
    using Called = called::Evaluator<Real, std::decay_t<decltype(k)>, Omega>;
    using Written = written::Evaluator<Real>;
    typename Called::Parameters p;
    typename Written::Parameters q;
    p.q = q.q = Real(1) / 3;
    const Written expected(eps, q);
    const Called given(eps, p, k, Omega{});
    Called evaluator(eps * 2, p, k, Omega{});
    evaluator = given; // copies of a copy
    int wrong = 0;
    for (int i = 0; i <= 50; ++i) {
        const Real t = Real(i) / 50 / eps * (1 - std::numeric_limits<Real>::epsilon());
        typename Called::Values a, b;
        typename Written::Values e;
        const Status status = expected(t, e);
        const auto start = Called::default_start(eps, p, k, Omega{});
        if (evaluator(t, a) != status || Called::at_end(eps, p, start, t, b, k, Omega{}) != status) ++wrong;
        if (!near(a.x, e.x, eps) || !near(b.x, e.x, eps)) ++wrong;
    }
    std::array<Real, 3> all_eps{eps, eps / 2, eps / 4}, t{1 / eps, 2 / eps, 1}, cubic{0, 1, 2}, x, same, many;
    std::array<Status, 3> status, expected_status;
    typename Called::Members members;
    typename Written::Members written_members;
    members.eps = written_members.eps = all_eps.data();
    members.q = written_members.q = cubic.data();
    Called::ensemble(3, members, t.data(), x.data(), status.data(), k, Omega{});
    Written::ensemble(3, written_members, t.data(), same.data(), expected_status.data());
    for (std::size_t i = 0; i < 3; ++i)
        if (status[i] != expected_status[i] || !near(x[i], same[i], eps)) ++wrong;
    std::array<Real, 3> times{1, 2, 3};
    evaluator.batch(times.data(), 3, many.data());
    for (std::size_t i = 0; i < 3; ++i) {
        typename Called::Values a;
        evaluator(times[i], a);
        if (a.x != many[i]) ++wrong;
    }
    return wrong;
}

int main() {
    std::printf("%d %d\n", differences(0.01), differences(0.02L));
    using Same = called::Evaluator<double, Omega, Omega>;
    Same::Parameters p;
    p.q = 1;
    const Same none(0.1, p);
    p.k = Omega{};
    const Same half(0.1, p);
    const Same negative(0.1, p, Omega{}, Omega{-1});
    for (const Same* e : {&none, &half, &negative})
        std::printf("%d %s\n", int(e->construction_status()), e->why(e->construction_status()));
}
)";

TEST_F(Callable, GivesTheNumbersOfTheExpression) {
    const test::Scratch scratch;
    std::string expression = header("omega = \"2 + sin(s)\"\nk = \"exp(s)/2\"");
    const std::string name = "namespace resonform::generated::s::s ";
    ASSERT_NE(expression.find(name), std::string::npos);
    expression.replace(expression.find(name), name.size(), "namespace resonform::generated::s::written ");
    test::write(scratch.path() / "written.hpp", expression);
    const std::string called = header("omega = { callable = true }\nk = { callable = true }");
    test::write(scratch.path() / "called.hpp", called);
    EXPECT_NE(called.find("// omega(s): an object that the caller gives"), std::string::npos);
    EXPECT_NE(called.find("omega; // to be given: omega and its derivatives, 0 ... 2"), std::string::npos);
    test::write(scratch.path() / "main.cpp", both);
    const test::Outcome built =
        test::run(std::string(RESONFORM_CXX_COMPILER) +
                      " -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I'" +
                      RESONFORM_SOURCE_DIR + "/engine' main.cpp -o both",
                  scratch.path());
    ASSERT_EQ(built.code, 0) << built.err.substr(0, 3000);
    EXPECT_EQ(test::run("./both", scratch.path()).out, "0 0\n3 k\n3 omega\n1 omega(s)\n");
}

TEST_F(Callable, IsRefusedInOneMessage) {
    const std::string k = "k = \"s\"\n";
    EXPECT_NE(message(k + "omega = { callable = false }").find("callable = false gives no value of omega"),
              std::string::npos);
    EXPECT_NE(message(k + "omega = { callable = true, degree = 3 }").find("degree"), std::string::npos);
    EXPECT_NE(message(k + "omega = { callable = \"yes\" }").find("true or false"), std::string::npos);
    const std::string of_parameter = "[functions]\nomega = { of = [\"q\"], positive = true }\n"
                                     "[parameters]\nq = {}\n[variables]\nx = { role = \"fast\" }\n"
                                     "[equations]\nx = \"x'' + omega(q)^2*x = 0\"\n";
    EXPECT_NE(message("omega = { callable = true }", of_parameter).find("and q is a parameter"),
              std::string::npos);
    const std::string nonzero = "[functions]\nomega = { of = [\"s\"], nonzero = true }\n"
                                "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n"
                                "[equations]\nx = \"x'' + omega(s)^2*x = 0\"\ns = \"s' = eps\"\n";
    EXPECT_NE(message("omega = { callable = true }", nonzero).find("declares omega nonzero"),
              std::string::npos);
}

} // namespace
} // namespace resonform
