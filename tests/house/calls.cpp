// SPDX-License-Identifier: GPL-3.0-or-later
#include "house/calls.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace resonform::test {

namespace {

struct Token {
    std::string text;
    bool in_namespace; // no brace is open but those of namespaces
};

bool is_name(const std::string& text) {
    return std::isalpha(static_cast<unsigned char>(text.front())) != 0 || text.front() == '_';
}
// Functions begin with a small letter here, types with a large one.
bool may_be_function(const std::string& text) {
    return std::islower(static_cast<unsigned char>(text.front())) != 0 && text != "decltype";
}

// Names and punctuation without comments, texts and directives.
class Scan {
public:
    explicit Scan(const SourceFile& file) {
        for (const std::string& line : file.lines) {
            const std::string code = without_comment(line);
            if (!code.empty() && code.front() != '#') read(code);
        }
    }
    [[nodiscard]] const std::vector<Token>& tokens() const { return tokens_; }

private:
    void read(const std::string& code) {
        for (std::size_t i = 0; i < code.size();) {
            const char c = code[i];
            if (c == '"' || c == '\'') {
                i = end_of_text(code, i);
            } else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
                std::size_t end = i;
                while (end < code.size() &&
                       (std::isalnum(static_cast<unsigned char>(code[end])) != 0 || code[end] == '_'))
                    ++end;
                add(code.substr(i, end - i));
                i = end;
            } else {
                const std::size_t size =
                    code.compare(i, 2, "::") == 0 || code.compare(i, 2, "->") == 0 ? 2 : 1;
                if (std::isspace(static_cast<unsigned char>(c)) == 0) add(code.substr(i, size));
                i += size;
            }
        }
    }

    static std::size_t end_of_text(const std::string& code, std::size_t begin) {
        std::size_t i = begin + 1;
        while (i < code.size() && code[i] != code[begin]) i += code[i] == '\\' ? 2 : 1;
        return i + 1;
    }

    void add(const std::string& text) {
        if (text == "}" && !open_.empty()) open_.pop_back();
        const bool in_namespace = std::all_of(open_.begin(), open_.end(), [](bool b) { return b; });
        tokens_.push_back({text, in_namespace});
        if (text == "namespace") opens_namespace_ = true;
        if (text == ";") opens_namespace_ = false;
        if (text != "{") return;
        open_.push_back(opens_namespace_);
        opens_namespace_ = false;
    }

    std::vector<Token> tokens_;
    std::vector<bool> open_; // of each open brace: is it of a namespace?
    bool opens_namespace_ = false;
};

// What a file says of the names that a '(' follows.
struct Names {
    std::set<std::string> declared, members, called;
};

Names names_of(const SourceFile& file) {
    static const std::set<std::string> no_type{"return",    "else", "throw", "case",
                                               "co_return", "new",  "delete"};
    const Scan scan(file);
    const std::vector<Token>& tokens = scan.tokens();
    Names names;
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
        if (!may_be_function(tokens[i].text)) continue;
        const std::string &before = tokens[i - 1].text, &after = tokens[i + 1].text;
        const bool typed = (is_name(before) && no_type.count(before) == 0) || before == ">" ||
                           before == "&" || before == "*";
        if (typed && (after == "(" || after == "=" || after == "{"))
            (tokens[i].in_namespace ? names.declared : names.members).insert(tokens[i].text);
        else if (after == "(" && before != "." && before != "->" && before != "::")
            names.called.insert(tokens[i].text);
    }
    return names;
}

std::set<std::string> included_by(const SourceFile& file) {
    std::set<std::string> included;
    for (const std::string& line : file.lines)
        if (const auto path = included_file(line)) included.insert(*path);
    return included;
}

} // namespace

std::vector<std::string> calls_without_include(const std::vector<SourceFile>& files) {
    const std::size_t engine = std::string("engine/").size();
    std::map<std::string, Names> names;
    std::map<std::string, std::set<std::string>> included;
    std::map<std::string, std::set<std::string>> headers; // of a function
    std::set<std::string> members;
    for (const SourceFile& file : files) {
        const std::string path = file.path.substr(engine);
        included[path] = included_by(file);
        const Names& found = names[path] = names_of(file);
        members.insert(found.members.begin(), found.members.end());
        if (path.size() > 4 && path.compare(path.size() - 4, 4, ".hpp") == 0)
            for (const std::string& name : found.declared) headers[name].insert(path);
    }
    std::vector<std::string> found;
    for (const auto& [path, of_file] : names) {
        const std::string own = path.substr(0, path.rfind('.')) + ".hpp";
        for (const std::string& name : of_file.called) {
            const auto declared = headers.find(name);
            if (declared == headers.end() || declared->second.size() != 1 || members.count(name) != 0)
                continue;
            const std::string& header = *declared->second.begin();
            if (header == own || of_file.declared.count(name) != 0 || included[path].count(header) != 0)
                continue;
            if (const auto unit = included.find(own);
                unit != included.end() && unit->second.count(header) != 0)
                continue;
            found.push_back(path + " calls " + name + " of " + header);
        }
    }
    return found;
}

} // namespace resonform::test
