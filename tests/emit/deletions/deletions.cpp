// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/deletions/deletions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <regex>
#include <sstream>

namespace resonform::test {
namespace {

bool is_name_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::size_t times_used(const std::string& name, const std::string& text) {
    std::size_t times = 0;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const bool begins = at == 0 || !is_name_character(text[at - 1]);
        const std::size_t end = at + name.size();
        if (begins && (end == text.size() || !is_name_character(text[end]))) ++times;
    }
    return times;
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// At the commas that stand in no bracket. (A '<' is taken for one where a type begins, as in array<Real, 2>.)
std::vector<std::string> split_at_commas(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        const bool of_type = k > 0 && is_name_character(text[k - 1]);
        depth += c == '(' || c == '{' || c == '[' || (c == '<' && of_type) ? 1 : 0;
        depth -= c == ')' || c == '}' || c == ']' || (c == '>' && depth > 0) ? 1 : 0;
        if (c == ',' && depth == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

// One statement, declaration, or head of a block, of one line or more.
struct Unit {
    std::string text; // lines joined by '\n'
    [[nodiscard]] bool opens() const { return text.ends_with("{"); }
    [[nodiscard]] bool closes() const { return trimmed(text).starts_with("}"); }
};

int depth_after(const std::string& text, char open, char close) {
    return static_cast<int>(std::count(text.begin(), text.end(), open) -
                            std::count(text.begin(), text.end(), close));
}

bool is_complete(const std::string& text) {
    const std::string last = trimmed(text);
    if (depth_after(text, '(', ')') != 0) return false;
    if (last.starts_with("}")) return true;
    const int braces = depth_after(text, '{', '}');
    if (last.ends_with("{"))
        return braces == 1 && last.find(" = [") == std::string::npos && !last.ends_with("{{");
    return braces == 0 && (last.ends_with(";") || last.ends_with("}") || last.ends_with(":"));
}

std::vector<Unit> units_of(const std::string& header) {
    std::vector<Unit> units;
    std::istringstream lines(header);
    std::string line, text;
    while (std::getline(lines, line)) {
        line = line.substr(0, line.find(" // "));
        const std::string bare = trimmed(line);
        if (bare.empty() || bare.starts_with("//")) continue;
        if (text.empty() && bare.starts_with("#")) {
            units.push_back({line});
            continue;
        }
        text += text.empty() ? line : "\n" + line;
        if (!is_complete(text)) continue;
        units.push_back({text});
        text.clear();
    }
    if (!text.empty()) units.push_back({text});
    return units;
}

bool is_type_head(const std::string& text) {
    return std::regex_search(text, std::regex(R"(^\s*(template <[^>]*>\s*)?(struct|class|namespace)\b)"));
}

// The names that a declaration declares; none: it is no declaration.
std::vector<std::string> declared(const std::string& unit) {
    static const std::regex declaration(
        R"(^(?:mutable |static |constexpr |const )*(?:using (?=\w+ =))?(?!return\b|if\b|else\b|friend\b|using namespace)((?:[\w:]+(?:<.*?>)?(?: [\w:]+::\*)?(?: const)?[&*]? )?)(\w+)( =|;|\(|\{).*$)");
    std::vector<std::string> names;
    const std::string flat = std::regex_replace(unit, std::regex("\\s+"), " ");
    bool first = true;
    for (const std::string& part : split_at_commas(trimmed(flat))) {
        std::smatch found;
        const std::string bare = trimmed(part);
        if (first) {
            if (!std::regex_match(bare, found, declaration)) return {};
            const bool has_type = found[1].length() > 0 || bare.starts_with("using ");
            if (!has_type) return {};
            names.push_back(found[2]);
        } else {
            names.push_back(bare.substr(0, bare.find_first_of(" ={(;")));
        }
        first = false;
    }
    return names;
}

class Planter {
public:
    Planter(const std::string& header, const std::string& runtime)
        : units_(units_of(header)), everywhere_(header + runtime) {}

    Deletions planted() {
        for (std::size_t k = 0; k < units_.size(); ++k) plant(k);
        return std::move(result_);
    }

private:
    void plant(std::size_t k) {
        const Unit& unit = units_[k];
        std::string text = unit.text;
        if (unit.closes() && !in_function_.empty()) in_function_.pop_back();
        const bool statement =
            !in_function_.empty() && in_function_.back() && !unit.closes() && !unit.opens();
        if (unit.opens()) {
            in_function_.push_back(!is_type_head(text));
            function_ = text;
        } else if (statement) {
            text = without(k);
        } else if (!unit.closes() && text.ends_with(";") && text.find('(') == std::string::npos) {
            require_used(text);
        }
        result_.text += text + "\n";
    }

    std::string gone(const std::string& place) {
        result_.places.push_back(place);
        return fmt::format("gone({})", result_.places.size());
    }

    // A statement of a function that may be deleted.
    std::string without(std::size_t k) {
        const std::string& text = units_[k].text;
        const std::string bare = trimmed(text);
        if (bare.starts_with("return")) // without its last statement a function does not compile
            return function_.find(" amplitudes(") == std::string::npos ? text : rows(text);
        if (!declared(bare).empty()) {
            require_used(bare);
            return text;
        }
        if (!bare.ends_with(";") || bare.starts_with("if constexpr")) return text;
        return fmt::format("if (!{}) {{ {} }}", gone(bare), bare);
    }

    std::string rows(const std::string& text) {
        const std::size_t begin = text.find('{'), end = text.rfind('}');
        if (begin == std::string::npos) return text;
        std::string made;
        for (const std::string& row : split_at_commas(text.substr(begin + 1, end - begin - 1)))
            made += fmt::format("{}({} ? Number(0) : Number({}))", made.empty() ? "" : ", ",
                                gone("row " + trimmed(row)), row);
        return text.substr(0, begin + 1) + made + text.substr(end);
    }

    void require_used(const std::string& declaration) {
        for (const std::string& name : declared(declaration))
            if (times_used(name, everywhere_) < 2) result_.unused.push_back(trimmed(declaration));
    }

    std::vector<Unit> units_;
    std::string everywhere_, function_;
    std::vector<bool> in_function_;
    Deletions result_;
};

} // namespace

Deletions planted_deletions(const std::string& header, const std::string& runtime) {
    return Planter(header, runtime).planted();
}

} // namespace resonform::test
