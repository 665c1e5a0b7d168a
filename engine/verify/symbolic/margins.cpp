// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/margins.hpp"

#include "runtime/layer.hpp"
#include "solve/first_correction.hpp"
#include "solve/slow_law.hpp"

#include <numeric>

namespace resonform {

namespace {

using Numbers = std::vector<Wide>;

// The algebra of margin_of in 50 digits.
struct MarginAlgebra {
    [[nodiscard]] static Wide rational(const Rational& x) {
        return Wide(to_string(cln::numerator(x))) / Wide(to_string(cln::denominator(x)));
    }
    [[nodiscard]] static Wide power(const Wide& x, int n) { return math::power(x, n); }
    [[nodiscard]] static Wide hypot(const Wide& x, const Wide& y) { return WideComplex{x, y}.size(); }
    [[nodiscard]] static Wide add(const Numbers& terms) {
        return std::accumulate(terms.begin(), terms.end(), Wide(0));
    }
    [[nodiscard]] static Wide multiply(const Numbers& factors) {
        Wide product = 1;
        for (const Wide& x : factors) product *= x;
        return product;
    }
};

} // namespace

Wide margin_of(const FirstCorrection& correction, const std::vector<SymbolicSum>& polynomials,
               const SymbolicValues<Wide>& values, const Wide& eps, const std::vector<Wide>& moduli) {
    Numbers sizes;
    for (const SymbolicSum& p : polynomials) sizes.push_back(value_of(p, values).size());
    return margin_of(MarginAlgebra(), correction, eps, moduli, sizes);
}

SymbolicMargins::SymbolicMargins(const SymbolicFrame& frame) : frame_(frame) {
    for (const SymbolicCorrection& added : solution().corrections())
        if (added.is_layer && frame.any_moves(added.needs)) corrections_.push_back(&added);
    for (const SymbolicPrimitive& p : solution().primitives())
        if (!p.logarithm && frame.any_moves(p.argument)) transients_.push_back(&p);
}

bool SymbolicMargins::empty() const {
    return solution().layers().empty() && corrections_.empty() && transients_.empty();
}

std::vector<Wide> SymbolicMargins::at(const SymbolicValues<Wide>& values) const {
    Numbers result;
    for (const SymbolicLayer& layer : solution().layers())
        for (const Wide& margin : layer.margins(values)) result.push_back(margin);
    for (const SymbolicCorrection* added : corrections_) result.push_back(of(*added, values));
    return result;
}

Wide SymbolicMargins::of(const SymbolicCorrection& added, const SymbolicValues<Wide>& values) const {
    return margin_of(added.correction, added.polynomials, values, frame_.small,
                     solution().moduli(values, frame_.small));
}

Numbers SymbolicMargins::of_transients(SymbolicValues<Wide> values, const Wide& T) const {
    for (const SymbolicVariable& v : solution().variables())
        if (v.kind == SymbolicVariable::Kind::quadrature)
            values.set(v.id, T / math::power(frame_.small, v.power) * value_of(v.rate, values).re);
    Numbers result;
    for (const SymbolicPrimitive* p : transients_)
        result.push_back(most_relaxations + value_of(p->argument, values).re);
    return result;
}

Status SymbolicMargins::keep_clear(const SymbolicIntegral& integral, Wide& reach) const {
    SymbolicMoment<Wide> here(frame_);
    const auto margins_at = [&](const Wide& T) {
        integral.move_to(T, here);
        Numbers result = at(here.values);
        for (const Wide& margin : of_transients(here.values, T)) result.push_back(margin);
        return result;
    };
    const int samples = solution().layers().empty() ? broad_layer_samples : layer_samples;
    return clear_of_layers(margins_at, Nameless{}, reach, samples).status;
}

} // namespace resonform
