// SPDX-License-Identifier: GPL-3.0-or-later
// Law: the state that a solution gives, differentiated along slow variable and phase, obeys the
// equations of the file through weight M, exactly:  d/dt = eps c d/d xi + theta' d/d theta.
#include "solve/line.hpp"
#include "solve/systems.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using namespace resonform::testing;

namespace {

class Flow {
public:
    explicit Flow(Solution solution) : solution_(std::move(solution)), ring_(*solution_.ring) {}

    [[nodiscard]] const Ring& ring() const { return ring_; }
    [[nodiscard]] Polynomial symbol(const std::string& name) const { return ring_.gen(*ring_.find(name)); }
    [[nodiscard]] Polynomial eps() const { return ring_.gen(solution_.eps); }
    [[nodiscard]] Polynomial state(const std::string& name) const {
        for (const SolutionOutput& s : solution_.state)
            if (s.name == name) return s.value.total(solution_.truncation);
        throw std::logic_error("no state " + name);
    }
    [[nodiscard]] Polynomial rate(const Polynomial& p) const {
        const ModeSolution& mode = solution_.modes.front();
        const bool free = solution_.slow.empty();
        const GeneratorId clock = free ? *solution_.slow_time : solution_.slow.front().generator;
        const Polynomial clock_rate = free ? ring_.one() : solution_.slow.front().rate;
        const Polynomial theta =
            ring_.multiply(ring_.imaginary(), mode.phase_rate.total(solution_.truncation));
        const Polynomial turning = ring_.multiply(ring_.gen(mode.phase), ring_.derivative(p, mode.phase));
        return ring_.multiply(eps(), ring_.multiply(clock_rate, ring_.derivative(p, clock))) +
               ring_.multiply(theta, turning);
    }
    // The lowest weight through M at which p does not vanish; -1 if there is none.
    [[nodiscard]] int first_defect(const Polynomial& p) const {
        const auto parts = ring_.by_weight(p, solution_.truncation);
        for (std::size_t n = 0; n < parts.size(); ++n)
            if (ring_.is_zero(parts[n]) != Zero::yes) return static_cast<int>(n);
        return -1;
    }
    void expect_zero(const Polynomial& p) const { EXPECT_EQ(first_defect(p), -1); }

private:
    Solution solution_;
    const Ring& ring_;
};

TEST(Equations, HoldForTheStiffeningSpring) {
    for (int truncation : {3, 4, 5}) {
        const Flow flow(solution_of_text(stiffening_spring, 3, truncation));
        const Ring& ring = flow.ring();
        const Polynomial x = flow.state("x"), tau = flow.symbol("tau");
        flow.expect_zero(flow.rate(x) - flow.state("x'"));
        const Polynomial force = ring.multiply(Rational(2) * ring.one() + ring.power(tau, 2), x) +
                                 ring.multiply(ring.one() + tau, ring.power(x, 3));
        flow.expect_zero(flow.rate(flow.state("x'")) + force);
    }
}

TEST(Equations, HoldForASpringWhoseStiffnessRelaxes) {
    const Flow flow(solution_of_text(relaxing_spring, 3, 5));
    const Ring& ring = flow.ring();
    const Polynomial x = flow.state("x"), s = flow.symbol("s");
    flow.expect_zero(flow.rate(x) - flow.state("x'"));
    const Polynomial force = ring.multiply(Rational(2) * ring.one() + ring.power(s, 2), x) + ring.power(x, 3);
    flow.expect_zero(flow.rate(flow.state("x'")) + force);
}

TEST(Equations, HoldForDuffingWithADrift) {
    const Flow flow(solution_of_text(duffing, 4, 5));
    const Ring& ring = flow.ring();
    const Polynomial x = flow.state("x");
    flow.expect_zero(flow.rate(x) - flow.state("x'"));
    flow.expect_zero(flow.rate(flow.state("x'")) + x + ring.power(x, 3));
    flow.expect_zero(flow.rate(flow.state("X")) - ring.multiply(flow.eps(), ring.power(x, 2)) - flow.eps());
}

TEST(Equations, HoldForTheDampedOscillator) {
    const Flow flow(solution_of_text(damped, 4, 5));
    const Polynomial x = flow.state("x"), velocity = flow.state("x'");
    flow.expect_zero(flow.rate(x) - velocity);
    const Polynomial damping = Rational(2) * flow.ring().multiply(flow.eps(), velocity);
    flow.expect_zero(flow.rate(velocity) + damping + x + flow.ring().power(x, 3));
}

TEST(Equations, CatchAPlantedError) {
    Solution wrong = solution_of_text(duffing, 4, 5);
    Series& rate = wrong.modes.front().phase_rate;
    rate.set(2, Rational(2) * rate.part(2));
    const Flow flow(std::move(wrong));
    EXPECT_EQ(flow.first_defect(flow.rate(flow.state("x")) - flow.state("x'")), 3);
}

TEST(Equations, HoldForThePendulum) {
    for (int truncation : {3, 4, 5}) {
        const Flow flow(solution_of(pendulum(), 3, truncation));
        flow.expect_zero(flow.rate(flow.state("psi")) - flow.state("psi'"));
    }
}

} // namespace
