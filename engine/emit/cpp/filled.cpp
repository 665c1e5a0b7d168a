// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/embedded_text.hpp"

#include <algorithm>
#include <stdexcept>

namespace resonform {

std::string filled(std::string_view frame,
                   const std::vector<std::pair<std::string_view, std::string>>& holes) {
    std::string text;
    while (true) {
        const std::size_t begin = frame.find('@');
        text += frame.substr(0, begin);
        if (begin == std::string_view::npos) return text;
        const std::size_t end = frame.find('@', begin + 1);
        const std::string_view name = frame.substr(begin + 1, end - begin - 1);
        const auto hole =
            std::find_if(holes.begin(), holes.end(), [&](const auto& h) { return h.first == name; });
        if (hole == holes.end()) throw std::logic_error("filled: nothing for " + std::string(name));
        text += hole->second;
        frame.remove_prefix(end + 1);
    }
}

} // namespace resonform
