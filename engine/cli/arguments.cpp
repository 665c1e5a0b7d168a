// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.hpp"

#include "model/system/scene_file.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/expression.hpp"
#include "model/text/nearest.hpp"
#include "normalize/recursion/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace resonform {

namespace {

[[noreturn]] void beyond_double(const std::string& option, const std::string& text) {
    bad_argument(option, "a number is 0, or of size 1e-307 ... 1e308, as a double can be", text,
                 "give a number of moderate size");
}

// A fraction, rounded once.
std::optional<double> read_fraction(const std::string& option, const std::string& text) {
    std::optional<Rational> exact;
    try {
        exact = parse_rational(text);
    } catch (const Error&) { // the caller knows what the option may be
        return std::nullopt;
    }
    const double value = to_double(*exact);
    if (!std::isfinite(value) || (value == 0) != cln::zerop(*exact)) beyond_double(option, text);
    return value;
}

// The whole text as a decimal number or a fraction; also nan and inf, as its reader decides. from_chars
// knows no locale.
std::optional<double> read_double(const std::string& option, const std::string& text) {
    if (text.find('/') != std::string::npos) return read_fraction(option, text);
    double value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, value);
    if (end != last || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range) beyond_double(option, text);
    return value;
}

// "a,b" -> "a", "b"; "" -> "".
std::vector<std::string> split_at_commas(const std::string& text) {
    std::vector<std::string> items;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        items.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return items;
}

// The last of a list is none of those before.
template <class Value>
void require_new(const std::vector<Value>& list, const std::string& option, const std::string& thing,
                 const std::string& text, const std::string& item) {
    if (std::find(list.begin(), list.end() - 1, list.back()) != list.end() - 1)
        bad_argument(option, fmt::format("each {} must be given once", thing), text,
                     "leave out the second " + item);
}

// "1,2,3": each item as read(item), all different, in ascending order.
template <class Read> auto read_list(const std::string& option, const std::string& text, const Read& read) {
    std::vector<decltype(read(text))> list;
    for (const std::string& item : split_at_commas(text)) {
        list.push_back(read(item));
        require_new(list, option, "number", text, item);
    }
    std::sort(list.begin(), list.end());
    return list;
}

} // namespace

std::string as_found(const std::string& value) {
    const bool shows = !value.empty() && value.front() != ' ' && value.back() != ' ';
    return shows ? printable(value) : "'" + printable(value) + "'";
}

void bad_argument(const std::string& option, const std::string& rule, const std::optional<std::string>& value,
                  const std::string& hint) {
    Place place;
    place.key = option;
    bad_input(Reason::command_line, {rule, value ? as_found(*value) : "", hint, place});
}

std::uint64_t read_integer(const std::string& option, const std::string& text, std::uint64_t lowest,
                           std::uint64_t highest, std::uint64_t example) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < lowest || number > highest)
        bad_argument(option, fmt::format("must be an integer from {} to {}", lowest, highest), text,
                     fmt::format("give for example {} {}", option, example));
    return number;
}

std::vector<std::uint64_t> read_integers(const std::string& option, const std::string& text,
                                         std::uint64_t lowest, std::uint64_t highest, std::uint64_t example) {
    return read_list(option, text, [&](const std::string& item) {
        return read_integer(option, item, lowest, highest, example);
    });
}

int read_order(const std::string& option, const std::string& text, int root, int highest) {
    if (root == 1)
        return static_cast<int>(read_integer(option, text, 1, static_cast<std::uint64_t>(highest), 3));
    Rational held = 0;
    try {
        held = parse_rational(text) * root;
    } catch (const Error&) { // 0 is no order either
    }
    if (cln::denominator(held) != 1 || held < 1 || held > highest * root)
        bad_argument(
            option,
            fmt::format("must be a multiple of 1/{0}, as weights and powers of eps are, from 1/{0} to {1}",
                        root, highest),
            text, fmt::format("give for example {0} 3 or {0} {1}/{2}", option, 2 * root + 1, root));
    return cln::cl_I_to_int(cln::numerator(held));
}

std::vector<int> read_orders(const std::string& option, const std::string& text, int root, int highest) {
    return read_list(option, text,
                     [&](const std::string& item) { return read_order(option, item, root, highest); });
}

int read_digits(const std::string& text) {
    return text.empty() ? 0
                        : static_cast<int>(read_integer("--digits", text, fewest_digits, most_digits, 30));
}

Rational read_eps(const std::string& text) {
    const std::string hint = "give for example --eps 0.01 or --eps 1/100";
    const auto no_number = [&] {
        bad_argument("--eps", "must be a decimal number or a fraction > 0", text, hint);
    };
    Rational eps;
    try {
        eps = parse_rational(text);
    } catch (const Error&) {
        no_number();
    }
    if (eps <= 0) no_number();
    if (to_double(eps) < smallest_eps || to_double(eps) > largest_eps)
        bad_argument("--eps", std::string(eps_rule) + ", where the expansion in eps has a meaning", text,
                     hint);
    return eps;
}

std::vector<Rational> read_eps_list(const std::string& text) {
    std::vector<Rational> list;
    for (const std::string& item : split_at_commas(text)) {
        list.push_back(read_eps(item));
        require_new(list, "--eps", "eps", text, item);
    }
    return list;
}

double read_limit(const std::string& option, const std::string& text) {
    if (text == "none") return std::numeric_limits<double>::infinity();
    const auto limit = read_double(option, text);
    if (!limit || !std::isfinite(*limit) || *limit <= 0)
        bad_argument(option, "must be a decimal number or a fraction > 0, or none", text,
                     fmt::format("give for example {} 600", option));
    return *limit;
}

double read_count_limit(const std::string& option, const std::string& text) {
    if (text == "none") return std::numeric_limits<double>::infinity();
    const double limit = read_double(option, text).value_or(0);
    if (!std::isfinite(limit) || limit < 1 || limit != std::floor(limit))
        bad_argument(option, "must be a whole number >= 1, or none", text,
                     fmt::format("give for example {} 1000000", option));
    return limit;
}

std::vector<double> read_times(const std::string& text) {
    std::vector<double> times;
    for (const std::string& item : split_at_commas(text)) {
        const auto t = read_double("--t", item);
        if (!t)
            bad_argument("--t", "times must be decimal numbers or fractions, separated by commas",
                         item.empty() ? text : item, "give for example --t 0,1/3,10.5");
        times.push_back(*t);
    }
    return times;
}

std::vector<Setting> read_settings(const std::vector<std::string>& texts) {
    std::vector<Setting> settings;
    for (const std::string& text : texts) settings.push_back(read_setting(text, "--set"));
    return settings;
}

std::optional<Style> read_style(const std::string& text) {
    if (text.empty()) return std::nullopt;
    return style_of(read_choice("--style", text, style_names()));
}

std::string read_choice(const std::string& option, const std::string& text,
                        const std::vector<std::string>& known) {
    for (const std::string& choice : known)
        if (choice == text) return choice;
    const std::string near = nearest(text, known);
    bad_argument(option, fmt::format("must be one of {}", fmt::join(known, ", ")), text,
                 near.empty() ? fmt::format("give {}", known.front())
                              : fmt::format("did you mean {}?", near));
}

std::vector<std::string> read_choices(const std::string& option, const std::string& text,
                                      const std::vector<std::string>& known) {
    std::vector<std::string> list;
    for (const std::string& item : split_at_commas(text)) {
        list.push_back(read_choice(option, item, known));
        require_new(list, option, "name", text, item);
    }
    return list;
}

} // namespace resonform
