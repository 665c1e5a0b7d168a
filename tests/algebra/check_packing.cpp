// SPDX-License-Identifier: GPL-3.0-or-later
// Packed exponents: addition is exact inside the safe range and never silent outside.
#include "algebra/number/error.hpp"
#include "algebra/ring/monomial_table.hpp"
#include "rings.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace resonform {
namespace {

RingPtr plain_ring(int parameters) {
    RingBuilder b;
    for (int k = 1; k <= parameters; ++k) {
        b.add(testing::named(GeneratorKind::parameter, "p" + std::to_string(k), true));
    }
    return b.freeze();
}

TEST(Packing, WidthsByNumberOfGenerators) {
    EXPECT_EQ(Packing(1).largest(), 16383);
    EXPECT_EQ(Packing(16).largest(), 16383);
    EXPECT_EQ(Packing(17).largest(), 1023);
    EXPECT_EQ(Packing(24).largest(), 255);
    EXPECT_EQ(Packing(28).largest(), 127);
    EXPECT_EQ(Packing(32).largest(), 63);
}

class PackingLaws : public ::testing::TestWithParam<int> {};

TEST_P(PackingLaws, AddsSignedExponentsWithoutCrosstalk) {
    const int fields = GetParam();
    const Packing packing(fields);
    std::mt19937 random(7);
    std::uniform_int_distribution<int> any(-packing.largest(), packing.largest());
    for (int n = 0; n < 200; ++n) {
        std::vector<int> a, b, sum, difference;
        for (int f = 0; f < fields; ++f) {
            a.push_back(any(random));
            b.push_back(any(random));
            sum.push_back(a.back() + b.back());
            difference.push_back(a.back() - b.back());
        }
        const Monomial ma = packing.pack(a), mb = packing.pack(b);
        EXPECT_EQ(packing.unpack(ma, fields), a);
        EXPECT_TRUE(packing.safe(ma));
        EXPECT_EQ(packing.unpack(ma + mb, fields), sum);
        EXPECT_EQ(packing.unpack(ma - mb, fields), difference);
        EXPECT_EQ(ma + mb - mb, ma);
    }
}

TEST_P(PackingLaws, SeesEveryUnsafeField) {
    const int fields = GetParam();
    const Packing packing(fields);
    const int beyond = packing.largest() + 2; // the range is -largest-1 ... largest
    for (int f = 0; f < fields; ++f) {
        for (int sign : {1, -1}) {
            Monomial m = packing.power(f, sign * packing.largest());
            for (int other = 0; other < fields; ++other) {
                if (other != f) m = m + packing.power(other, -sign * packing.largest());
            }
            EXPECT_TRUE(packing.safe(m));
            EXPECT_FALSE(packing.safe(m + packing.power(f, sign * (beyond - packing.largest()))));
            EXPECT_FALSE(packing.safe(m + m));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Fields, PackingLaws, ::testing::Values(1, 4, 16, 17, 20, 23, 28, 32));

TEST(Packing, OverflowIsRefused) {
    const RingPtr ring = plain_ring(31);
    Polynomial p = testing::gen(*ring, "p31", 60);
    const Error e = test::error_when([&] {
        p = ring->multiply(p, p);           // exponent 120: past the safe range,
        p = ring->multiply(p, ring->one()); // seen at the latest here
    });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_EQ(e.diagnostic().rule,
              "an exponent of a monomial is at most 63 in this ring of up to 32 generators");
    EXPECT_THROW((void)ring->monomial(3, 64), Error);
    EXPECT_THROW((void)ring->power(testing::gen(*ring, "p1"), 64), Error);
    EXPECT_THROW((void)ring->power(testing::gen(*ring, "p1"), -65), Error);
    const RingPtr small = plain_ring(15);
    EXPECT_EQ(small->exponent(small->power(testing::gen(*small, "p15"), 10000).terms().front().monomial, 15),
              10000);
}

TEST(Packing, RelationsThatMultiplyExponentsAreGuarded) {
    RingBuilder b;
    const GeneratorId g = b.add(testing::named(GeneratorKind::parameter, "g", true));
    const GeneratorId x = b.add(testing::named(GeneratorKind::slow, "x"));
    testing::add_root(b, "G", 50, b.gen(g));
    testing::add_root(b, "s", 50, b.gen(x) + b.gen(g));
    const RingPtr ring = b.freeze();
    EXPECT_EQ(ring->gen(g, 300), testing::gen(*ring, "G", 15000));
    EXPECT_THROW((void)ring->gen(g, 400), Error); // G^20000
    EXPECT_THROW((void)ring->gen(x, 400), Error);
}

TEST(MonomialTable, HashSpreadsNeighbours) {
    const Packing packing(16);
    std::set<std::size_t> buckets;
    for (int a = -8; a < 8; ++a) {
        for (int b = 0; b < 16; ++b) {
            for (int c = 0; c < 4; ++c) {
                const Monomial m = packing.power(1, a) + packing.power(6, b) + packing.power(15, c);
                buckets.insert(MonomialTable::hash(m) >> 52);
            }
        }
    }
    EXPECT_GT(buckets.size(), 700U); // of 1024 monomials; a random function fills about 905
}

} // namespace
} // namespace resonform
