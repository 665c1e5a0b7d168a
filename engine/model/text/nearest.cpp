// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/nearest.hpp"

#include <algorithm>
#include <cstdlib>

namespace resonform {

namespace {

constexpr std::size_t longest_compared = 60; // names beyond this are not misspelt, they are noise

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
}

} // namespace

std::string nearest(const std::string& name, const std::vector<std::string>& known) {
    if (name.empty() || name.size() > longest_compared) return "";
    std::string best;
    std::size_t best_distance = 2 + (name.size() - 1) / 3; // too far
    for (const std::string& candidate : known) {
        if (candidate.size() > longest_compared) continue;
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string suggest(const std::string& name, const std::vector<std::string>& known) {
    constexpr std::size_t listed = 20, longest_list = 300; // so that the list fits into a message
    const std::string guess = nearest(name, known);
    std::string text = guess.empty() ? "" : "did you mean '" + guess + "'? ";
    if (known.empty()) return text + "no name is known here";
    text += guess.empty() ? "known are: " : "Known are: ";
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (i > 0) text += ", ";
        const std::string shown = known[i].substr(0, longest_compared);
        if (i == listed || text.size() + shown.size() > longest_list) return text + "...";
        text += shown;
    }
    return text;
}

} // namespace resonform
