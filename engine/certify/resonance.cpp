// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/resonance.hpp"

#include "model/text/enclosure.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

std::ptrdiff_t nonzero(const std::vector<int>& multiples) {
    return std::count_if(multiples.begin(), multiples.end(), [](int m) { return m != 0; });
}

Residue combined(const PrimeField& f, const std::vector<int>& multiples, const std::vector<Residue>& of) {
    Residue sum = 0;
    for (std::size_t k = 0; k < multiples.size(); ++k)
        if (multiples[k] != 0 && of[k] != 0) sum = f.add(sum, f.multiply(f.from(multiples[k]), of[k]));
    return sum;
}

} // namespace

FrequencySample frequencies_of(const CertificatePlan& plan, const PointRun& run, std::size_t n,
                               const Point& point) {
    return {point.field, run.at_origin(plan.growth, n), run.at_origin(plan.omega, n),
            run.at_origin(plan.angle, n), point.values};
}

auto Resonance::multiples_of(const std::vector<int>& exponents, int mode) const -> const Multiples& {
    const auto exponent = [&](GeneratorId id) { return exponents[static_cast<std::size_t>(id)]; };
    Multiples& m = multiples_;
    for (std::vector<int>* list : {&m.growth, &m.omega, &m.angle}) list->clear();
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        const Mode& z = field_.modes[k];
        const int alpha = exponent(z.z) - (static_cast<int>(k) == mode ? 1 : 0);
        m.growth.push_back(z.is_real() ? alpha : alpha + exponent(z.zbar));
        m.omega.push_back(z.is_real() ? 0 : alpha - exponent(z.zbar));
    }
    for (const AngleVariable& a : field_.angles) m.angle.push_back(exponent(a.phase));
    return m;
}

bool Resonance::is_exact(const std::vector<int>& exponents, int mode) const {
    const Multiples& m = multiples_of(exponents, mode);
    if (nonzero(m.angle) == 0 && nonzero(m.omega) == 1) return false; // omega of an oscillator is a unit
    return std::all_of(samples_.begin(), samples_.end(), [&](const FrequencySample& sample) {
        const PrimeField& f = sample.field;
        const Residue frequency =
            f.add(combined(f, m.omega, sample.omega), combined(f, m.angle, sample.angle));
        return frequency == 0 && combined(f, m.growth, sample.growth) == 0;
    });
}

bool Resonance::is_near(const std::vector<int>& exponents, int mode) const {
    if (cln::zerop(field_.system().near)) return false;
    const Multiples& m = multiples_of(exponents, mode);
    GiNaC::ex real = 0, imaginary = 0;
    for (std::size_t k = 0; k < m.omega.size(); ++k) {
        real += m.growth[k] * field_.basis.modes[k].eigenvalue.re;
        imaginary += m.omega[k] * field_.basis.modes[k].eigenvalue.im;
    }
    for (std::size_t k = 0; k < m.angle.size(); ++k) imaginary += m.angle[k] * field_.angles[k].law;
    constexpr std::int64_t bits = 512;
    const Rational limit = field_.system().near * field_.system().near;
    const std::optional<RealBall> square = enclose(real * real + imaginary * imaginary, {}, bits);
    return square && arb_gt(square->get(), RealBall(limit, bits).get()) == 0;
}

} // namespace resonform
