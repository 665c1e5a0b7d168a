// SPDX-License-Identifier: GPL-3.0-or-later
// Another compiler of emitted code, for as long as it lives.
#pragma once

#include "support/shell.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace resonform::test {

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
