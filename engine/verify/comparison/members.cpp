// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/comparison/members.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace resonform {

namespace {

constexpr double variation = 0.1;
constexpr double full_turn = 6.283185307179586;
// More start values than these share a direction with an earlier one.
constexpr std::array<double, 16> primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};

double fractional(double x) { return x - std::floor(x); }

bool is_phase(const std::string& canonical) { return canonical.rfind("phase.", 0) == 0; }

} // namespace

Members::Members(const Program& program, double eps, std::size_t count) : count_(count) {
    const std::vector<double> values =
        default_start<double>(program, eps, default_parameters<double>(program, eps));
    for (std::size_t k = 0; k < values.size(); ++k) start_.push_back({program.start[k].canonical, values[k]});
}

double Members::value(std::size_t k, std::size_t member) const {
    const double turns = static_cast<double>(member) * std::sqrt(primes[k % primes.size()]);
    if (is_phase(start_[k].canonical)) return start_[k].value + full_turn * fractional(turns);
    return start_[k].value * (1 + variation * (2 * fractional(0.5 + turns) - 1));
}

GivenArguments Members::start_of(std::size_t member) const {
    GivenArguments given;
    for (std::size_t k = 0; k < start_.size(); ++k) given[start_[k].canonical] = value(k, member);
    return given;
}

std::vector<std::vector<double>> Members::arrays_for(const Program& program) const {
    std::vector<std::vector<double>> arrays;
    for (const ProgramInput& input : program.start) {
        const auto at = std::find_if(start_.begin(), start_.end(),
                                     [&](const StartValue& s) { return s.canonical == input.canonical; });
        std::vector<double> array(count_);
        for (std::size_t i = 0; i < count_; ++i)
            array[i] = value(static_cast<std::size_t>(at - start_.begin()), i);
        arrays.push_back(std::move(array));
    }
    return arrays;
}

std::vector<std::size_t> Members::some(std::size_t many) const {
    const std::size_t taken = std::min(many, count_);
    std::vector<std::size_t> members;
    for (std::size_t j = 0; j < taken; ++j)
        members.push_back(taken == 1 ? 0 : j * (count_ - 1) / (taken - 1));
    return members;
}

} // namespace resonform
