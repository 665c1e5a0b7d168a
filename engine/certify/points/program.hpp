// SPDX-License-Identifier: GPL-3.0-or-later
// The computation of a certificate at a point: a straight-line program over truncated series. The equations
// of the file are read when it is written; it then runs with residues, with balls, and with bounds of degree
// and height.
//
//   CertificateProgram p;
//   // z = w + h
//   const Slot u = p.add(p.generator(z, 1), p.value({SeriesName::mode_shift, 0}, Side::itself));
//   const Slot sine = p.function(Function::sine, u);
//
// Equal steps share one slot, so that many equal values are seen to be equal by their slots.
#pragma once

#include "algebra/number/functions.hpp"
#include "algebra/series/series.hpp"

#include <map>
#include <tuple>
#include <vector>

namespace resonform {

// The conjugate side reads i as -i and swaps the modes of a pair.
enum class Side { itself, conjugate };

// A series of the normalisation, or one that the program knows.
struct SeriesName {
    enum Kind {
        mode_rate,
        angle_rate,
        slow_rate,
        drift_rate,
        mode_shift,
        angle_shift,
        slow_shift,
        drift_shift,
        energy,
        own
    };
    Kind kind;
    std::size_t index = 0;

    friend bool operator==(const SeriesName&, const SeriesName&) = default;
    friend bool operator<(const SeriesName& a, const SeriesName& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.index < b.index;
    }
};

using Slot = int;

enum class Operation {
    number,
    generator, // id, power
    add,
    multiply,
    function,
    power, // lead * (a/a_0)^number
    inverse_power,
    integral,  // of right d(left) from weight 0: n f_n = sum_k k left_k right_(n - k)
    at_origin, // the weight-0 part
    value,     // of a series
    slope,     // of a series by a generator
};

struct Instruction {
    Operation operation;
    Slot left = -1, right = -1;
    int index = 0; // generator | exponent of inverse_power | Function
    int power = 0;
    SeriesName series{SeriesName::own};
    Side side = Side::itself;
    Rational number = 0;
};

class CertificateProgram {
public:
    Slot number(const Rational& value);
    Slot generator(GeneratorId id, int power);
    Slot add(Slot a, Slot b);
    Slot multiply(Slot a, Slot b);
    Slot function(Function function, Slot a);
    Slot power(Slot a, const Rational& exponent, Slot lead); // lead * (a/a_0)^exponent
    Slot inverse_power(Slot a, int n);                       // a^-n for n >= 1
    Slot integral(Slot u, Slot slope);                       // f(u) - f(u_0) where f'(u) = slope
    Slot at_origin(Slot a);
    Slot value(SeriesName series, Side side);
    Slot slope(SeriesName series, Side side, GeneratorId by); // the partial derivative
    Slot minus(Slot a) { return multiply(number(-1), a); }
    Slot difference(Slot a, Slot b) { return add(a, minus(b)); }

    SeriesName series(Series s);
    SeriesName series(const Polynomial& p) { return series(Series({p})); } // of weight 0
    Slot value(const Polynomial& p) { return value(series(p), Side::itself); }

    [[nodiscard]] const std::vector<Instruction>& steps() const { return steps_; }
    [[nodiscard]] const Series& own(std::size_t index) const { return own_[index]; }
    // By slot: whether one of `results` needs it.
    [[nodiscard]] std::vector<bool> needed(const std::vector<Slot>& results) const;

private:
    using Key = std::tuple<Operation, Slot, Slot, int, int, SeriesName, Side>;
    struct Less {
        bool operator()(const std::pair<Key, Rational>& a, const std::pair<Key, Rational>& b) const {
            return a.first != b.first ? a.first < b.first : a.second < b.second;
        }
    };

    Slot slot_of(Instruction step);
    [[nodiscard]] bool is_number(Slot slot, int value) const;

    std::vector<Instruction> steps_;
    std::map<std::pair<Key, Rational>, Slot, Less> known_;
    std::vector<Series> own_;
};

} // namespace resonform
