// SPDX-License-Identifier: GPL-3.0-or-later
// Random systems with every role: whatever is not refused is certified, real, and has an inverse map, which
// substitutions find as well.
#include "normalize/certified.hpp"
#include "normalize/recursion/inverse_map.hpp"
#include "normalize/substituted.hpp"

#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

constexpr int order = 3;

class RandomSystem {
public:
    explicit RandomSystem(unsigned seed) : random_(seed) {
        finite_ = chance(4);
        const int fast = pick(3), slow = pick(3), angles = pick(2), drifts = pick(2);
        for (int k = 0; k < fast + (fast + slow + angles == 0 ? 1 : 0); ++k) declare_fast(k);
        for (int k = 0; k < slow; ++k) slow_.push_back("s" + std::to_string(k));
        for (int k = 0; k < angles; ++k) angles_.push_back("p" + std::to_string(k));
        for (const std::string& x : fast_) add_fast(x);
        for (const std::string& s : slow_) add(s, "slow\", positive = true }", rate());
        for (const std::string& p : angles_)
            add(p, "angle\" }", (slow_.empty() ? "3/2" : "1 + " + slow_[0] + "^2") + " + " + rate());
        for (int k = 0; k < drifts; ++k) add("X" + std::to_string(k), "drift\" }", rate());
    }

    [[nodiscard]] std::string toml() const {
        return "[system]\nname = \"random\"\n[variables]\n" + variables_ + "[equations]\n" + equations_;
    }

private:
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    bool chance(int n) { return pick(n) == 0; }
    template <class T> const T& any(const std::vector<T>& list) {
        return list[static_cast<std::size_t>(pick(static_cast<int>(list.size())))];
    }

    void declare_fast(int k) {
        const std::string name = "x" + std::to_string(k);
        fast_.push_back(name);
        states_.push_back(name);
        if (!chance(3)) states_.push_back(name + "'");
    }

    std::string coefficient() {
        static const std::vector<std::string> numbers = {"1", "2", "1/2", "-1", "-3", "1/3"};
        std::string c = "(" + any(numbers) + ")";
        if (!slow_.empty() && chance(2))
            c += chance(2) ? "*sqrt(1 + " + any(slow_) + "^2)" : "*" + any(slow_);
        return c;
    }
    std::string monomial(int degree) {
        std::string m = coefficient();
        for (int k = 0; k < degree && !states_.empty(); ++k) m += "*" + any(states_);
        if (!angles_.empty() && chance(2)) m += (chance(2) ? "*sin(" : "*cos(2*") + any(angles_) + ")";
        return m;
    }
    std::string rate() {
        std::string r = "eps*" + monomial(pick(3));
        if (!finite_ && !states_.empty() && chance(2)) r += " + " + monomial(1 + pick(2));
        return r;
    }

    void add_fast(const std::string& x) {
        const bool second = std::find(states_.begin(), states_.end(), x + "'") != states_.end();
        static const std::vector<std::string> linear = {"1", "2", "-1", "-2", "0"};
        std::string right =
            second ? "-(" + std::to_string(1 + pick(4)) + ")*" + x : "(" + any(linear) + ")*" + x;
        if (chance(4)) right += " + " + any(states_);
        if (finite_) {
            right += " + eps*" + monomial(1 + pick(3));
        } else {
            right += " + " + monomial(2 + pick(2)) + " + eps*" + monomial(1) + " + eps^2*" + monomial(0);
        }
        add(x, std::string("fast\"") + (finite_ ? ", weight = 0 }" : " }"), right, second ? "''" : "'");
    }
    void add(const std::string& name, const std::string& role, const std::string& right,
             const std::string& primes = "'") {
        variables_ += name + " = { role = \"" + role + "\n";
        equations_ += name + " = \"" + name + primes + " = " + right + "\"\n";
    }

    std::mt19937 random_;
    bool finite_ = false;
    std::vector<std::string> fast_, states_, slow_, angles_;
    std::string variables_, equations_;
};

// The expression library gives new symbols other hashes, and by them another order.
void expect_same_reading(const Normalization& first, const std::string& toml) {
    Normalization a = first, b = normalize_poincare(test::field_from(toml), order);
    const Ring &ring = *a.normal_form.field->ring, &again = *b.normal_form.field->ring;
    ASSERT_EQ(ring.size(), again.size()) << toml;
    for (GeneratorId id = 0; id < ring.size(); ++id)
        EXPECT_EQ(ring.generator(id).radicand, again.generator(id).radicand) << toml;
    const auto one = test::all_series(a), other = test::all_series(b);
    for (std::size_t k = 0; k < one.size(); ++k)
        for (int w = 0; w <= order; ++w)
            EXPECT_EQ(one[k].series->part(w), other[k].series->part(w)) << one[k].name << "\n" << toml;
}

// Whether it was normalised.
bool check(const std::string& toml) {
    try {
        const Normalization n = normalize_poincare(test::field_from(toml), order);
        const Certificate c = test::certificate_of(n);
        EXPECT_TRUE(c.holds) << c.complaint << "\n" << toml;
        expect_same_reading(n, toml);
        const GradedField& field = *n.normal_form.field;
        for (const auto* list :
             {&n.normal_form.slow, &n.normal_form.angle, &n.normal_form.drift, &n.map.slow})
            for (const Series& s : *list)
                for (int k = 0; k <= s.through(); ++k)
                    EXPECT_EQ(field.ring->conjugate(s.part(k)), s.part(k)) << toml;
        const NearIdentityMap inverse = invert(n.normal_form, n.map);
        test::Substituted(n).expect(inverse);
        for (std::size_t k = 0; k < inverse.mode.size(); ++k) {
            const Series composed = compose(field, n.map.mode[k], inverse, order);
            for (int w = 0; w <= order; ++w)
                EXPECT_TRUE(field.ring->vanishes(inverse.mode[k].part(w) + composed.part(w))) << toml;
        }
        return true;
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::refused) << e.what() << "\n" << toml;
        return false;
    }
}

TEST(RandomRoles, WhatIsNotRefusedIsCertified) {
    constexpr unsigned systems = 40;
    int normalised = 0;
    for (unsigned seed = 1; seed <= systems; ++seed)
        if (check(RandomSystem(seed).toml())) ++normalised;
    EXPECT_GE(normalised, 20);
}

} // namespace
} // namespace resonform
