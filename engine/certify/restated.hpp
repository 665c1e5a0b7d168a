// SPDX-License-Identifier: GPL-3.0-or-later
// What a solution takes from a normal form, held against it by the route of the certificate: at random points
// modulo primes, with states formed as the certificate forms them, z = w + h and u = T z.
//
//   rate of a mode           N_k = (r_k + i theta' + chi') z_k through the weight that the solution keeps
//   of an angle, ...         likewise without z
//   a state, an output       u = T (w + h) through its weight, with the user's shift of [equilibrium]
//
// Nothing that made the solution is used. What is wrong in it and no ladder can tell, a term of 10^5 ulp
// below an error of eps^2, is found here.
#pragma once

#include "certify/points/program.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace resonform {

struct Restated {
    // Homogeneous parts by weight; it is held to be the rate through series.through().
    struct Rate {
        SeriesName of; // a rate
        Series series;
    };
    struct OfState {
        std::string name; // FirstOrderSystem::state; of a drift: what the map adds to it
        Series series;
    };
    std::vector<Rate> rates;
    std::vector<OfState> states;
    std::vector<std::size_t> at_zero; // modes that are left out: all of it holds with z_k = 0
};

// "" if all of it holds; else the first that does not. The probability that something wrong is passed is
// below 1e-30, for the normal form and the map themselves hold. Errors (refused): those of certify().
std::string complaint_of(const Restated& restated, const NormalForm& normal_form, const NearIdentityMap& map,
                         std::uint64_t seed = 1);

} // namespace resonform
