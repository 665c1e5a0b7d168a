// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/axis.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "verify/run/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace resonform {

namespace {

constexpr double largest_number = 1e300, smallest_number = 1e-200; // but 0

[[noreturn]] void bad_axis(const std::string& rule, const std::string& found, const std::string& hint) {
    bad_input(Reason::command_line, {rule, found.empty() ? "''" : found, hint, {}});
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

Rational read_number(const std::string& text) {
    Rational value;
    try {
        value = parse_rational(text);
    } catch (const Error&) {
        bad_axis("a value must be a decimal number or a fraction", text,
                 "write for example eps=0.01,1/50 or eps=log(1e-3:1e-1:100)");
    }
    const double size = std::abs(to_double(value));
    if (!(size <= largest_number) || (size < smallest_number && value != 0))
        bad_axis("a value is 0, or of size 1e-200 ... 1e300", text, "give a number of moderate size");
    return value;
}

std::uint64_t read_count(const std::string& text, const std::string& axis) {
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || count < 1 || count > most_values)
        bad_axis(fmt::format("N of LO:HI:N must be an integer from 1 to {}", most_values), axis,
                 "write for example eps=0.01:0.1:10; larger ranges are swept in parts");
    return count;
}

} // namespace

const char* to_string(Spacing spacing) {
    switch (spacing) {
    case Spacing::linear: return "linear";
    case Spacing::logarithmic: return "logarithmic";
    case Spacing::list: return "list";
    }
    return "list";
}

Axis::Axis(const std::string& text, bool sampled) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos || sign == 0)
        bad_axis("an axis must be NAME=LO:HI:N, NAME=log(LO:HI:N) or NAME=V1,V2,...", text,
                 "write for example eps=log(1e-3:1e-1:100)");
    name_ = text.substr(0, sign);
    const std::string values = text.substr(sign + 1);
    if (values.find(':') == std::string::npos)
        read_list(values);
    else
        read_range(values, sampled);
}

void Axis::read_list(const std::string& text) {
    for (const std::string& item : split(text, ',')) list_.push_back(to_double(read_number(item)));
    count_ = list_.size();
}

void Axis::read_range(const std::string& text, bool sampled) {
    const bool logarithmic = text.size() > 5 && text.compare(0, 4, "log(") == 0 && text.back() == ')';
    spacing_ = logarithmic ? Spacing::logarithmic : Spacing::linear;
    const std::string found = name_ + "=" + text;
    const std::vector<std::string> parts = split(logarithmic ? text.substr(4, text.size() - 5) : text, ':');
    if (parts.size() != 3 && !(sampled && parts.size() == 2))
        bad_axis("a range must be LO:HI:N", found, "write for example eps=0.01:0.1:10");
    const Rational low = read_number(parts[0]), high = read_number(parts[1]);
    if (low > high) bad_axis("the ends of a range must be LO <= HI", found, "exchange them");
    if (logarithmic && low <= 0)
        bad_axis("a logarithmic range must have LO > 0", found, "give a positive LO, or leave out log");
    if (parts.size() == 3) count_ = read_count(parts[2], found);
    if (!sampled && count_ == 1 && low < high)
        bad_axis("a range with N = 1 must have LO = HI, for both ends are included", found,
                 "give N >= 2, or one value");
    low_ = from_rational<Float128>(low);
    high_ = from_rational<Float128>(high);
}

double Axis::between(const Float128& share) const {
    if (spacing_ == Spacing::linear) return static_cast<double>(low_ + (high_ - low_) * share);
    const Float128 low = Math<Float128>::log(low_), high = Math<Float128>::log(high_);
    return static_cast<double>(Math<Float128>::exp(low + (high - low) * share));
}

double Axis::value(std::uint64_t i) const {
    if (spacing_ == Spacing::list) return list_[i];
    if (i == 0) return static_cast<double>(low_);
    if (i + 1 == count_) return static_cast<double>(high_);
    return between(Float128(i) / Float128(count_ - 1));
}

double Axis::drawn(double u) const {
    if (spacing_ == Spacing::list) {
        const auto place = static_cast<std::size_t>(u * static_cast<double>(list_.size()));
        return list_[std::min(place, list_.size() - 1)];
    }
    return std::clamp(between(Float128(u)), least(), largest());
}

double Axis::least() const {
    return spacing_ == Spacing::list ? *std::min_element(list_.begin(), list_.end())
                                     : static_cast<double>(low_);
}

double Axis::largest() const {
    return spacing_ == Spacing::list ? *std::max_element(list_.begin(), list_.end())
                                     : static_cast<double>(high_);
}

} // namespace resonform
