// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files: whatever bytes they hold, the answer is a value or one Error of at most 2 kB.
#include "messages.hpp"

#include <random>

namespace resonform {
namespace {

// Flips, deletes, doubles and moves pieces of a text.
std::string damaged(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
    const std::size_t wounds = 1 + below(4);
    for (std::size_t i = 0; i < wounds; ++i) {
        const std::size_t at = below(text.size());
        const std::size_t length = std::min(text.size() - at, 1 + below(12));
        const std::string piece = text.substr(at, length);
        switch (below(5)) {
        case 0: text[at] = static_cast<char>(below(256)); break;
        case 1: text.erase(at, length); break;
        case 2: text.insert(at, piece); break;
        case 3: text.insert(below(text.size()), piece); break;
        default: text[at] = "0123456789+-*/^'\"=()[]{}.,# \n\\eE"[below(32)]; break;
        }
    }
    return text;
}

void expect_message(const std::string& message, const std::string& text) {
    if (message.empty()) return;
    EXPECT_LE(message.size(), 2050U) << text;
    EXPECT_NE(message.find("hint:"), std::string::npos) << message << "\nof\n" << text;
}

TEST(CheckMutations, DamagedSystemsAreAnswered) {
    std::mt19937 random(20240601);
    const std::string whole = pendulum_system();
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::string text = damaged(whole, random);
        const std::string message = system_message(text);
        expect_message(message, text);
        refused += message.empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 1000); // the damage is real
    EXPECT_LT(refused, 3000); // some of it only hits titles and comments
}

TEST(CheckMutations, DamagedScenesAreAnswered) {
    std::mt19937 random(20240602);
    const std::string whole = pendulum_scene();
    int refused = 0;
    for (int i = 0; i < 1500; ++i) {
        const std::string text = damaged(whole, random);
        const std::string message = scene_message(text);
        expect_message(message, text);
        refused += message.empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 500);
    EXPECT_LT(refused, 1500);
}

} // namespace
} // namespace resonform
