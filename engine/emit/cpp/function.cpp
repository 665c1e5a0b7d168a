// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/function.hpp"

#include "algebra/number/binary_parts.hpp"
#include "emit/cpp/lies.hpp"
#include "emit/cpp/names.hpp"
#include "emit/graph/graph.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace resonform {

namespace {

using Value = StraightLine::Value;

constexpr std::ptrdiff_t longest_function = 300; // operations
constexpr std::size_t longest_piece = 120;       // statements
constexpr std::size_t longest_inline = 64;       // characters

// A short integer that is not negative.
std::string integer_text(const std::string& type, const Integer& n) {
    return fmt::format("{}({}{})", type, to_string(Rational(n)), n < (Integer(1) << 31) ? "" : "LL");
}

// Calls visit(begin, end) for each quantity w.NAME of a function in pieces that a text mentions: the text
// from begin to end is its NAME.
template <class Visit> void each_quantity(const std::string& text, const Visit& visit) {
    for (std::size_t at = text.find("w."); at != std::string::npos; at = text.find("w.", at + 2)) {
        if (at > 0 && (cpp_in_word(text[at - 1]) || text[at - 1] == '.')) continue;
        std::size_t end = at + 2;
        while (end < text.size() && cpp_in_word(text[end])) ++end;
        visit(at + 2, end);
    }
}

// The same text with quantities by their names alone, but those that are passed on.
std::string with_locals(const std::string& text, const std::set<std::string>& passed_on) {
    std::string result;
    std::size_t done = 0;
    each_quantity(text, [&](std::size_t begin, std::size_t end) {
        if (passed_on.count(text.substr(begin, end - begin)) != 0) return;
        result += text.substr(done, begin - 2 - done);
        done = begin;
    });
    return result + text.substr(done);
}

// hypot(x, 0)
bool is_modulus_of_real(const StraightLine& code, const StraightLine::Instruction& i) {
    if (i.op != StraightLine::Op::function || i.function != Graph::Op::sqrt_sum_squares) return false;
    const StraightLine::Instruction& second = code.at(i.operands.back());
    return second.op == StraightLine::Op::number && second.number == 0;
}

std::string names_of(const CppFunction::Parameters& parameters) {
    std::vector<std::string> names;
    for (const auto& parameter : parameters) names.push_back(parameter.second);
    return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

std::string cpp_difference_name(const StraightLine& code, Value doubled) {
    return fmt::format("difference_{}",
                       std::distance(code.doubled().begin(), code.doubled().find(doubled)) + 1);
}

// One function of a class: its head, on two lines if need be, and its body.
std::string CppFunction::text_of(const std::string& head, const Parameters& parameters,
                                 const std::string& body) {
    std::vector<std::string> list;
    for (const auto& [type, name] : parameters)
        list.push_back(
            fmt::format("{}{} {}", cpp_mentions(body, name) ? "" : "[[maybe_unused]] ", type, name));
    std::string text = fmt::format("    {}({}) {{\n", head, fmt::join(list, ", "));
    if (text.size() > 110) text = fmt::format("    {}(\n            {}) {{\n", head, fmt::join(list, ", "));
    return text + body + "    }\n";
}

void CppFunction::compute(const std::vector<Value>& roots, bool through_constants) {
    const std::vector<Value> order = code_->behind_doubled(roots, through_constants);
    if (may_walk_ && walk(order, roots)) return;
    std::map<Value, int> uses;
    for (const Value root : roots) uses[root] += 1;
    for (const Value v : order)
        if (code_->at(v).varying || through_constants)
            for (const Value operand : code_->sources(v)) uses[operand] += 1;
    in_pieces_ = std::count_if(order.begin(), order.end(), [&](Value v) { return texts_.count(v) == 0; }) >
                 longest_function;
    for (const Value v : order)
        if (texts_.count(v) == 0) compute_one(v, uses[v]);
    for (const Value root : roots)
        if (is_coefficient(root) && targets_.count(root) == 0)
            texts_[root] = {planted(texts_[root].text), Level::atom};
}

void CppFunction::assign(const std::vector<Value>& list, const std::string& array) {
    lists_.emplace_back(list, array);
    for (std::size_t k = 0; k < list.size(); ++k) assign(list[k], fmt::format("{}[{}]", array, k));
}

void CppFunction::compute_one(Value v, int uses) {
    const StraightLine::Instruction& i = code_->at(v);
    const auto given = given_.find(v);
    const Text text = given == given_.end() ? expression(v) : Text{given->second.second, Level::atom};
    if (const auto target = targets_.find(v); target != targets_.end()) {
        statements_.push_back({target->second, is_coefficient(v) ? planted(text.text) : text.text, false});
        texts_[v] = {target->second, Level::atom};
        return;
    }
    const bool short_enough = text.text.size() <= longest_inline;
    const bool literal = i.op == StraightLine::Op::number && short_enough;
    if (literal || (uses == 1 && i.label.empty() && short_enough && given == given_.end())) {
        texts_[v] = text;
        return;
    }
    const std::string wish = given == given_.end() ? i.label : given->second.first;
    std::string name = wish.empty() ? names_.numbered(prefix_) : names_.unique(wish);
    if (in_pieces_) name = "w." + name;
    statements_.push_back({name, text.text, !in_pieces_});
    texts_[v] = {name, Level::atom};
}

std::string CppFunction::operand(Value v, Level least) const {
    const Text& text = texts_.at(v);
    if (lies_ != nullptr && is_coefficient(v)) return planted(text.text);
    return text.level >= least ? text.text : "(" + text.text + ")";
}

// 0 has no other sign, and no other size.
bool CppFunction::is_coefficient(Value v) const {
    const StraightLine::Instruction& i = code_->at(v);
    return i.op == StraightLine::Op::number && i.number != 0;
}

// Such a term is written with its own coefficient.
bool CppFunction::begins_with_number(Value v) const {
    const StraightLine::Instruction& i = code_->at(v);
    return is_coefficient(v) || (i.op == StraightLine::Op::multiply && is_coefficient(i.operands.front()));
}

std::string CppFunction::planted(const std::string& text) const {
    return lies_ == nullptr ? text : lies_->planted(text);
}

CppFunction::Text CppFunction::number(const Rational& value) const {
    const Integer numerator = cln::numerator(value), denominator = cln::denominator(value);
    if (!is_short(value)) {
        const BinaryParts binary = binary_parts(value);
        const std::string exponent = binary.exponent == 0 ? "" : fmt::format(", {}", binary.exponent);
        return {fmt::format("resonform::math::number<{}>({{{}}}{})", type_, fmt::join(binary.parts, ", "),
                            exponent),
                Level::atom};
    }
    const bool negative = value < 0;
    const std::string text = (negative ? "-" : "") + integer_text(type_, cln::abs(numerator));
    if (denominator == 1) return {text, negative ? Level::product : Level::atom};
    return {fmt::format("{} / {}", text, integer_text(type_, denominator)), Level::product};
}

CppFunction::Text CppFunction::sum_of(const StraightLine::Instruction& i) const {
    std::string text;
    const std::size_t positive = i.operands.size() - i.negative;
    for (std::size_t k = 0; k < i.operands.size(); ++k) {
        const bool minus = k >= positive;
        if (k == 0)
            text = minus ? "-" : "";
        else
            text += minus ? " - " : " + ";
        const std::string term = operand(i.operands[k], Level::product);
        text += begins_with_number(i.operands[k]) ? term : planted(term);
    }
    return {text, Level::sum};
}

CppFunction::Text CppFunction::product_of(const StraightLine::Instruction& i) const {
    std::string text;
    for (std::size_t k = 0; k < i.operands.size(); ++k) {
        const StraightLine::Instruction& factor = code_->at(i.operands[k]);
        if (k == 0 && factor.op == StraightLine::Op::number && factor.number == -1)
            text = "-";
        else
            text += (text.empty() || text == "-" ? "" : " * ") +
                    operand(i.operands[k], k == 0 ? Level::product : Level::atom);
    }
    if (lies_ != nullptr && text.front() == '-') return {planted(text), Level::atom}; // of -1
    return {text, Level::product};
}

CppFunction::Text CppFunction::function_of(const StraightLine::Instruction& i) const {
    std::vector<std::string> arguments;
    for (const Value v : i.operands) {
        const Text& argument = texts_.at(v);
        const bool is_whole = argument.level == Level::atom || (lies_ != nullptr && is_coefficient(v));
        arguments.push_back(is_whole ? operand(v, Level::atom) : fmt::format("{}({})", type_, argument.text));
    }
    if (i.op == StraightLine::Op::root && i.index != 2)
        return {fmt::format("resonform::math::root({}, {})", arguments.front(), i.index), Level::atom};
    if (i.data != nullptr)
        return {fmt::format("spline({}, {}, {})", cpp_data_name(*i.data), i.index, arguments.front()),
                Level::atom};
    if (!i.callable.empty())
        return {fmt::format("{}.{}({}, {})", callables_in_, cpp_callable_name(i.callable), i.index,
                            arguments.front()),
                Level::atom};
    if (is_modulus_of_real(*code_, i)) return {fmt::format("magnitude({})", arguments.front()), Level::atom};
    const std::string name = i.op == StraightLine::Op::root ? "sqrt" : function_name(i.function);
    return {fmt::format("{}({})", name, fmt::join(arguments, ", ")), Level::atom};
}

CppFunction::Text CppFunction::doubled(Value v) const {
    std::vector<std::string> arguments;
    for (const Value symbol : code_->sources(v))
        arguments.push_back(fmt::format("resonform::WideNumber<{}>({})", type_, texts_.at(symbol).text));
    // a name of the caller's own may be the same
    return {fmt::format("{}(Evaluator::{}({}))", type_, cpp_difference_name(*code_, v),
                        fmt::join(arguments, ", ")),
            Level::atom};
}

CppFunction::Text CppFunction::expression(Value v) const {
    const StraightLine::Instruction& i = code_->at(v);
    switch (i.op) {
    case StraightLine::Op::number: return number(i.number);
    case StraightLine::Op::add: return sum_of(i);
    case StraightLine::Op::multiply: return product_of(i);
    case StraightLine::Op::doubled: return doubled(v);
    case StraightLine::Op::reciprocal:
        if (i.varying) return {fmt::format("per({})", texts_.at(i.operands.front()).text), Level::atom};
        return {fmt::format("{}(1) / {}", type_, operand(i.operands.front(), Level::atom)), Level::product};
    default: return function_of(i);
    }
}

// Of a function in pieces: with what a piece has to itself as its locals.
std::string CppFunction::statement_lines(std::size_t begin, std::size_t end,
                                         const std::set<std::string>& passed_on) const {
    std::string text;
    for (std::size_t k = begin; k < end; ++k) {
        const Statement& s = statements_[k];
        const std::string target = with_locals(s.target, passed_on);
        text += fmt::format("        {}{} = {};\n",
                            s.declared || target.size() < s.target.size() ? "const " + type_ + " " : "",
                            target, with_locals(s.expression, passed_on));
    }
    return text;
}

// The quantities that other pieces need, or the lines behind all pieces; none may be called as the struct is.
std::set<std::string> CppFunction::passed_on(const std::vector<std::string>& last) const {
    std::set<std::string> names{"w"};
    std::map<std::string, std::size_t> piece_of;
    for (std::size_t k = 0; k < statements_.size(); ++k) {
        const auto note = [&](const std::string& text) {
            each_quantity(text, [&](std::size_t begin, std::size_t end) {
                const std::string name = text.substr(begin, end - begin);
                if (piece_of.emplace(name, k / longest_piece).first->second != k / longest_piece)
                    names.insert(name);
            });
        };
        note(statements_[k].target);
        note(statements_[k].expression);
    }
    for (const std::string& line : last)
        each_quantity(
            line, [&](std::size_t begin, std::size_t end) { names.insert(line.substr(begin, end - begin)); });
    return names;
}

std::string CppFunction::print(const Frame& frame) const {
    if (lies_ != nullptr) lies_->end_function(frame.name);
    const auto lines = [](const std::vector<std::string>& all) {
        std::string text;
        for (const std::string& line : all) text += "        " + line + "\n";
        return text;
    };
    std::string before, body = statement_lines(0, statements_.size(), {});
    if (walk_) {
        before = walking(frame);
        body = walk_call(frame.name, frame.parameters, walk_->texts.size()) + copies_of_walk();
    } else if (in_pieces_) {
        const bool is_template = frame.head.find("template") != std::string::npos;
        const std::string work = frame.name + "_quantities" + (is_template ? "<Number>" : "");
        Parameters parameters = frame.parameters;
        parameters.emplace_back(work + "&", "w");
        const std::set<std::string> shared = passed_on(frame.last);
        before = quantities(frame.name + "_quantities", is_template, shared);
        body = fmt::format("        {} w;\n", work);
        std::size_t piece = 0;
        for (std::size_t k = 0; k < statements_.size(); k += longest_piece) {
            const std::string name = fmt::format("{}_{}", frame.name, ++piece);
            const std::string part =
                statement_lines(k, std::min(k + longest_piece, statements_.size()), shared);
            before += text_of(frame.head + " void " + name, parameters, lines(frame.first) + part) + "\n";
            body += fmt::format("        {}({});\n", name, names_of(parameters));
        }
    }
    return before + text_of(fmt::format("{} {} {}", frame.head, frame.result, frame.name), frame.parameters,
                            lines(frame.first) + body + lines(frame.last));
}

// The struct of the quantities that the pieces of a long function pass on.
std::string CppFunction::quantities(const std::string& name, bool is_template,
                                    const std::set<std::string>& passed_on) const {
    std::string text =
        fmt::format("    {}struct {} {{\n", is_template ? "template <class Number> " : "", name);
    for (const Statement& s : statements_)
        if (s.target.rfind("w.", 0) == 0 && passed_on.count(s.target.substr(2)) != 0)
            text += fmt::format("        {} {};\n", type_, s.target.substr(2));
    return text + "    };\n\n";
}

} // namespace resonform
