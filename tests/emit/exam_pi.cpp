// SPDX-License-Identifier: GPL-3.0-or-later
// The number pi in every format.
#include "printed.hpp"
#include "support/shell.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

TEST(Pi, IsTheConstantOfEachLanguage) {
    const auto n = certified(field_from(system_text("pi", {{"x", "fast", "x'' + x + pi/2*x^3 = 0"}})), 3);
    const auto expect_part = [&](Format format, const std::string& part) {
        const std::string document = print_normal_form(*n, 3, format);
        EXPECT_NE(document.find(part), std::string::npos) << part << "\nis not in\n" << document;
    };
    expect_part(Format::text, "z1' = I*z1 + 3*I*pi/16*z1^2*z2\n");
    expect_part(Format::json, R"("coefficient":"3*I*pi/16")");
    expect_part(Format::latex, R"(\frac{3 i \pi}{16} z_{1}^{2} z_{2})");
    expect_part(Format::maxima, "3*%i*%pi/16*z1^2*z2");
    const Scratch scratch;
    write(scratch.path() / "script.py", print_normal_form(*n, 3, Format::sympy));
    const Outcome outcome =
        run("python3 -c \"import script, sympy; print(script.normal_form['z1'][(2, 1, 0)]/sympy.pi)\"",
            scratch.path());
    EXPECT_EQ(outcome.out, "3*I/16\n") << outcome.err;
}

} // namespace
} // namespace resonform::test
