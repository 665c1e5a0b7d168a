// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/map.hpp"

#include "runtime/math.hpp"

#include <algorithm>

namespace resonform {

namespace {

// Conditions in numbers: do they hold?
class WideAlgebra {
public:
    using Real = Wide;
    using Complex = WideComplex;
    WideAlgebra(const Wide& eps, int truncation, bool skips)
        : eps_(eps), truncation_(truncation), skips_(skips) {}

    [[nodiscard]] static Wide number(int n) { return n; }
    [[nodiscard]] Wide little() const { return math::power(eps_, 2 * truncation_); }
    [[nodiscard]] Wide gained(const Wide& x) const { return x / math::power(Wide(4), truncation_ - 1); }
    [[nodiscard]] static Wide rounding(const Wide& x) { return x * Wide(1e-20); }
    [[nodiscard]] static Wide sum(const std::vector<Wide>& terms) {
        Wide total = 0;
        for (const Wide& term : terms) total += term;
        return total;
    }
    [[nodiscard]] static Wide times(int n, const Wide& x) { return n * x; }
    [[nodiscard]] static Wide square(const WideComplex& z) { return z.re * z.re + z.im * z.im; }
    [[nodiscard]] static WideComplex plus(const WideComplex& a, const WideComplex& b) { return a + b; }
    [[nodiscard]] static WideComplex minus(const WideComplex& a, const WideComplex& b) { return a - b; }
    void require(const Wide& positive, const std::string&) {
        if (!(positive > 0) && !(skips_ && isnan(positive))) holds_ = false;
    }
    [[nodiscard]] bool holds() const { return holds_; }

private:
    Wide eps_;
    int truncation_;
    bool skips_, holds_ = true;
};

} // namespace

SymbolicMap::SymbolicMap(const Solution& solution, const SymbolicRing& ring)
    : field_(*solution.normalization->normal_form.field), truncation_(solution.truncation), ring_(ring),
      moved_(moved_variables(solution)), map_(shifts(solution.normalization->map)) {
    for (const MovedVariable& v : moved_) {
        forced_.emplace_back();
        for (const Polynomial& harmonic : v.forced) forced_.back().push_back(ring_.fixed()(harmonic));
    }
}

SymbolicMap::Shifts SymbolicMap::shifts(const NearIdentityMap& map) const {
    const auto whole = [&](const std::vector<Series>& list) {
        return std::vector<int>(list.size(), truncation_);
    };
    Shifts result = shifts(map, {whole(map.mode), whole(map.angle), whole(map.slow)});
    for (const Series& series : map.drift) // written out, because their scale is needed
        result.drift.push_back(ring_.fixed().written_out(series.total(truncation_)));
    return result;
}

SymbolicMap::Shifts SymbolicMap::shifts(const NearIdentityMap& map, const SubstitutionStep& step) const {
    const auto sums = [&](const std::vector<Series>& list, const std::vector<int>& through) {
        std::vector<SymbolicSum> result;
        for (std::size_t k = 0; k < list.size(); ++k)
            result.push_back(ring_.fixed()(list[k].total(through[k])));
        return result;
    };
    return {sums(map.mode, step.mode), sums(map.angle, step.angle), sums(map.slow, step.slow), {}};
}

Wide SymbolicMap::scale_of_mode(std::size_t k, const Wide& eps) const {
    return math::power(eps, field_.ring->generator(field_.modes[k].z).weight);
}

bool SymbolicMap::set(SymbolicValues<Wide>& values, const Wide& eps, const SymbolicStartValues& at) const {
    for (std::size_t k = 0; k < at.modes.size(); ++k) {
        const WideComplex z = scale_of_mode(k, eps) * at.modes[k];
        values.set(field_.modes[k].z, z, z.size());
        values.set(field_.modes[k].zbar, z.conjugate(), z.size());
    }
    for (std::size_t k = 0; k < at.angles.size(); ++k)
        values.set(field_.angles[k].phase, unit(at.angles[k]), 1);
    for (std::size_t k = 0; k < at.slow.size(); ++k) values.set(field_.slow[k].generator, at.slow[k]);
    return ring_.set_roots(values);
}

SymbolicStartValues SymbolicMap::moved(const SymbolicStartValues& from, const Shifts& by,
                                       const SymbolicValues<Wide>& values, const Wide& eps, int sign) const {
    SymbolicStartValues to = from;
    for (std::size_t k = 0; k < to.modes.size(); ++k)
        to.modes[k] = to.modes[k] + (sign / scale_of_mode(k, eps)) * value_of(by.mode[k], values);
    for (std::size_t k = 0; k < to.angles.size(); ++k)
        to.angles[k] += sign * value_of(by.angle[k], values).re;
    for (std::size_t k = 0; k < to.slow.size(); ++k) to.slow[k] += sign * value_of(by.slow[k], values).re;
    return to;
}

const SymbolicSum& SymbolicMap::sum_of(const MovedVariable& v) const {
    switch (v.kind) {
    case MovedVariable::Kind::mode: return map_.mode[v.index];
    case MovedVariable::Kind::slow: return map_.slow[v.index];
    case MovedVariable::Kind::angle: return map_.angle[v.index];
    case MovedVariable::Kind::drift: break;
    }
    return map_.drift[v.index];
}

StartShifts<WideComplex> SymbolicMap::shifts_at(const Pair& pair, const SymbolicInputs& inputs) const {
    StartShifts<WideComplex> at;
    for (const WideComplex& mode : pair.now.modes) at.modes.push_back({{}, mode, {}, {}});
    for (std::size_t k = 0; !pair.from_constants && k < pair.old.modes.size(); ++k)
        at.modes[k].old = pair.old.modes[k];
    for (std::size_t k = 0; k < pair.now.slow.size(); ++k)
        at.slow.push_back({{pair.old.slow[k], 0}, {pair.now.slow[k], 0}, {}, {}});
    for (std::size_t k = 0; k < pair.now.angles.size(); ++k)
        at.angles.push_back({{}, {pair.now.angles[k] - pair.old.angles[k], 0}, {}, {}});
    for (const Pair::Drift& drift : pair.drift) {
        at.drift.push_back({{drift.old, 0}, {drift.now, 0}, {}, {}});
        for (const Wide& term : drift.terms) at.drift.back().terms.push_back({term, 0});
    }
    const Wide eps = ring_.small(inputs);
    SymbolicValues<Wide> values = ring_.constants(inputs);
    set(values, eps, pair.now);
    const auto added = [&](const MovedVariable& v) {
        const WideComplex sum = value_of(sum_of(v), values);
        return v.kind == MovedVariable::Kind::mode ? (1 / scale_of_mode(v.index, eps)) * sum
                                                   : WideComplex{sum.re, 0};
    };
    for (std::size_t k = 0; k < moved_.size(); ++k) {
        const MovedVariable& v = moved_[k];
        if (v.kind == MovedVariable::Kind::drift && at.drift.empty()) continue;
        at.of(v).added = added(v);
        const bool mode = v.kind == MovedVariable::Kind::mode;
        const Wide unit = mode ? 1 / scale_of_mode(v.index, eps) : Wide(1);
        for (const SymbolicSum& harmonic : forced_[k])
            at.of(v).forced.push_back(unit * value_of(harmonic, values));
    }
    if (!pair.from_constants) return at;
    SymbolicStartValues old = pair.old;
    old.modes.clear();
    for (const StartShift<WideComplex>& mode : at.modes) old.modes.push_back(mode.now + mode.added);
    set(values, eps, old);
    for (const MovedVariable& v : moved_)
        if (v.kind == MovedVariable::Kind::mode) at.of(v).added_to_old = added(v);
    return at;
}

bool SymbolicMap::leads_back(const Pair& pair, const SymbolicInputs& inputs) const {
    std::vector<MovedVariable> checked = moved_;
    std::erase_if(checked, [&](const MovedVariable& v) {
        return v.kind == MovedVariable::Kind::drift && (pair.drift.empty() || !pair.drift[v.index].checked);
    });
    WideAlgebra algebra(ring_.small(inputs), truncation_, !inputs.untaken.empty());
    StartShifts<WideComplex> at = shifts_at(pair, inputs);
    NearIdentity(algebra).require(checked, at, pair.from_constants);
    return algebra.holds();
}

bool SymbolicMap::is_close_to_one(const Wide& factor, const SymbolicInputs& inputs) {
    WideAlgebra algebra(inputs.eps, 0, !inputs.untaken.empty());
    NearIdentity(algebra).require_close_to_one({factor - 1, 0}, "");
    return algebra.holds();
}

} // namespace resonform
