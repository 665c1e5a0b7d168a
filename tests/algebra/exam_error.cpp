// SPDX-License-Identifier: GPL-3.0-or-later
// The rendering of diagnostics.
#include "algebra/number/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace resonform {
namespace {

TEST(ErrorMessage, ShowsPlaceRuleValueAndMend) {
    Diagnostic d{"a name is declared", "phi", "did you mean psi?", {}};
    d.place = {"system.toml", 12, 9, "equations.psi", "psi = \"phi'' = 0\""};
    EXPECT_EQ(to_string(d), "system.toml:12:9: equations.psi: a name is declared\n"
                            "    psi = \"phi'' = 0\"\n"
                            "            ^\n"
                            "  found: phi\n"
                            "  hint:  did you mean psi?");
}

TEST(ErrorMessage, LeavesOutWhatIsUnknown) {
    EXPECT_EQ(to_string(Diagnostic{"order is at least 1", "", "", {}}), "order is at least 1");
    Diagnostic d{"order is at least 1", "0", "", {}};
    d.place.key = "order";
    EXPECT_EQ(to_string(d), "order: order is at least 1\n  found: 0");
}

TEST(ErrorMessage, ShowsAWindowOfALongLine) {
    Diagnostic d{"rule", "", "", {}};
    d.place.source_line = std::string(500000, 'a') + "?" + std::string(500000, 'b');
    d.place.column = 500001;
    EXPECT_EQ(to_string(d), "rule\n    ... " + std::string(50, 'a') + "?" + std::string(49, 'b') + " ...\n" +
                                std::string(4 + 4 + 50, ' ') + "^");
}

TEST(ErrorMessage, CountsCharactersNotBytes) {
    Diagnostic d{"rule", "", "", {}};
    d.place.source_line = "\xCF\x88\xCF\x88?";
    d.place.column = 5;
    EXPECT_EQ(to_string(d), "rule\n    \xCF\x88\xCF\x88?\n      ^");
}

TEST(ErrorMessage, IsBoundedAndPrintable) {
    Diagnostic d{std::string(100000, 'r'), std::string(100000, '\x1b'), std::string(100000, 'm'), {}};
    d.place = {std::string(100000, 'f'), 1, 3, std::string(100000, 'k'), std::string(100000, '\t')};
    const std::string message = to_string(d);
    EXPECT_LE(message.size(), 2048U);
    EXPECT_EQ(message.find('\x1b'), std::string::npos);
    EXPECT_EQ(message.find('\t'), std::string::npos);
}

} // namespace
} // namespace resonform
