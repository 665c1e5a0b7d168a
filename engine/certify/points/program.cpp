// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/points/program.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

Slot CertificateProgram::slot_of(Instruction step) {
    const Key key{step.operation, step.left, step.right, step.index, step.power, step.series, step.side};
    const auto [found, is_new] =
        known_.emplace(std::pair{key, step.number}, static_cast<Slot>(steps_.size()));
    if (is_new) steps_.push_back(std::move(step));
    return found->second;
}

bool CertificateProgram::is_number(Slot slot, int value) const {
    const Instruction& step = steps_[static_cast<std::size_t>(slot)];
    return step.operation == Operation::number && step.number == value;
}

Slot CertificateProgram::number(const Rational& value) {
    Instruction step{Operation::number};
    step.number = value;
    return slot_of(step);
}

Slot CertificateProgram::generator(GeneratorId id, int power) {
    Instruction step{Operation::generator};
    step.index = id;
    step.power = power;
    return slot_of(step);
}

Slot CertificateProgram::add(Slot a, Slot b) {
    if (is_number(a, 0)) return b;
    return is_number(b, 0) ? a : slot_of({Operation::add, std::min(a, b), std::max(a, b)});
}

Slot CertificateProgram::multiply(Slot a, Slot b) {
    if (is_number(a, 1) || is_number(b, 0)) return b;
    if (is_number(b, 1) || is_number(a, 0)) return a;
    return slot_of({Operation::multiply, std::min(a, b), std::max(a, b)});
}

Slot CertificateProgram::function(Function function, Slot a) {
    return slot_of({Operation::function, a, -1, static_cast<int>(function)});
}

Slot CertificateProgram::power(Slot a, const Rational& exponent, Slot lead) {
    Instruction step{Operation::power, a, lead};
    step.number = exponent;
    return slot_of(step);
}

Slot CertificateProgram::inverse_power(Slot a, int n) {
    return slot_of({Operation::inverse_power, a, -1, n});
}

Slot CertificateProgram::integral(Slot u, Slot slope) { return slot_of({Operation::integral, u, slope}); }

Slot CertificateProgram::at_origin(Slot a) {
    const Operation known = steps_[static_cast<std::size_t>(a)].operation;
    return known == Operation::number || known == Operation::at_origin ? a
                                                                       : slot_of({Operation::at_origin, a});
}

Slot CertificateProgram::value(SeriesName series, Side side) {
    return slot_of({Operation::value, -1, -1, 0, 0, series, side});
}

Slot CertificateProgram::slope(SeriesName series, Side side, GeneratorId by) {
    return slot_of({Operation::slope, -1, -1, by, 0, series, side});
}

SeriesName CertificateProgram::series(Series s) {
    const auto known = std::find(own_.begin(), own_.end(), s);
    const auto index = static_cast<std::size_t>(known - own_.begin());
    if (known == own_.end()) own_.push_back(std::move(s));
    return {SeriesName::own, index};
}

std::vector<bool> CertificateProgram::needed(const std::vector<Slot>& results) const {
    std::vector<bool> needed(steps_.size(), false);
    for (const Slot slot : results) needed[static_cast<std::size_t>(slot)] = true;
    for (std::size_t k = steps_.size(); k-- > 0;) {
        if (!needed[k]) continue;
        for (const Slot operand : {steps_[k].left, steps_[k].right})
            if (operand >= 0) needed[static_cast<std::size_t>(operand)] = true;
    }
    return needed;
}

} // namespace resonform
