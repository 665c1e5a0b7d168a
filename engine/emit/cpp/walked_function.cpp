// SPDX-License-Identifier: GPL-3.0-or-later
// Functions whose statements would be too many: those of a loop that walks a text (emit/cpp/walk.hpp).
#include "emit/cpp/digits.hpp"
#include "emit/cpp/function.hpp"
#include "emit/cpp/names.hpp"
#include "emit/cpp/walk.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace resonform {

using Value = StraightLine::Value;

bool CppFunction::walk(const std::vector<Value>& order, const std::vector<Value>& roots) {
    std::set<Value> known;
    for (const auto& [v, text] : texts_) known.insert(v);
    for (const auto& [v, wish] : given_) known.insert(v);
    walk_ = cpp_walk(*code_, order, known, roots, first_);
    if (!walk_) return false;
    for (const auto& [v, place] : walk_->inputs) {
        const auto known = texts_.find(v);
        const auto given = given_.find(v);
        const std::string text = known != texts_.end()   ? known->second.text
                                 : given != given_.end() ? given->second.second
                                                         : expression(v).text;
        statements_.push_back({fmt::format("w[{}]", place), text, false});
        texts_[v] = {statements_.back().target, Level::atom};
    }
    for (const Value v : roots) texts_[v] = {fmt::format("w[{}]", walk_->place_of.at(v)), Level::atom};
    return true;
}

std::string CppFunction::print_first(const Frame& frame, const std::string& walked) const {
    std::string last;
    for (const std::string& line : frame.last) last += "        " + line + "\n";
    return text_of(fmt::format("{} {} {}", frame.head, frame.result, frame.name), frame.parameters,
                   walk_call(walked, frame.parameters, walk_->first_texts) + last);
}

// Of a function's parameters, those that its walk begins with.
CppFunction::Parameters CppFunction::inputs_of_walk(Parameters parameters) const {
    const std::string inputs = statement_lines(0, statements_.size(), {});
    std::erase_if(parameters, [&](const auto& parameter) { return !cpp_mentions(inputs, parameter.second); });
    return parameters;
}

// The texts of the walk, and the function that runs the first of them.
std::string CppFunction::walking(const Frame& frame) const {
    std::vector<std::string> texts;
    for (const std::string& text : walk_->texts) texts.push_back(literal_lines(text));
    Parameters parameters = inputs_of_walk(frame.parameters);
    parameters.emplace_back(fmt::format("std::array<{}, {}>&", type_, walk_->places), "w");
    parameters.emplace_back("std::size_t", "texts");
    return fmt::format("    static constexpr auto {0}_numbers = resonform::ratios<{1}>(\n{2});\n"
                       "    static constexpr std::array {0}_texts{{\n{3}}};\n",
                       frame.name, walk_->count, literal_lines(walk_->numbers), fmt::join(texts, ",\n")) +
           text_of(fmt::format("{} void {}_walk", frame.head, frame.name), parameters,
                   statement_lines(0, statements_.size(), {}) +
                       fmt::format("        for (std::size_t k = 0; k < texts; ++k)\n"
                                   "            resonform::Walk<{0}, {1}, {2}>(w.data(), {3}_numbers.data(), "
                                   "{3}_texts[k]).run();\n",
                                   walk_->digits, walk_->functions, type_, frame.name)) +
           "\n";
}

std::string CppFunction::walk_call(const std::string& function, const Parameters& parameters,
                                   std::size_t texts) const {
    std::string arguments;
    for (const auto& parameter : inputs_of_walk(parameters)) arguments += parameter.second + ", ";
    return fmt::format("        std::array<{}, {}> w;\n        {}_walk({}w, {});\n", type_, walk_->places,
                       function, arguments, texts);
}

// The statements that copy the results of a walk to where they belong.
std::string CppFunction::copies_of_walk() const {
    std::string text;
    std::set<Value> listed;
    for (const auto& [list, array] : lists_) {
        text += fmt::format("        resonform::Walk<{}, {}, {}>(w.data(), nullptr,\n{}).copy_to({});\n",
                            walk_->digits, walk_->functions, type_, literal_lines(walk_->list(list)), array);
        listed.insert(list.begin(), list.end());
    }
    for (const auto& [v, target] : targets_)
        if (!listed.contains(v)) text += fmt::format("        {} = {};\n", target, texts_.at(v).text);
    return text;
}

} // namespace resonform
