// SPDX-License-Identifier: GPL-3.0-or-later
// A key that is given twice: the message has the place and the path of the second.
#include "messages.hpp"

namespace resonform {
namespace {

class EqualKeys : public testing::TestWithParam<BadInput> {};

TEST_P(EqualKeys, AreSaidWithThePlaceOfTheSecond) {
    const BadInput& bad = GetParam();
    EXPECT_EQ(system_message(edited(pendulum_system(), bad.from, bad.to)), bad.message);
}

const BadInput equal_keys[] = {
    {"DefinedTwice", "v = { unit", "g = { unit",
     "2 system.toml:9:1: parameters.g: a key is given once, a table too\n"
     "    g = { unit = \"m/s\" }\n"
     "    ^\n"
     "  found: g = { unit = \"m/s\" }\n"
     "  hint:  remove one of the two"},
    {"DefinedTwiceInside", "v = { unit = \"m/s\" }", "v = { unit = \"m/s\", unit = \"m\" }",
     "2 system.toml:9:21: parameters.v.unit: a key is given once, a table too\n"
     "    v = { unit = \"m/s\", unit = \"m\" }\n"
     "                        ^\n"
     "  found: v = { unit = \"m/s\", unit = \"m\" }\n"
     "  hint:  remove one of the two"},
    {"TableTwice", "[notation]", "[variables]",
     "2 system.toml:23:2: variables: a key is given once, a table too\n"
     "    [variables] # the paper's names for the constants of the solution\n"
     "     ^\n"
     "  found: [variables] # the paper's names for the constants of the sol...\n"
     "  hint:  remove one of the two"},
};

INSTANTIATE_TEST_SUITE_P(All, EqualKeys, testing::ValuesIn(equal_keys), name_of);

} // namespace
} // namespace resonform
