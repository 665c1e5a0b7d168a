// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a shell command as a user would, with the freshly built resonform first on the PATH.
#pragma once

#include <filesystem>
#include <string>

namespace resonform::test {

struct Outcome {
    int code = 0; // exit code; 128 + signal if it was killed
    std::string out, err;
};

// No standard input. `folder` is the current folder of the command. What the program keeps from run to run,
// all tests share; where that matters they unset RESONFORM_CACHE.
Outcome run(const std::string& command, const std::filesystem::path& folder);

// A folder of this test run that is removed at the end of the scope.
class Scratch {
public:
    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    // Copies of systems/ and generated/ of the source tree, to be used and changed freely.
    void copy_systems() const;

private:
    std::filesystem::path path_;
};

std::string read(const std::filesystem::path& file);
void write(const std::filesystem::path& file, const std::string& content);

} // namespace resonform::test
