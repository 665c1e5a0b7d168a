// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/run/installation.hpp"

#include <system_error>

namespace resonform {

namespace fs = std::filesystem;

Installation installation() {
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    if (!failed) {
        const fs::path prefix = program.parent_path().parent_path();
        Installation installed{prefix / "include/resonform", prefix / "share/resonform"};
        if (fs::is_directory(installed.headers / "runtime", failed) &&
            fs::is_directory(installed.data / "systems", failed))
            return installed;
    }
    const fs::path source_tree = RESONFORM_SOURCE_DIR;
    return {source_tree / "engine", source_tree};
}

} // namespace resonform
