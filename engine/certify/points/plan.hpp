// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities that part (a) of a certificate computes and those that must vanish: the equations of the
// file along any map and normal form.
#pragma once

#include "certify/points/program.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <string>
#include <vector>

namespace resonform {

// The weights 0 ... weight of a slot must vanish; `above_order`: 0 ... M + weight.
struct VanishingCheck {
    Slot slot;
    int weight;
    bool above_order;
    int stage; // lower stages are reported first, and of one stage the lowest weight
    std::string sentence;
};

struct CertificatePlan {
    CertificateProgram program;
    std::vector<VanishingCheck> checks;
    std::vector<std::vector<Slot>> jacobian;           // of the equations by the highest derivatives
    std::vector<Slot> growth, omega;                   // of each mode
    std::vector<Slot> angle;                           // frequencies
    std::vector<std::pair<GeneratorId, Slot>> unknown; // Jets::unknown
    std::vector<bool> needed;                          // by slot

    // The value and the slopes that are needed of a series, by side.
    struct Reading {
        SeriesName series;
        struct OfSide {
            Side side;
            Slot value = -1; // -1: not needed
            std::vector<std::pair<GeneratorId, Slot>> slopes;
        };
        std::vector<OfSide> sides;
    };
    std::vector<Reading> readings;

    // Style hamiltonian: the coordinates of the modes as the map has them, y_a = w_a + h_a.
    struct Coordinate {
        GeneratorId id;
        Slot mapped;
        std::string mode;
    };
    std::vector<Coordinate> coordinates;
};

} // namespace resonform
