// SPDX-License-Identifier: GPL-3.0-or-later
// What is constant at eps = 0 is drawn over eps*t, beside direct integration; two drifts in their plane, too.
#include "model/files/read_system.hpp"
#include "model/system/system_file.hpp"
#include "verify/report/figures.hpp"

#include <gtest/gtest.h>

namespace resonform::report {

namespace {

// Every output goes the same way.
ErrorCurves straight(const std::vector<std::string>& outputs) {
    ErrorCurves curves;
    curves.eps = 0.1;
    curves.outputs = outputs;
    curves.times = {0, 5, 10};
    curves.direct.assign(outputs.size(), {0, 1, 2});
    curves.emitted = curves.direct;
    curves.error.assign(outputs.size(), {0, 0, 0});
    return curves;
}

Gallery drawn(const std::string& system, const std::vector<std::string>& former) {
    const System read =
        read_system(std::filesystem::path(RESONFORM_SOURCE_DIR) / "systems" / system / "system.toml");
    const Figures figures(read, std::filesystem::temp_directory_path() / "resonform-figures");
    return figures.transgression({{straight(former), std::nullopt, straight(former)}});
}

std::vector<std::string> names(const Gallery& gallery) {
    std::vector<std::string> list;
    for (const Figure& figure : gallery.figures) list.push_back(figure.name);
    return list;
}

using Names = std::vector<std::string>;

} // namespace

TEST(ReportFigures, FormerConstantsAreDrawn) {
    const Gallery particle = drawn("nonholonomic_particle", {"z"});
    EXPECT_EQ(names(particle), Names{"transgression_z_0_1"});
    EXPECT_EQ(particle.figures.front().caption, "z over εt, ε = 0.1");
    for (const char* part : {"direct integration", "evaluator", "εt", "z, m"})
        EXPECT_NE(particle.figures.front().svg.find(part), std::string::npos) << part;
}

TEST(ReportFigures, TwoDriftsAreDrawnInTheirPlane) {
    const Gallery pendulum = drawn("almost_holonomic_pendulum", {"xi", "x", "y"});
    EXPECT_EQ(names(pendulum),
              (Names{"transgression_xi_0_1", "transgression_x_0_1", "transgression_y_0_1", "path_0_1"}));
    EXPECT_EQ(pendulum.figures.back().caption, "y over x, ε = 0.1");
}

TEST(ReportFigures, RoundingIsDrawnOverEachInput) {
    const System read = read_system(std::filesystem::path(RESONFORM_SOURCE_DIR) /
                                    "systems/almost_holonomic_pendulum/system.toml");
    Stability s;
    s.histogram = {{"psi", {}}, {"x", {}}};
    s.refused_by = {{"overflow", 2}};
    s.by_decade = {
        {{"xi_0", 1e-3, 1e3, true, true, 1}, {{{}, 3, {}, {1, 2}}, {-2, 4, {{"overflow", 2}}, {0, 32}}}},
        {{"C_X", 1e-3, 1e3}}};
    const auto drawn = [&](bool whether) {
        return Figures(read, std::filesystem::temp_directory_path() / "resonform-figures", whether)
            .stability(s);
    };
    EXPECT_TRUE(drawn(false).figures.empty());
    const Gallery gallery = drawn(true);
    EXPECT_TRUE(gallery.small);
    EXPECT_EQ(names(gallery), Names{"stability_xi_0"}) << "nothing is known over C_X";
    const Figure& figure = gallery.figures.front();
    EXPECT_EQ(figure.caption, "Worst errors over ξ_0, by decades");
    // 0 to the left of all others; 0 ulp at the foot; the threshold; crosses below
    EXPECT_EQ(figure.csv, "quantity,curve,\"|ξ_0| / ε\",value,mark\n"
                          "\"ulp\",\"ψ\",0.003,1,\"0\"\n\"ulp\",\"ψ\",0.03,0.1,\"\"\n"
                          "\"ulp\",\"x\",0.003,2,\"\"\n\"ulp\",\"x\",0.03,32,\"\"\n"
                          "\"ulp\",\"\",0.003,16,\n\"ulp\",\"\",0.03,16,\n\"ulp\",\"\",0.03,0.05,\n");
    EXPECT_EQ(figure.svg.find("NaN"), std::string::npos);
}

} // namespace resonform::report
