// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/shell.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace resonform::test {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream content;
    content << in.rdbuf();
    return content.str();
}

void write(const fs::path& file, const std::string& content) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
}

Outcome run(const std::string& command, const fs::path& folder) {
    const Scratch scratch;
    const fs::path script = scratch.path() / "script", out = scratch.path() / "out",
                   err = scratch.path() / "err";
    write(script,
          "cd '" + folder.string() + "'\nPATH='" + fs::path(RESONFORM_COMMAND).parent_path().string() +
              "':$PATH\nexport RESONFORM_CACHE='" + RESONFORM_BINARY_DIR "/test_cache'\n" + command + "\n");
    const std::string line =
        "bash '" + script.string() + "' </dev/null >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(line.c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, read(out), read(err)};
}

Scratch::Scratch() {
    std::string name = (fs::temp_directory_path() / "resonform-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
}

Scratch::~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void Scratch::copy_systems() const {
    for (const char* folder : {"systems", "generated"})
        if (fs::exists(fs::path(RESONFORM_SOURCE_DIR) / folder))
            fs::copy(fs::path(RESONFORM_SOURCE_DIR) / folder, path_ / folder, fs::copy_options::recursive);
}

} // namespace resonform::test
