// SPDX-License-Identifier: MIT
// Quadratures as functions of slow time, tabulated once: value_k(T) = int_0^T f_k(T') dT', 0 <= T <= end,
// to a few ulp of the largest |value_k| in any real type, and of |value_k| itself near T = 0. All f_k share
// panels and look-up.
#ifndef RESONFORM_RUNTIME_TABLE
#define RESONFORM_RUNTIME_TABLE

#include "runtime/panels.hpp"
#include "runtime/pieces.hpp"
#include "runtime/twice.hpp"

namespace resonform {

template <class Real, std::size_t Count> class PrimitiveTable {
public:
    // Tabulates integrand(T) -> std::array<Real, Count>. Status as fit_panels; if that is not ok, `end` is
    // drawn back to where the integrands are defined, 0 if nowhere. The integrand is evaluated in Real, so
    // that the table ends where calls in Real would overflow or lose their digits; only the fit is finer.
    template <class Integrand> Status build(const Integrand& integrand, Real& end) {
        FitTolerance<Fine> tolerance;
        tolerance.resolution = Fine(math::epsilon<Real>());
        tolerance.relative = Fine(16) * tolerance.resolution;
        const auto values = [&](const Fine& T) {
            return math::widened<Fine>(integrand(static_cast<Real>(T)));
        };
        const auto fitted =
            fit_panels<Fine, Count, terms - 1>(in_same_pieces(integrand, values), Fine(end), tolerance);
        std::vector<Real> lefts;
        panels_.clear();
        for (const Panel<Fine, Count, terms - 1>& panel : fitted.panels) {
            const bool first = panels_.empty();
            lefts.push_back(static_cast<Real>(panel.middle - panel.half));
            panels_.push_back({first ? Real(0) : static_cast<Real>(panel.middle),
                               static_cast<Real>(Fine(1) / panel.half),
                               {}});
            for (std::size_t k = 0; k < Count; ++k) {
                auto c = panel.coefficient[k];
                if (first) c = from_zero(c);
                for (std::size_t j = 0; j < terms; ++j)
                    panels_.back().coefficient[j][k] = static_cast<Real>(c[j]);
            }
        }
        end = static_cast<Real>(fitted.end);
        if (!lefts.empty()) index_ = PanelIndex<Real>(std::move(lefts), end);
        return fitted.status;
    }

    // Precondition: build() left an end > 0.
    [[nodiscard]] std::array<Real, Count> operator()(const Real& T) const noexcept {
        const Row& row = panels_[index_.find(T)];
        const Real x = (T - row.middle) * row.per_half;
        std::array<Real, Count> value = row.coefficient[terms - 1];
        for (std::size_t j = terms - 1; j > 0; --j)
            for (std::size_t k = 0; k < Count; ++k) value[k] = value[k] * x + row.coefficient[j - 1][k];
        return value;
    }

    [[nodiscard]] std::size_t panels() const { return panels_.size(); }

private:
    // In types that are not the processor's it would take more time than all the rest.
    using Fine = std::conditional_t<math::digits<Real> <= 64, QuickNumber<Real>, Real>;
    static constexpr std::size_t terms = Panel<Real, Count>::size;
    struct Row {
        Real middle{}, per_half{};
        std::array<std::array<Real, Count>, terms> coefficient{};
    };
    // In the first panel about T = 0, without a constant term: there the integral is small, and so must
    // its error be.
    static std::array<Fine, terms> from_zero(const std::array<Fine, terms>& c) {
        std::array<Fine, terms> result = recentred(c, Fine(-1), terms);
        result[0] = Fine(0);
        return result;
    }

    std::vector<Row> panels_;
    PanelIndex<Real> index_;
};

} // namespace resonform

#endif
