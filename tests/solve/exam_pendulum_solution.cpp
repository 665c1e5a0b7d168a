// SPDX-License-Identifier: GPL-3.0-or-later
// (21), (22), (23) of the paper, term by term: its formulas are built in the ring of the solution and
// subtracted, and the zero test says yes.
#include "solve/line.hpp"

#include <gtest/gtest.h>

using namespace resonform;

namespace {

// The paper's symbols in the ring of a solution. s = xi^2 + r^2 = rho^8.
class Paper {
public:
    explicit Paper(Solution solution) : solution_(std::move(solution)), ring_(*solution_.ring) {}

    [[nodiscard]] const Solution& solution() const { return solution_; }
    [[nodiscard]] const Ring& ring() const { return ring_; }
    [[nodiscard]] Polynomial symbol(const std::string& name) const { return ring_.gen(*ring_.find(name)); }
    [[nodiscard]] Polynomial g(int halves) const { return ring_.gen(root(2), halves); } // g^(halves/2)
    [[nodiscard]] Polynomial s(int eighths) const { return ring_.gen(root(8), eighths); }
    [[nodiscard]] Polynomial eps(int power) const { return ring_.gen(solution_.eps, power); }
    [[nodiscard]] Polynomial cos() const { return Rational(1) / 2 * (phase(1) + phase(-1)); }
    [[nodiscard]] Polynomial sin() const {
        return product({Rational(-1) / 2 * ring_.imaginary(), phase(1) - phase(-1)});
    }
    [[nodiscard]] Polynomial product(const std::vector<Polynomial>& factors) const {
        Polynomial result = ring_.one();
        for (const Polynomial& f : factors) result = ring_.multiply(result, f);
        return result;
    }
    // The primitive of this kind; there is exactly one.
    [[nodiscard]] const Primitive& primitive(PrimitiveKind kind) const {
        const Primitive* found = nullptr;
        for (const Primitive& p : solution_.primitives) {
            if (p.kind != kind) continue;
            EXPECT_EQ(found, nullptr) << "two primitives of one kind";
            found = &p;
        }
        return *found;
    }
    [[nodiscard]] const Series& output(const std::string& name) const {
        for (const SolutionOutput& o : solution_.outputs)
            if (o.name == name) return o.value;
        throw std::logic_error("no output " + name);
    }
    void expect_equal(const Polynomial& ours, const Polynomial& papers) const {
        EXPECT_EQ(ring_.is_zero(ours - papers), Zero::yes)
            << ours.size() << " terms, paper " << papers.size();
    }

    // (22)
    [[nodiscard]] Polynomial psi() const {
        const Polynomial first = product({eps(1), c(), s(-1), cos()});
        const Polynomial bracket = Rational(8) * product({r(), v()}) + product({g(1), c(), sin(), s(5)});
        const Polynomial second = Rational(1) / 8 * product({eps(2), v(), xi(), bracket, g(-2), s(-12)});
        const Polynomial twist = product({g(2), c(), c(), s(10), five_plus_four_sin_squared()});
        const Polynomial slow = Rational(6) * product({v(), v(), Rational(2) * r2() - xi2()});
        return first + second +
               Rational(1) / 192 * product({eps(3), c(), cos(), twist + slow, g(-2), s(-13)});
    }
    // Below (23)
    [[nodiscard]] Polynomial f_x() const {
        const Polynomial bracket =
            product({v(), Rational(8) * r2() + xi2()}) + Rational(2) * product({r(), g(1), c(), sin(), s(5)});
        const Polynomial inner =
            product({xi(), sin()}) + Rational(1) / 8 * product({eps(1), cos(), bracket, g(-1), s(-6)});
        return -product({eps(2), c(), v(), g(-1), s(-3), inner});
    }
    [[nodiscard]] Polynomial f_y() const {
        const Polynomial bracket =
            Rational(7) * product({r(), v()}) + Rational(2) * product({g(1), c(), sin(), s(5)});
        const Polynomial inner =
            product({r(), sin()}) - Rational(1) / 8 * product({eps(1), xi(), cos(), bracket, g(-1), s(-6)});
        return product({eps(2), c(), v(), g(-1), s(-3), inner});
    }
    // (23); the two integrands stand under one integral
    [[nodiscard]] Polynomial x() const {
        const Polynomial log = ring_.gen(primitive(PrimitiveKind::logarithm).id);
        const Polynomial quadrature = ring_.gen(primitive(PrimitiveKind::quadrature).id);
        return symbol("C_X") + product({r(), log}) - product({r(), eps(2), quadrature}) + f_x();
    }
    [[nodiscard]] Polynomial y() const {
        const Polynomial bracket = product({r2(), v(), v(), g(-2), s(-8)}) + product({c(), c(), s(2)});
        return symbol("C_Y") + s(4) - Rational(1) / 2 * product({eps(2), bracket}) + f_y();
    }
    [[nodiscard]] Polynomial integrand_x() const {
        return product({v(), v(), xi2(), g(-2), s(-16)}) + Rational(1) / 4 * product({c(), c(), s(-6)});
    }

    [[nodiscard]] Polynomial r() const { return symbol("r"); }
    [[nodiscard]] Polynomial v() const { return symbol("v"); }
    [[nodiscard]] Polynomial xi() const { return symbol("xi"); }
    [[nodiscard]] Polynomial c() const { return symbol("C_delta"); }
    [[nodiscard]] Polynomial r2() const { return product({r(), r()}); }
    [[nodiscard]] Polynomial xi2() const { return product({xi(), xi()}); }

private:
    [[nodiscard]] Polynomial phase(int power) const {
        return ring_.gen(solution_.modes.front().phase, power);
    }
    [[nodiscard]] Polynomial five_plus_four_sin_squared() const {
        return Polynomial(Rational(5)) + Rational(4) * product({sin(), sin()});
    }
    [[nodiscard]] GeneratorId root(int index) const {
        for (GeneratorId id = 0; id < ring_.size(); ++id)
            if (ring_.generator(id).kind == GeneratorKind::root && ring_.generator(id).index == index)
                return id;
        throw std::logic_error("no such root in the ring");
    }

    Solution solution_;
    const Ring& ring_;
};

class PendulumAsPublished : public ::testing::Test {
protected:
    const Paper paper{resonform::testing::solution_of(resonform::testing::pendulum(), 3, 3)};
};

class PendulumThirdOrder : public ::testing::Test {
protected:
    const Paper paper{resonform::testing::solution_of(resonform::testing::pendulum(), 3, 4)};
};

TEST_F(PendulumAsPublished, AmplitudeIs21) {
    const ModeSolution& mode = paper.solution().modes.front();
    EXPECT_EQ(mode.envelope, paper.s(-1));
    EXPECT_EQ(mode.factor.total(3), paper.ring().one());
    EXPECT_EQ(mode.amplitude_name, "C_delta");
    EXPECT_EQ(mode.phase_name, "theta_0");
}

TEST_F(PendulumAsPublished, PhaseRateIsThatBelow21) {
    const Series& rate = paper.solution().modes.front().phase_rate;
    const Polynomial twist =
        Rational(1) / 16 * paper.product({paper.g(1), paper.c(), paper.c(), paper.s(-4)});
    const Polynomial slow =
        Rational(1) / 32 * paper.product({paper.xi2(), paper.v(), paper.v(), paper.g(-1), paper.s(-14)});
    EXPECT_EQ(rate.through(), 2);
    paper.expect_equal(rate.part(0), paper.product({paper.g(1), paper.s(-2)}));
    EXPECT_TRUE(rate.part(1).empty());
    paper.expect_equal(rate.part(2), paper.product({paper.eps(2), -twist - slow}));
}

TEST_F(PendulumAsPublished, PsiIs22) { paper.expect_equal(paper.output("psi").total(9), paper.psi()); }

TEST_F(PendulumAsPublished, XIs23) {
    paper.expect_equal(paper.output("x").total(9), paper.x());
    const Primitive& quadrature = paper.primitive(PrimitiveKind::quadrature);
    paper.expect_equal(quadrature.argument, paper.integrand_x());
    EXPECT_FALSE(quadrature.over_slow_time);
    EXPECT_EQ(quadrature.name, "Q_x2");
    const Polynomial catenary =
        paper.ring().multiply(paper.xi() + paper.s(4), paper.ring().power(paper.r(), -1));
    paper.expect_equal(paper.primitive(PrimitiveKind::logarithm).argument, catenary);
}

TEST_F(PendulumAsPublished, YIs23) { paper.expect_equal(paper.output("y").total(9), paper.y()); }

// Design 2.4: the resonant term of weight 4 adds eps^3 v^2 xi^2 C cos(theta)/(128 g s^(13/8)) to psi.
TEST_F(PendulumThirdOrder, PsiGainsTheTermOfWeight4) {
    const Polynomial term =
        Rational(1) / 128 * paper.product({paper.v(), paper.v(), paper.xi2(), paper.g(-2)});
    const ModeSolution& mode = paper.solution().modes.front();
    paper.expect_equal(mode.factor.total(9),
                       paper.ring().one() + paper.product({paper.eps(2), term, paper.s(-12)}));
    const Polynomial gain = paper.product({paper.eps(3), term, paper.c(), paper.cos(), paper.s(-13)});
    paper.expect_equal(paper.output("psi").total(9), paper.psi() + gain);
}

// x and y are fourth order as they stand: the count adds nothing to them.
TEST_F(PendulumThirdOrder, XAndYStayAsPublished) {
    paper.expect_equal(paper.output("x").total(9), paper.x());
    paper.expect_equal(paper.output("y").total(9), paper.y());
}

TEST_F(PendulumThirdOrder, StateCarriesTheMapAtItsFullWeight) {
    const auto& state = paper.solution().state;
    ASSERT_EQ(state.size(), 4U);
    EXPECT_EQ(state[0].name, "psi");
    EXPECT_EQ(state[1].name, "psi'");
    EXPECT_EQ(state[2].name, "x");
    EXPECT_EQ(state[3].name, "y");
    for (int n = 0; n <= 3; ++n) paper.expect_equal(state[0].value.part(n), paper.output("psi").part(n));
    EXPECT_EQ(state[0].value.through(), 4);
    EXPECT_FALSE(state[0].value.part(4).empty());
    // psi' = -eps C sqrt(g) s^(-3/8) sin(theta) + O(eps^2)
    paper.expect_equal(state[1].value.part(1),
                       -paper.product({paper.eps(1), paper.c(), paper.g(1), paper.s(-3), paper.sin()}));
}

} // namespace
