// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp_names.hpp"

#include "emit/identifier.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

const char* const words[] = {
    "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case", "catch",
    "char", "char16_t", "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield", "compl",
    "concept", "const", "const_cast", "consteval", "constexpr", "constinit", "continue", "decltype",
    "default", "delete", "do", "double", "dynamic_cast", "else", "enum", "explicit", "export", "extern",
    "false", "float", "for", "friend", "goto", "if", "inline", "int", "long", "mutable", "namespace", "new",
    "noexcept", "not", "not_eq", "nullptr", "operator", "or", "or_eq", "private", "protected", "public",
    "register", "reinterpret_cast", "requires", "return", "short", "signed", "sizeof", "static",
    "static_assert", "static_cast", "struct", "switch", "template", "this", "thread_local", "throw", "true",
    "try", "typedef", "typeid", "typename", "union", "unsigned", "using", "virtual", "void", "volatile",
    "wchar_t", "while", "xor", "xor_eq",
    // the frame of emitted code, and what macros of the C library may call themselves
    "Real", "Number", "Wide", "Status", "Values", "State", "Start", "Parameters", "Constants", "Evaluator",
    "c", "w", "t", "T", "a", "parameters", "start", "given_eps", "tables", "values", "status", "count",
    "math", "std", "resonform", "sqrt", "sin", "cos", "log", "exp", "asinh", "atan2", "hypot", "pow", "NAN",
    "INFINITY", "I", "EOF", "NULL", "errno", "assert", "unix", "linux"};

} // namespace

CppNames::CppNames() : taken_(std::begin(words), std::end(words)) {}

std::string CppNames::unique(const std::string& wish) {
    std::string name = identifier(wish);
    // names with two underscores, or with one before a capital, belong to the compiler
    for (std::size_t at = name.find("__"); at != std::string::npos; at = name.find("__")) name.erase(at, 1);
    if (name.front() == '_') name.insert(0, "q");
    while (!taken_.insert(name).second) name += name.back() == '_' ? "2" : "_";
    return name;
}

std::string CppNames::numbered(const std::string& prefix) {
    std::string name;
    do name = fmt::format("{}_{}", prefix, ++last_);
    while (!taken_.insert(name).second);
    return name;
}

} // namespace resonform
