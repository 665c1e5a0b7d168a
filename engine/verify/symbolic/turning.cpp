// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/turning.hpp"

#include <cmath>

namespace resonform {

namespace {

constexpr int most_halvings = 16;

} // namespace

Wide turned(const SymbolicFrame& frame, const SymbolicIntegral& integral, std::size_t k, const Wide& T) {
    SymbolicMoment<Wide> at(frame);
    const auto value = [&](const Wide& time) {
        integral.move_to(time, at);
        return at.now[k];
    };
    const auto angle = [](const WideComplex& from, const WideComplex& to) {
        const WideComplex ratio = to * from.conjugate();
        return std::atan2(static_cast<double>(Wide(ratio.im / (ratio.size() + Wide(1e-300)))),
                          static_cast<double>(Wide(ratio.re / (ratio.size() + Wide(1e-300)))));
    };
    double total = 0;
    const auto add = [&](const auto& again, const Wide& left, const WideComplex& from, const Wide& right,
                         const WideComplex& to, int depth) -> void {
        const Wide middle = (left + right) / 2;
        const WideComplex between = value(middle);
        const double first = angle(from, between), second = angle(between, to);
        if (depth == 0 || (depth < most_halvings - 3 && std::abs(first) < 1 && std::abs(second) < 1)) {
            total += first + second;
            return;
        }
        again(again, left, from, middle, between, depth - 1);
        again(again, middle, between, right, to, depth - 1);
    };
    add(add, Wide(0), frame.variables[k].start, T, value(T), most_halvings);
    return abs(Wide(total));
}

} // namespace resonform
