// SPDX-License-Identifier: GPL-3.0-or-later
// Compilers of emitted code.
#pragma once

#include "support/shell.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace resonform::test {

// What a program prints that is compiled with a committed header, scene.hpp, whose namespace is SCENE; or why
// there is no program.
inline std::string printed_beside(const std::string& scene, const std::string& program,
                                  const std::string& options) {
    const Scratch scratch;
    write(scratch.path() / "main.cpp", program);
    write(scratch.path() / "scene.hpp", "#include \"generated/" + scene + ".hpp\"\n");
    std::string name = "resonform::generated::" + scene;
    name.replace(name.find('/'), 1, "::");
    const std::string root = RESONFORM_SOURCE_DIR;
    const Outcome outcome =
        run(std::string(RESONFORM_CXX_COMPILER) + " -std=gnu++20 -O1 " + options + " -DSCENE=" + name +
                " -I. -I'" + root + "' -I'" + root + "/engine' main.cpp -o main -lquadmath && ./main",
            scratch.path());
    return outcome.code == 0 ? outcome.out : outcome.err.substr(0, 2000) + "\n(no program)";
}

// Another compiler, for as long as it lives.
class OtherCompiler {
public:
    explicit OtherCompiler(const std::string& command) {
        setenv("CXX", command.c_str(), 1); // NOLINT(concurrency-mt-unsafe)
    }
    ~OtherCompiler() { unsetenv("CXX"); } // NOLINT(concurrency-mt-unsafe)
    OtherCompiler(const OtherCompiler&) = delete;
    OtherCompiler& operator=(const OtherCompiler&) = delete;
};

// A script that replaces a text in what it compiles; it fails where the text does not occur.
inline std::string editing_compiler(const std::filesystem::path& script, const std::string& from,
                                    const std::string& to) {
    write(script, "for file in \"$@\"; do case \"$file\" in *.cpp) grep -qF '" + from +
                      "' \"$file\" || exit 3; sed -i 's|" + from + "|" + to +
                      "|' \"$file\";; esac; done\nexec " RESONFORM_CXX_COMPILER " \"$@\"\n");
    return "sh " + script.string();
}

} // namespace resonform::test
