// SPDX-License-Identifier: GPL-3.0-or-later
// The values of the command line: read as text, checked here, one message with its hint when wrong.
#pragma once

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/files/settings.hpp"
#include "model/system/style.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

// As a complaint tells it: in quotes, where it is empty or begins or ends with a space.
std::string as_found(const std::string& value);
// Refuses an argument, with its option as the place. nullopt: the option has no value at all; "" is an empty
// one.
[[noreturn]] void bad_argument(const std::string& option, const std::string& rule,
                               const std::optional<std::string>& value, const std::string& hint);

// Returns read(); a complaint that names no place gets the option as its place.
template <class Read> auto of_argument(const std::string& option, const Read& read) {
    try {
        return read();
    } catch (const Error& error) {
        const Diagnostic& d = error.diagnostic();
        if (error.kind() != ErrorKind::bad_input || !d.place.key.empty()) throw;
        bad_argument(option, d.rule, d.value, d.hint);
    }
}

// lowest ... highest; `example` is for the complaint.
std::uint64_t read_integer(const std::string& option, const std::string& text, std::uint64_t lowest,
                           std::uint64_t highest, std::uint64_t example);
// "1,2,3": several of these, all different, in ascending order.
std::vector<std::uint64_t> read_integers(const std::string& option, const std::string& text,
                                         std::uint64_t lowest, std::uint64_t highest, std::uint64_t example);
// 1 ... highest, "3"; with weights and powers of eps in multiples of 1/root also "5/2". In units of 1/root,
// as weights are held.
int read_order(const std::string& option, const std::string& text, int root, int highest = 99);
// "1,3/2": several of these, all different, in ascending order.
std::vector<int> read_orders(const std::string& option, const std::string& text, int root, int highest);
// A decimal number or a fraction, exactly, within smallest_eps ... largest_eps: "0.01", "1/100".
Rational read_eps(const std::string& text);
// "0.01,1/100": several of these, all different.
std::vector<Rational> read_eps_list(const std::string& text);
// A decimal number > 0, or "none": infinity.
double read_limit(const std::string& option, const std::string& text);
// A whole number >= 1, or "none".
double read_count_limit(const std::string& option, const std::string& text);
// "0,1.5,2e3": decimal numbers, `nan` and `inf` included: those get a status, not a message.
std::vector<double> read_times(const std::string& text);
// NAME=VALUE each.
std::vector<Setting> read_settings(const std::vector<std::string>& texts);
// nullopt for "": the style of the file.
std::optional<Style> read_style(const std::string& text);
// 0 for "": exact coefficients.
int read_digits(const std::string& text);
// One of `known`; the complaint lists them and names the nearest.
std::string read_choice(const std::string& option, const std::string& text,
                        const std::vector<std::string>& known);
// "a,b": several of these, all different.
std::vector<std::string> read_choices(const std::string& option, const std::string& text,
                                      const std::vector<std::string>& known);

} // namespace resonform
