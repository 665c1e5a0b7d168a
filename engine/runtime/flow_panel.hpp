// SPDX-License-Identifier: MIT
// A slow flow at the Gauss nodes of a panel: the fixed point of y = y(left) + int f(T, y) dT, as in
// runtime/flow.hpp. Real may be several numbers side by side (runtime/pack.hpp).
#ifndef RESONFORM_RUNTIME_FLOW_PANEL
#define RESONFORM_RUNTIME_FLOW_PANEL

#include "runtime/gauss.hpp"
#include "runtime/lanes.hpp"
#include "runtime/math.hpp"
#include "runtime/status.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace resonform {

// count: of its variables, the first of Columns.
template <class Real, std::size_t n, std::size_t count, class Columns> struct FlowPanel {
    using Lanes = LanesOf<Real>;

    const GaussFor<Real, n>& gauss;
    const Real half; // width of the panel
    const Columns& start;
    std::array<Columns, n>& at_node;              // is set
    std::array<std::array<Real, n>, count>& rate; // is set
    typename Lanes::Truth converged = Lanes::negated(Lanes::all());

    // rates(j) -> std::array<Real, count>, with at_node[j]. outside_domain: it does not contract, as none of
    // several does. Each stays as it is once it has converged, so that it does not depend on the others.
    template <class Rates> Status contract(const Rates& rates) {
        constexpr int most_iterations = 100;
        for (Columns& columns : at_node) std::copy_n(start.begin(), count, columns.begin());
        Real change = Real(-1);
        auto open = Lanes::all();
        for (int i = 0; i < most_iterations && Lanes::any(open); ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                const std::array<Real, count> value = rates(j);
                for (std::size_t k = 0; k < count; ++k)
                    rate[k][j] = Lanes::chosen(open, value[k], rate[k][j]);
            }
            const Real before = std::exchange(change, Real(0));
            for (std::size_t k = 0; k < count; ++k)
                if (const Status status = step(k, open, change); status != Status::ok) return status;
            // Either nothing changes any more, or only the last digits do.
            const auto stalls = (Real(0) < before) & Lanes::negated(change < before);
            const auto ends = Lanes::negated(Real(2) < change) | (stalls & Lanes::negated(Real(64) < change));
            converged = converged | (open & ends);
            open = open & Lanes::negated(ends);
            if (i > 12) open = open & Lanes::negated(stalls);
        }
        return Lanes::any(converged) ? Status::ok : Status::outside_domain;
    }

private:
    // The largest change of a variable, in ulp.
    Status step(std::size_t k, const typename Lanes::Truth& open, Real& change) {
        Real moved = Real(0), size = math::magnitude(start[k]);
        const std::array<Real, n> integral = gauss.integrals(rate[k]);
        for (std::size_t j = 0; j < n; ++j) {
            if constexpr (!Lanes::several)
                if (!math::finite(integral[j])) return fault<Real>(rate[k]);
            const Real next = start[k] + half * integral[j];
            size = math::larger(size, Real(math::magnitude(next)));
            moved = math::larger(moved, Real(math::magnitude(Real(next - at_node[j][k]))));
            at_node[j][k] = Lanes::chosen(open, next, at_node[j][k]);
        }
        change = math::larger(change, Real(moved / (size * math::epsilon<Real>()))); // 0/0 is passed over
        return Status::ok;
    }
};

} // namespace resonform

#endif
