// SPDX-License-Identifier: GPL-3.0-or-later
// The starts of an ensemble.
#pragma once

#include "verify/evaluate/program_defaults.hpp"

#include <string>
#include <vector>

namespace resonform {

// Member i has start value v_k (1 + (2 {1/2 + i sqrt(p_k)} - 1)/10), a phase v_k + 2 pi {i sqrt(p_k)}, where
// {} is the fractional part and p_k the k-th prime: a Kronecker sequence fills the box evenly. Member 0
// starts as the scene does; a value of 0 stays 0.
class Members {
public:
    Members(const Program& program, double eps, std::size_t count);

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] GivenArguments start_of(std::size_t member) const;
    // The start values of a program of the same scene, in its order: an array of all members each.
    [[nodiscard]] std::vector<std::vector<double>> arrays_for(const Program& program) const;
    // `many` members, evenly spread over all, the first and (from two on) the last among them.
    [[nodiscard]] std::vector<std::size_t> some(std::size_t many) const;

private:
    struct StartValue {
        std::string canonical;
        double value;
    };
    [[nodiscard]] double value(std::size_t k, std::size_t member) const;

    std::size_t count_;
    std::vector<StartValue> start_;
};

} // namespace resonform
