// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that write a system and a scene of their own.
#pragma once

#include "model/files/read_scene.hpp"
#include "scene_line.hpp"
#include "support/shell.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/symbolic/evaluator.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace resonform::test {

// What the exact solution takes for the start values of a program, in their order.
inline SymbolicInputs symbolic_inputs(const Program& program, double eps, const std::vector<double>& start,
                                      double slow_time_end) {
    SymbolicInputs inputs{Wide(eps), {}, {}, Wide(slow_time_end), {}};
    for (std::size_t k = 0; k < start.size(); ++k) inputs.start[program.start[k].canonical] = Wide(start[k]);
    return inputs;
}

class WrittenSystem {
protected:
    // system: behind its name; scene: the whole file.
    Scene written(const std::string& system, const std::string& scene) {
        write(systems_ / "s/system.toml", "[system]\nname = \"s\"\n" + system);
        write(systems_ / "s/scenes/s.toml", scene);
        return read_scene(systems_ / "s/scenes/s.toml", systems_);
    }
    void write_beside(const std::string& name, const std::string& content) {
        write(systems_ / "s/scenes" / name, content);
    }

private:
    Scratch scratch_;
    std::filesystem::path systems_ = scratch_.path() / "systems";
};

class OwnSystem : public testing::Test, protected WrittenSystem {
protected:
    static void expect_pass(const Scene& scene) {
        const Verification v = verified(line_of(scene));
        for (const auto& output : v.outputs) EXPECT_EQ(output.verdict, Verdict::pass) << output.reason;
        EXPECT_TRUE(v.as_expected()) << to_text(v.emitted);
    }
};

// Outputs at t by the interpreter, which the statuses are read of, too.
class InterpretedSystem : public OwnSystem {
protected:
    struct Answer {
        Status status;
        std::vector<double> values;
        std::string why;
    };
    Answer at(const std::string& system, const std::string& scene, double eps, double t) {
        const Interpreter<double> evaluator(program_of(written(system, scene)), eps, {}, {},
                                            2 * eps * (t + 1));
        Answer answer;
        answer.status = evaluator.call(t, answer.values);
        answer.why = evaluator.why(answer.status);
        return answer;
    }
};

} // namespace resonform::test
