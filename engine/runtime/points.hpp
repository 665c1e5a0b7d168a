// SPDX-License-Identifier: MIT
// Many points of an emitted evaluator, one after the other: for every real type.
#ifndef RESONFORM_RUNTIME_POINTS
#define RESONFORM_RUNTIME_POINTS

#include "runtime/report.hpp"
#include "runtime/twice.hpp"

#include <array>
#include <cstddef>

namespace resonform {

// Evaluator: at(t, low, values) -> Status at the exact time t + low; store(values, i, outputs).
struct Points {
    template <class Evaluator, class Real, std::size_t Count>
    static BatchReport batch(const Evaluator& evaluator, const Real* t, std::size_t n,
                             const std::array<Real*, Count>& outputs, Status* status) noexcept {
        const auto time = [t](std::size_t i) { return std::array<Real, 2>{t[i], Real(0)}; };
        return one_by_one(evaluator, time, n, outputs, status);
    }

    template <class Evaluator, class Real, std::size_t Count>
    static BatchReport grid(const Evaluator& evaluator, const Real& t0, const Real& dt, std::size_t n,
                            const std::array<Real*, Count>& outputs, Status* status) noexcept {
        const auto time = [&](std::size_t i) { return exact_time(t0, dt, i); };
        return one_by_one(evaluator, time, n, outputs, status);
    }

private:
    template <class Evaluator, class Time, class Real, std::size_t Count>
    static BatchReport one_by_one(const Evaluator& evaluator, const Time& time, std::size_t n,
                                  const std::array<Real*, Count>& outputs, Status* status) noexcept {
        BatchReport report{Status::ok, 0, n};
        for (std::size_t i = 0; i < n; ++i) {
            typename Evaluator::Values values;
            const auto [t, low] = time(i);
            const Status seen = evaluator.at(t, low, values);
            if (status != nullptr) status[i] = seen;
            note(report, seen, i);
            std::array<Real, Count> numbers;
            Evaluator::list(values, numbers.data());
            for (std::size_t k = 0; k < Count; ++k)
                if (outputs[k] != nullptr) outputs[k][i] = numbers[k];
        }
        return report;
    }

    // t0 + i dt as a rounded number and the rest.
    template <class Real>
    static std::array<Real, 2> exact_time(const Real& t0, const Real& dt, std::size_t i) {
        using Wide = WideNumber<Real>;
        const Real index = Real(static_cast<long>(i));
        if constexpr (std::is_same_v<Wide, Real>) {
            return {t0 + index * dt, Real(0)};
        } else {
            const Wide sum = Wide(t0) + Wide::product(index, dt);
            if (math::finite(sum.high)) return {sum.high, sum.low};
            return {t0 + index * dt, Real(0)}; // what splitting has made NaN may be a number, or infinite
        }
    }
};

} // namespace resonform

#endif
