// SPDX-License-Identifier: GPL-3.0-or-later
#include "house/tree.hpp"

#include <algorithm>
#include <fstream>

namespace resonform::test {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> read_lines(const fs::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

} // namespace

std::vector<SourceFile> files_below(const std::vector<std::string>& folders,
                                    const std::vector<std::string>& extensions) {
    return files_below(RESONFORM_SOURCE_DIR, folders, extensions);
}

std::vector<SourceFile> files_below(const fs::path& root, const std::vector<std::string>& folders,
                                    const std::vector<std::string>& extensions) {
    std::vector<SourceFile> files;
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) continue;
            files.push_back({fs::relative(entry.path(), root).string(), read_lines(entry.path())});
        }
    std::sort(files.begin(), files.end(),
              [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

std::optional<std::string> included_file(const std::string& line) {
    const std::string start = "#include \"";
    if (line.compare(0, start.size(), start) != 0) return std::nullopt;
    return line.substr(start.size(), line.rfind('"') - start.size());
}

std::string without_comment(const std::string& line) {
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '\\') {
            ++i;
        } else if (line[i] == '"') {
            quoted = !quoted;
        } else if (!quoted && line.compare(i, 2, "//") == 0) {
            return line.substr(0, i);
        }
    }
    return line;
}

} // namespace resonform::test
