// SPDX-License-Identifier: GPL-3.0-or-later
// Every bad input that a scene file can be, one edit of a good one each.
#include "messages.hpp"
#include "model/files/read_scene.hpp"

namespace resonform {
namespace {

class BadScene : public testing::TestWithParam<BadInput> {};

TEST_P(BadScene, IsRefusedInOneMessage) {
    const BadInput& bad = GetParam();
    EXPECT_EQ(scene_message(edited(pendulum_scene(), bad.from, bad.to)), bad.message);
}

const BadInput bad_scenes[] = {
    {"OrderZero", "order = 3", "order = 0",
     "2 scene.toml:3:9: order: 'order' is an integer in 1 ... 99\n"
     "    order = 0\n"
     "            ^\n"
     "  found: 0\n"
     "  hint:  write an integer in 1 ... 99"},
    {"OrderNegative", "order = 3", "order = -1",
     "2 scene.toml:3:9: order: 'order' is an integer in 1 ... 99\n"
     "    order = -1\n"
     "            ^\n"
     "  found: -1\n"
     "  hint:  write an integer in 1 ... 99"},
    {"OrderAbsurd", "order = 3", "order = 1000000",
     "2 scene.toml:3:9: order: 'order' is an integer in 1 ... 99\n"
     "    order = 1000000\n"
     "            ^\n"
     "  found: 1000000\n"
     "  hint:  write an integer in 1 ... 99"},
    {"OrderNoInteger", "order = 3", "order = 2.5",
     "2 scene.toml:3:9: order: 'order' is an integer in 1 ... 99\n"
     "    order = 2.5\n"
     "            ^\n"
     "  found: 2.5\n"
     "  hint:  write an integer in 1 ... 99"},
    {"OrderString", "order = 3", "order = \"3\"",
     "2 scene.toml:3:10: order: 'order' is an integer in 1 ... 99\n"
     "    order = \"3\"\n"
     "             ^\n"
     "  found: \"3\"\n"
     "  hint:  write an integer in 1 ... 99"},
    {"UnknownKey", "order = 3", "oder = 3",
     "2 scene.toml:3:1: oder: a key is one of the known ones\n"
     "    oder = 3\n"
     "    ^\n"
     "  found: oder\n"
     "  hint:  did you mean 'order'? Known are: system, title, order, time_scale, truncation, outputs, "
     "oscillating, transients, growing, error_estimate, functions, fix, start, emit, verify"},
    {"GrowingOtherwise", "order = 3", "order = 3\ngrowing = \"projekt\"",
     "2 scene.toml:4:12: growing: what grows is followed with a status, or the start is projected: project\n"
     "    growing = \"projekt\"\n"
     "               ^\n"
     "  found: \"projekt\"\n"
     "  hint:  did you mean 'project'? Known are: project, status"},
    {"BothTimeScaleAndTruncation", "time_scale = 1", "time_scale = 1\ntruncation = 4",
     "2 scene.toml:5:14: truncation: the scene gives both time_scale and truncation\n"
     "    truncation = 4\n"
     "                 ^\n"
     "  found: 4\n"
     "  hint:  remove one of the two"},
    {"TruncationBelowOrder", "time_scale = 1", "truncation = 2",
     "2 scene.toml:4:14: truncation: 'truncation' is an integer in 3 ... 99\n"
     "    truncation = 2\n"
     "                 ^\n"
     "  found: 2\n"
     "  hint:  write an integer in 3 ... 99"},
    {"TimeScaleNegative", "time_scale = 1", "time_scale = -1",
     "2 scene.toml:4:14: time_scale: 'time_scale' is an integer in 0 ... 9\n"
     "    time_scale = -1\n"
     "                 ^\n"
     "  found: -1\n"
     "  hint:  write an integer in 0 ... 9"},
    {"NoSuchOutput", "\"x\", \"y\"]", "\"x\", \"z\"]",
     "2 scene.toml:5:25: outputs[2]: the output is not a variable of the system\n"
     "    outputs = [\"psi\", \"x\", \"z\"]\n"
     "                            ^\n"
     "  found: \"z\"\n"
     "  hint:  did you mean 'x'? Known are: psi, xi, x, y"},
    {"OutputTwice", "\"x\", \"y\"]", "\"x\", \"x\"]",
     "2 scene.toml:5:25: outputs[2]: the output is listed twice\n"
     "    outputs = [\"psi\", \"x\", \"x\"]\n"
     "                            ^\n"
     "  found: \"x\"\n"
     "  hint:  remove the second"},
    {"NoOutputs", "[\"psi\", \"x\", \"y\"]", "[]",
     "2 scene.toml:5:11: outputs: 'outputs' is an array of variables, not empty\n"
     "    outputs = []\n"
     "              ^\n"
     "  found: an empty array\n"
     "  hint:  write outputs = [\"psi\"]"},
    {"OutputsNoArray", "[\"psi\", \"x\", \"y\"]", "\"psi\"",
     "2 scene.toml:5:12: outputs: 'outputs' is an array of variables, not empty\n"
     "    outputs = \"psi\"\n"
     "               ^\n"
     "  found: \"psi\"\n"
     "  hint:  write outputs = [\"psi\"]"},
    {"OscillatingNoBoolean", "outputs = ", "oscillating = \"no\"\noutputs = ",
     "2 scene.toml:5:16: oscillating: 'oscillating' is true or false\n"
     "    oscillating = \"no\"\n"
     "                   ^\n"
     "  found: \"no\"\n"
     "  hint:  write true or false, without quotes"},
    {"TransientsNoBoolean", "outputs = ", "transients = 0\noutputs = ",
     "2 scene.toml:5:14: transients: 'transients' is true or false\n"
     "    transients = 0\n"
     "                 ^\n"
     "  found: 0\n"
     "  hint:  write true or false, without quotes"},
    {"TransientsOfAMeanMotion", "outputs = ", "oscillating = false\ntransients = true\noutputs = ",
     "2 scene.toml:6:14: transients: a scene that does not oscillate has no transients\n"
     "    transients = true\n"
     "                 ^\n"
     "  found: true\n"
     "  hint:  remove it, or write oscillating = true"},
    {"OtherSystem", "system = \"almost_holonomic_pendulum\"", "system = \"another\"",
     "2 scene.toml:1:11: system: a scene names the system of its folder, 'almost_holonomic_pendulum'\n"
     "    system = \"another\"\n"
     "              ^\n"
     "  found: \"another\"\n"
     "  hint:  write system = \"almost_holonomic_pendulum\""},
    {"FixOfNoParameter", "g = 1", "gg = 1",
     "2 scene.toml:8:1: fix.gg: [fix] gives values of parameters\n"
     "    gg = 1\n"
     "    ^\n"
     "  found: 'gg'\n"
     "  hint:  did you mean 'g'? Known are: g, r, v"},
    {"FixOutsideDomain", "g = 1", "g = 0",
     "2 scene.toml:8:5: fix.g: the parameter 'g' is declared positive\n"
     "    g = 0\n"
     "        ^\n"
     "  found: 0\n"
     "  hint:  give a positive value"},
    {"FixNotFinite", "r = 1", "r = nan",
     "2 scene.toml:9:5: fix.r: 'fix.r' is a finite decimal number\n"
     "    r = nan\n"
     "        ^\n"
     "  found: nan\n"
     "  hint:  write a number such as 0.25"},
    {"FixHuge", "r = 1", "r = \"1e999999999\"",
     "2 scene.toml:9:6: fix.r: a number has at most 1000 digits, its decimal exponent included\n"
     "    r = \"1e999999999\"\n"
     "         ^\n"
     "  found: 1e999999999\n"
     "  hint:  write a shorter number, or a parameter in its place"},
    {"FixTooLarge", "r = 1", "r = \"1e900\"",
     "2 scene.toml:9:6: fix.r: the fixed value is neither zero nor between 1e-100 and 1e100 in size\n"
     "    r = \"1e900\"\n"
     "         ^\n"
     "  found: \"1e900\"\n"
     "  hint:  choose other units"},
    {"FixSymbol", "r = 1", "r = \"g\"",
     "2 scene.toml:9:6: fix.r: unknown symbol\n"
     "    r = \"g\"\n"
     "         ^\n"
     "  found: g\n"
     "  hint:  no name is known here"},
    {"UnknownStart", "C_X = 1", "C_Z = 1",
     "2 scene.toml:16:1: start.C_Z: [start] gives variables or constants of the solution\n"
     "    C_Z = 1\n"
     "    ^\n"
     "  found: 'C_Z'\n"
     "  hint:  did you mean 'C_X'? Known are: C_delta, theta_0, psi, psi', xi, C_X, x, C_Y, y"},
    {"BothKindsOfDrift", "C_X = 1", "C_X = 1\nx = 1",
     "2 scene.toml:17:5: start.x: the variable starts both from physical values and from constants\n"
     "    x = 1\n"
     "        ^\n"
     "  found: 'x' and 'C_X'\n"
     "  hint:  remove one of the two"},
    {"BothKindsOfFast", "theta_0 = 0", "psi = \"0.3*eps\"",
     "2 scene.toml:15:8: start.psi: the variable starts both from physical values and from constants\n"
     "    psi = \"0.3*eps\"\n"
     "           ^\n"
     "  found: 'psi' and 'C_delta'\n"
     "  hint:  remove one of the two"},
    {"StartTwice", "C_X = 1", "C_X = 1\n\"constant.x\" = 1",
     "2 scene.toml:17:1: start.constant.x: the start value is given twice\n"
     "    \"constant.x\" = 1\n"
     "    ^\n"
     "  found: 'constant.x' and 'C_X'\n"
     "  hint:  remove one of the two"},
    {"NoStartOfDrift", "C_X = 1\n", "",
     "2 scene.toml:12:1: start: an output starts from its value or its constant\n"
     "    [start]\n"
     "    ^\n"
     "  found: no value of 'C_X'\n"
     "  hint:  write C_X = ... under [start]"},
    {"NoStartOfFast", "C_delta = 1\n", "",
     "2 scene.toml:12:1: start: a fast variable starts from its amplitude and phase, or from its value and "
     "derivatives\n"
     "    [start]\n"
     "    ^\n"
     "  found: no value of 'C_delta'\n"
     "  hint:  write C_delta = ... under [start]"},
    {"NoStartOfVelocity", "C_delta = 1\ntheta_0 = 0", "psi = \"0.3*eps\"",
     "2 scene.toml:12:1: start: a fast variable starts from its amplitude and phase, or from its value and "
     "derivatives\n"
     "    [start]\n"
     "    ^\n"
     "  found: no value of 'psi''\n"
     "  hint:  write \"psi'\" = ... under [start]"},
    {"NoStartOfSlow", "xi = 0\n", "",
     "2 scene.toml:12:1: start: a slow variable has a start value\n"
     "    [start]\n"
     "    ^\n"
     "  found: no value of 'xi'\n"
     "  hint:  write xi = ... under [start]"},
    {"StartInAVariable", "xi = 0", "xi = \"x\"",
     "2 scene.toml:13:7: start.xi: unknown symbol\n"
     "    xi = \"x\"\n"
     "          ^\n"
     "  found: x\n"
     "  hint:  did you mean 'g'? Known are: eps, g, r, v"},
    {"StartInfinite", "xi = 0", "xi = inf",
     "2 scene.toml:13:6: start.xi: 'start.xi' is a finite decimal number\n"
     "    xi = inf\n"
     "         ^\n"
     "  found: inf\n"
     "  hint:  write a number such as 0.25"},
    {"StartSingular", "xi = 0", "xi = \"1/(g-r)\"",
     "2 scene.toml:13:7: start.xi: the start value is not finite in double precision\n"
     "    xi = \"1/(g-r)\"\n"
     "          ^\n"
     "  found: 1/(g-r)\n"
     "  hint:  give a value of moderate size"},
    {"StartUnreal", "xi = 0", "xi = \"2 + r*log(-eps)\"",
     "2 scene.toml:13:7: start.xi: the start value is not a real number for eps > 0\n"
     "    xi = \"2 + r*log(-eps)\"\n"
     "          ^\n"
     "  found: 2 + r*log(-eps), where -eps is negative at eps = 0.1\n"
     "  hint:  write the real value meant"},
    {"StartUnrealByAFixedValue", "xi = 0", "xi = \"sqrt(g - 2*r)\"",
     "2 scene.toml:13:7: start.xi: the start value is not a real number for eps > 0\n"
     "    xi = \"sqrt(g - 2*r)\"\n"
     "          ^\n"
     "  found: sqrt(g - 2*r), where -2*r + g is negative at eps = 0.1\n"
     "  hint:  write the real value meant"},
    {"StartBeyondAnArcSine", "xi = 0", "xi = \"asin(1 + eps)\"",
     "2 scene.toml:13:7: start.xi: the start value is not a real number for eps > 0\n"
     "    xi = \"asin(1 + eps)\"\n"
     "          ^\n"
     "  found: asin(1 + eps), where 1 + eps is not within -1 ... 1 at eps = 0.1\n"
     "  hint:  write the real value meant"},
    {"StartOverflows", "xi = 0", "xi = \"exp(exp(exp(9)))\"",
     "2 scene.toml:13:7: start.xi: the start value is not finite in double precision\n"
     "    xi = \"exp(exp(exp(9)))\"\n"
     "          ^\n"
     "  found: exp(exp(exp(9)))\n"
     "  hint:  give a value of moderate size"},
    {"IntervalZero", "\"1/eps\"", "0",
     "2 scene.toml:20:12: verify.interval: the interval of verification is not positive, or not finite in "
     "double precision\n"
     "    interval = 0\n"
     "               ^\n"
     "  found: 0\n"
     "  hint:  write one such as \"1/eps\""},
    {"IntervalUnreal", "\"1/eps\"", "\"log(-eps)\"",
     "2 scene.toml:20:13: verify.interval: the interval of verification is not a real number for eps > 0\n"
     "    interval = \"log(-eps)\"\n"
     "                ^\n"
     "  found: log(-eps), where -eps is negative at eps = 0.1\n"
     "  hint:  write one such as \"1/eps\""},
    {"IntervalNegative", "\"1/eps\"", "\"(g-2*r)/eps\"",
     "2 scene.toml:20:13: verify.interval: the interval of verification is not positive, or not finite in "
     "double precision\n"
     "    interval = \"(g-2*r)/eps\"\n"
     "                ^\n"
     "  found: \"(g-2*r)/eps\"\n"
     "  hint:  write one such as \"1/eps\""},
    {"IntervalInAVariable", "\"1/eps\"", "\"1/xi\"",
     "2 scene.toml:20:15: verify.interval: unknown symbol\n"
     "    interval = \"1/xi\"\n"
     "                  ^\n"
     "  found: xi\n"
     "  hint:  known are: eps, g, r, v"},
    {"EpsZero", "interval = \"1/eps\"", "eps = [0.1, 0]",
     "2 scene.toml:20:13: verify.eps[1]: eps lies in 1e-12 <= eps <= 0.5\n"
     "    eps = [0.1, 0]\n"
     "                ^\n"
     "  found: 0\n"
     "  hint:  give a small positive number"},
    {"EpsNegative", "interval = \"1/eps\"", "eps = [-0.1]",
     "2 scene.toml:20:8: verify.eps[0]: eps lies in 1e-12 <= eps <= 0.5\n"
     "    eps = [-0.1]\n"
     "           ^\n"
     "  found: -0.1\n"
     "  hint:  give a small positive number"},
    {"EpsNan", "interval = \"1/eps\"", "eps = [nan]",
     "2 scene.toml:20:8: verify.eps[0]: 'verify.eps[0]' is a finite decimal number\n"
     "    eps = [nan]\n"
     "           ^\n"
     "  found: nan\n"
     "  hint:  write a number such as 0.25"},
    {"EpsLarge", "interval = \"1/eps\"", "eps = [0.6]",
     "2 scene.toml:20:8: verify.eps[0]: eps lies in 1e-12 <= eps <= 0.5\n"
     "    eps = [0.6]\n"
     "           ^\n"
     "  found: 0.6\n"
     "  hint:  give a small positive number"},
    {"EpsTwice", "interval = \"1/eps\"", "eps = [0.1, \"1/10\"]",
     "2 scene.toml:20:14: verify.eps[1]: the ladder lists an eps twice\n"
     "    eps = [0.1, \"1/10\"]\n"
     "                 ^\n"
     "  found: \"1/10\"\n"
     "  hint:  remove the second"},
    {"EpsNoArray", "interval = \"1/eps\"", "eps = 0.1",
     "2 scene.toml:20:7: verify.eps: 'verify.eps' is an array of 1 ... 100 numbers\n"
     "    eps = 0.1\n"
     "          ^\n"
     "  found: 0.1\n"
     "  hint:  write eps = [0.1, 0.05, 0.02]"},
    {"ClaimOfNoOutput", "interval = \"1/eps\"", "claim = { z = 4 }",
     "2 scene.toml:20:11: verify.claim.z: claims and expectations are about outputs of the scene\n"
     "    claim = { z = 4 }\n"
     "              ^\n"
     "  found: 'z'\n"
     "  hint:  did you mean 'x'? Known are: psi, x, y"},
    {"ClaimString", "interval = \"1/eps\"", "claim = { x = \"4\" }",
     "2 scene.toml:20:16: verify.claim.x: 'verify.claim.x' is an integer in 1 ... 100\n"
     "    claim = { x = \"4\" }\n"
     "                   ^\n"
     "  found: \"4\"\n"
     "  hint:  write an integer in 1 ... 100"},
    {"UnknownVerdict", "interval = \"1/eps\"", "expect = { x = \"fial\" }",
     "2 scene.toml:20:17: verify.expect.x: unknown verdict: pass, fail or undecided can be expected\n"
     "    expect = { x = \"fial\" }\n"
     "                    ^\n"
     "  found: \"fial\"\n"
     "  hint:  did you mean 'fail'? Known are: pass, fail, undecided"},
    {"UlpBelowOne", "interval = \"1/eps\"", "ulp = 0.5",
     "2 scene.toml:20:7: verify.ulp: 'verify.ulp' is a number in 1 ... 1000000\n"
     "    ulp = 0.5\n"
     "          ^\n"
     "  found: 0.5\n"
     "  hint:  write ulp = 16, the default"},
    {"UlpAboveAMillion", "interval = \"1/eps\"", "ulp = 1000001",
     "2 scene.toml:20:7: verify.ulp: 'verify.ulp' is a number in 1 ... 1000000\n"
     "    ulp = 1000001\n"
     "          ^\n"
     "  found: 1000001\n"
     "  hint:  write ulp = 16, the default"},
    {"ReasonForTheDefault", "interval = \"1/eps\"", "ulp_reason = \"why not\"",
     "2 scene.toml:20:15: verify.ulp_reason: 'verify.ulp_reason' says why 'verify.ulp' is above 16\n"
     "    ulp_reason = \"why not\"\n"
     "                  ^\n"
     "  found: \"why not\"\n"
     "  hint:  remove it"},
};

TEST(SceneUlp, HasADefaultAndIsWidenedWithAReason) {
    const auto plan_with = [](const std::string& keys) {
        return read_scene_text(edited(pendulum_scene(), "interval = \"1/eps\"", keys), pendulum_scene_file(),
                               source_dir() / "systems")
            .verify;
    };
    EXPECT_EQ(plan_with("").ulp, 16);
    const VerifyPlan wide = plan_with("ulp = 1000000\nulp_reason = \"a crossing\"");
    EXPECT_EQ(wide.ulp, 1e6);
    EXPECT_EQ(wide.ulp_reason, "a crossing");
    EXPECT_EQ(plan_with("ulp = \"5/2\"").ulp, 2.5);
}

TEST(SceneFigures, HaveNumbersOfTheSource) {
    const auto plan_with = [](const std::string& figures) {
        const std::string own = "{ \"y(x)\" = [2, 3], psi = [4, 5], x = [6, 7], y = [8, 9] }";
        return read_scene_text(edited(pendulum_scene(), own, figures), pendulum_scene_file(),
                               source_dir() / "systems")
            .verify.figures;
    };
    const std::map<std::string, std::vector<int>> expected{{"psi", {4, 5}}, {"y(x)", {2}}};
    EXPECT_EQ(plan_with("{ \"y(x)\" = [2], psi = [4, 5] }"), expected);
    for (const char* wrong : {"{ z = [1] }", "{ \"y(z)\" = [1] }", "{ psi = [] }", "{ psi = [1, 2, 3] }",
                              "{ psi = [0] }", "{ psi = [\"1/2\"] }", "{ psi = [1001] }", "{ psi = 4 }"})
        EXPECT_THROW((void)plan_with(wrong), Error) << wrong;
}

TEST(SceneWithoutOutputs, HasSlowVariablesWhereNothingElseMoves) {
    const auto file = source_dir() / "systems/rotating_pendulum/scenes/s.toml";
    const Scene scene = read_scene_text("[start]\nJ = 1\nphi = 0\n", file, source_dir() / "systems");
    EXPECT_EQ(scene.outputs, std::vector<std::string>{"J"});
}

INSTANTIATE_TEST_SUITE_P(All, BadScene, testing::ValuesIn(bad_scenes), name_of);

} // namespace
} // namespace resonform
