// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/names.hpp"

#include "emit/display/identifier.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace resonform {

namespace {

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

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
    // the frame of emitted code
    "Real", "Number", "Wide", "Status", "Values", "State", "Start", "Parameters", "Constants", "Arguments",
    "Interval", "Evaluator", "c", "w", "t", "T", "a", "i", "parameters", "start", "given_eps", "tables",
    "flow", "values", "status", "count", "prepared", "none", "generated", "resonform", "std", "math", "sqrt",
    "sin", "cos", "log", "exp", "asinh", "sinh", "erf", "atan2", "hypot", "pow", "floor", "root", "power",
    "expm1", "log1p", "finite", "not_a_number", "magnitude", "epsilon", "digits", "pi", "number", "per",
    "within", "scaled", "Cause",
    // macros of compilers and of the C library
    "linux", "unix", "i386", "sun", "mips", "sparc", "hpux", "arm", "near", "far", "min", "max", "small",
    "major", "minor", "assert", "errno", "stdin", "stdout", "stderr", "alloca", "offsetof", "setjmp",
    "issubnormal", "math_errhandling", "I", "EOF", "NULL", "NAN", "INFINITY", "MAXFLOAT", "BIG_ENDIAN",
    "LITTLE_ENDIAN", "PDP_ENDIAN", "BYTE_ORDER", "EXIT_FAILURE", "EXIT_SUCCESS", "NFDBITS", "RAND_MAX",
    "MB_CUR_MAX", "BUFSIZ", "DOMAIN", "SING", "OVERFLOW", "UNDERFLOW", "PLOSS", "TLOSS", "X_TLOSS"};

// Families of macros: M_PI, FP_NAN, FE_INVALID, HUGE_VAL, SNANF, FD_SET, WNOHANG, be16toh, ...
const char* const prefixes[] = {"M_",    "FP_",   "FE_",   "HUGE", "SNAN",  "FD_",   "MATH_",    "WIF",
                                "WEXIT", "WSTOP", "WTERM", "WNO",  "WCONT", "WUNT",  "be16",     "be32",
                                "be64",  "le16",  "le32",  "le64", "htobe", "htole", "RESONFORM"};

bool is_macro_family(const std::string& name) {
    return std::any_of(std::begin(prefixes), std::end(prefixes),
                       [&](const char* prefix) { return name.rfind(prefix, 0) == 0; });
}

// Letters, digits and underscores; a hyphen is an underscore and any other byte _x and its two digits.
std::string ascii(const std::string& name) {
    std::string result;
    for (const char c : name) {
        if (c == '-' || c == '_' || is_letter_or_digit(c))
            result += c == '-' ? '_' : c;
        else
            result += fmt::format("_x{:02x}_", static_cast<unsigned char>(c));
    }
    return result;
}

} // namespace

CppNames::CppNames() : taken_(std::begin(words), std::end(words)) {}

std::string CppNames::unique(const std::string& wish) {
    std::string name = identifier(wish);
    // names with two underscores, or with one before a capital, belong to the compiler
    for (std::size_t at = name.find("__"); at != std::string::npos; at = name.find("__")) name.erase(at, 1);
    if (name.front() == '_') name.insert(0, "q");
    if (is_macro_family(name)) name.insert(0, "q_");
    while (!taken_.insert(name).second) name += name.back() == '_' ? "2" : "_";
    return name;
}

std::string CppNames::numbered(const std::string& prefix) {
    std::string name;
    do name = fmt::format("{}_{}", prefix, ++last_);
    while (!taken_.insert(name).second);
    return name;
}

std::string cpp_callable_name(const std::string& function) { return CppNames().unique(function); }

bool cpp_in_word(char c) { return is_letter_or_digit(c) || c == '_'; }

bool cpp_mentions(const std::string& text, const std::string& identifier) {
    for (std::size_t at = text.find(identifier); at != std::string::npos;
         at = text.find(identifier, at + 1)) {
        const std::size_t end = at + identifier.size();
        const bool starts = at == 0 || (!cpp_in_word(text[at - 1]) && text[at - 1] != '.');
        if (starts && (end == text.size() || !cpp_in_word(text[end]))) return true;
    }
    return false;
}

std::string cpp_literal(const std::string& text) {
    std::string literal = "\"";
    for (const char c : text) literal += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    return literal + "\"";
}

std::string cpp_namespace(const std::string& system, const std::string& scene) {
    return fmt::format("resonform::generated::{}::{}", CppNames().unique(ascii(system)),
                       CppNames().unique(ascii(scene)));
}

} // namespace resonform
