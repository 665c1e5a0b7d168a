// SPDX-License-Identifier: GPL-3.0-or-later
// The only error types of the engine. Every failure that a user can cause is an Error that says
// the rule, the place, the value and the hint; the command turns it into one message and an exit code.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace resonform {

// Exit codes of the command (docs/file_formats.md): the kind of an error decides the code.
enum class ErrorKind {
    check_failed = 1, // the second route contradicts the first: nothing derived from it may be used
    bad_input = 2,    // the user's file, expression or command line breaks a rule
    refused = 3,      // the input is meaningful but the answer cannot be given honestly
};

// Why, in one word for programs: the closed list of docs/file_formats.md (resonform.error/1). The place of
// an error says the rest, so most are by_kind: `value` of bad input, `unsupported` of a refusal.
enum class Reason {
    by_kind,
    command_line,    // words or values of the command line
    file,            // something cannot be found, read or written
    syntax,          // neither TOML nor an expression
    name,            // an unknown key or symbol
    undecided,       // the sign, or whether it is zero, is not proved
    eigenvalues,     // they have no closed form
    not_semisimple,  // the linear part has fewer eigenvectors than variables
    nonlinear_layer, // the motion at eps = 0 is not linear in the fast variables, or not uniform in an angle
    resonance,       // a divisor vanishes, or nearly does, and no relation says so
    too_fast,        // for the role, the weight or the time scale
    not_smooth,      // data, for the order
    singular,        // infinite or not real, at the origin or with the values given
    size,            // more symbols, larger exponents, ... than a representation holds
    time,            // --time-limit
    memory,          // --memory-limit
    terms,           // --term-limit
    integration,     // the direct integration does not get to the end, or has no start
    compiler,        // of emitted code: absent, ended, or dissatisfied
    fault,           // of the engine
};

// Where the offending text stands. Empty members are unknown and are not printed.
struct Place {
    std::string file;
    int line = 0;            // 1-based
    int column = 0;          // 1-based, in bytes
    std::string key;         // e.g. "equations.psi"
    std::string source_line; // the line of the file, to be shown with a caret under the column
};

// One complaint: what must hold, where it does not, the offending value, and a hint.
struct Diagnostic {
    std::string rule;
    std::string value;
    std::string hint;
    Place place;
    Reason reason = Reason::by_kind;
};

// Renders a diagnostic as one message of at most 2 kB.
std::string to_string(const Diagnostic& diagnostic);

// User text as it is shown: of moderate length, without control characters.
std::string shown(std::string_view text);

const char* to_string(Reason reason, ErrorKind kind);

class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, Diagnostic diagnostic)
        : std::runtime_error(to_string(diagnostic)), kind_(kind), diagnostic_(std::move(diagnostic)) {}

    [[nodiscard]] ErrorKind kind() const { return kind_; }
    [[nodiscard]] const Diagnostic& diagnostic() const { return diagnostic_; }

private:
    ErrorKind kind_;
    Diagnostic diagnostic_;
};

[[noreturn]] inline void bad_input(Diagnostic d) { throw Error(ErrorKind::bad_input, std::move(d)); }
[[noreturn]] inline void bad_input(Reason reason, Diagnostic d) {
    d.reason = reason;
    bad_input(std::move(d));
}
[[noreturn]] inline void refuse(Diagnostic d) { throw Error(ErrorKind::refused, std::move(d)); }
[[noreturn]] inline void refuse(Reason reason, Diagnostic d) {
    d.reason = reason;
    refuse(std::move(d));
}

// Runs `work`. A complaint of it that knows no place gets this one.
template <class Work> decltype(auto) at_place(const Place& place, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        Diagnostic d = error.diagnostic();
        if (!d.place.file.empty() || !d.place.key.empty()) throw;
        d.place = place;
        throw Error(error.kind(), std::move(d));
    }
}

} // namespace resonform
