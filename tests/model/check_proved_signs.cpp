// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the prover of signs says of random expressions holds at points of the domain, and it says enough.
#include "model/files/read_system.hpp"
#include "model/signs/sign_prover.hpp"

#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

// tau > -1, k > tau, 0 < q < 3, s^2 > 2
const char* const domain = "[system]\nname = \"s\"\n"
                           "[parameters]\nr = { positive = true }\nc = { nonzero = true }\nk = {}\nq = {}\n"
                           "[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
                           "s = { role = \"slow\" }\n"
                           "[equations]\nx = \"x'' = -x\"\ntau = \"tau' = eps\"\ns = \"s' = eps\"\n"
                           "[domain]\npositive = [\"1 + tau\", \"k - tau\", \"q\", \"3 - q\", \"s^2 - 2\"]\n";

class RandomExpressions {
public:
    RandomExpressions() : system_(read_system_text(domain, "system.toml")), scope_(system_.constants()) {
        for (const char* name : {"tau", "s"}) scope_.define(name, system_.variable(name)->jet.front());
    }

    [[nodiscard]] const System& system() const { return system_; }
    [[nodiscard]] GiNaC::ex read(const std::string& text) const {
        return read_expression(text, scope_, SourceText{});
    }

    // A sum of a few products, of powers, roots and functions of the like.
    std::string sum(int depth) {
        std::string text = product(depth);
        for (int n = 1 + below(2); n > 0; --n) text += (below(2) == 0 ? " + " : " - ") + product(depth);
        return text;
    }

    // sqrt(S^2 + r) - S and what is like it: of one sign, or nearly so.
    std::string difference() {
        static const char* const added[] = {"r", "1", "c^2", "q", "s", "0", "exp(tau)", "k - tau"};
        const std::string part = sum(0);
        return std::to_string(1 + below(3)) + "*sqrt((" + part + ")^2 + " + added[below(8)] + ") " +
               (below(2) == 0 ? "+ " : "- ") + std::to_string(1 + below(3)) + "*(" + part + ")";
    }

    // (p + q + r)^2 + ..., with waves and exponentials of multiples of one name: of one sign, or nearly so.
    std::string squares() {
        static const char* const parts[] = {"sin(tau)", "cos(tau)", "cos(2*tau)", "exp(k/2)", "exp(k)",
                                            "q",        "r",        "c",          "s",        "tau"};
        const auto square = [&] {
            const std::string last = std::to_string(1 + below(3)) + "*" + parts[below(10)];
            return "(" + std::string(parts[below(10)]) + (below(2) == 0 ? " + " : " - ") + last + ")^2";
        };
        static const char* const rests[] = {" + 1/10",        " + r", " + q*r", " - 1/10",
                                            " + (k - tau)*q", " - q", ""};
        return square() + " + " + square() + rests[below(7)];
    }

    // One in four is close to where the domain ends.
    GiNaC::exmap point() {
        const GiNaC::numeric little(1, 1000);
        const bool near = below(4) == 0;
        const GiNaC::numeric tau = near            ? -1 + little
                                   : below(8) == 0 ? GiNaC::numeric(0)
                                                   : GiNaC::numeric(below(40) - 7, 8);
        const GiNaC::numeric q =
            near ? (below(2) == 0 ? little : 3 - little) : GiNaC::numeric(1 + below(11), 4);
        const GiNaC::numeric size = near ? GiNaC::numeric(1415, 1000) : GiNaC::numeric(3 + below(6), 2);
        return {{*scope_.find("r", 0), GiNaC::numeric(1 + below(16), 4)},
                {*scope_.find("c", 0), GiNaC::numeric(1 + below(12), below(2) == 0 ? 4 : -4)},
                {*scope_.find("k", 0), tau + GiNaC::numeric(1 + below(12), 4)},
                {*scope_.find("q", 0), q},
                {*scope_.find("tau", 0), tau},
                {*scope_.find("s", 0), below(2) == 0 ? size : -size}};
    }

private:
    int below(unsigned n) { return static_cast<int>(random_() % n); }

    std::string product(int depth) {
        std::string text = std::to_string(1 + below(4));
        for (int n = 1 + below(2); n > 0; --n) text += "*" + factor(depth);
        return text;
    }

    std::string factor(int depth) {
        static const char* const names[] = {"r", "c", "k", "q", "tau", "s"};
        static const char* const functions[] = {"sin", "cos", "exp", "tanh", "atan", "cosh"};
        if (depth == 0 || below(3) == 0) {
            const std::string name = names[below(6)];
            return below(3) == 0 ? name + "^2" : name;
        }
        if (below(3) == 0) return std::string(functions[below(6)]) + "(" + names[below(6)] + ")";
        if (below(2) == 0) return "sqrt(" + sum(depth - 1) + ")";
        return below(2) == 0 ? "(" + sum(depth - 1) + ")^2" : "(" + sum(depth - 1) + ")";
    }

    std::mt19937 random_{11};
    System system_;
    Scope scope_;
};

TEST(ProvedSigns, HoldAtRandomPoints) {
    RandomExpressions random;
    int proved = 0;
    for (int trial = 0; trial < 120; ++trial) {
        const std::string text = trial % 3 == 0   ? random.squares()
                                 : trial % 3 == 1 ? random.difference()
                                                  : random.sum(trial % 2);
        const GiNaC::ex e = random.read(text);
        const bool positive = provably_positive(e, random.system());
        const bool negative = provably_positive((-e).expand(), random.system());
        const bool nonzero = provably_nonzero(e, random.system());
        EXPECT_FALSE(positive && negative) << text;
        proved += positive || negative || nonzero ? 1 : 0;
        if (!positive && !negative && !nonzero) continue;
        for (int n = 0; n < 40; ++n) {
            const GiNaC::ex value = e.subs(random.point(), GiNaC::subs_options::no_pattern).evalf();
            ASSERT_TRUE(GiNaC::is_a<GiNaC::numeric>(value)) << text;
            const GiNaC::numeric number = GiNaC::ex_to<GiNaC::numeric>(value);
            EXPECT_GT(GiNaC::abs(number), 1e-14) << text;
            if (positive || negative) {
                EXPECT_LT(GiNaC::abs(number.imag()), 1e-11) << text;
                EXPECT_EQ(number.real().is_positive(), positive) << text << " = " << number;
            }
        }
    }
    EXPECT_GT(proved, 30);
}

} // namespace
} // namespace resonform
