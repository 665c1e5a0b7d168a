// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/regular.hpp"

#include "algebra/number/error.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using GiNaC::ex;

TEST(Regular, DivisionsByZeroOfEveryKindAreNone) {
    const GiNaC::symbol x("x"), y("y");
    const auto at_zero = [&](const ex& e) { return where_regular([&] { return e.subs(x == 0); }); };
    EXPECT_FALSE(at_zero(1 / x));
    EXPECT_FALSE(at_zero(GiNaC::log(x)));
    EXPECT_FALSE(at_zero(GiNaC::tan(x + GiNaC::Pi / 2)));
    EXPECT_FALSE(where_regular([&] { return ex(y / ((y + 1) * (y - 1) - y * y + 1)).normal(); }));
    EXPECT_FALSE(where_regular([&] { return GiNaC::numeric(1) / GiNaC::numeric(0); }));
    EXPECT_FALSE(where_regular([&] { return cln::recip(cln::cl_RA(0)); }));
    EXPECT_EQ(*at_zero(y + x), y);
}

TEST(Regular, ARefusalIsNoPole) {
    EXPECT_THROW(where_regular([]() -> ex { refuse({"a rule", "a value", "a hint", {}}); }), Error);
}

} // namespace
} // namespace resonform
