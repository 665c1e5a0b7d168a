// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/signs/atoms.hpp"

#include "algebra/number/number.hpp"
#include "algebra/number/real_ball.hpp"
#include "algebra/ring/integer_polynomial.hpp"
#include "model/text/canonical.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/function_call.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

constexpr int most_multiples = 16; // of an angle, or in an exponential: degree of the polynomials

bool is_exponential(std::optional<Function> f) {
    return f == Function::exponential || f == Function::hyperbolic_sine || f == Function::hyperbolic_cosine ||
           f == Function::hyperbolic_tangent;
}
bool is_circular(std::optional<Function> f) {
    return f == Function::sine || f == Function::cosine || f == Function::tangent;
}

bool is_arithmetic(const ex& e) {
    return is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e) ||
           (is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::integer));
}

bool is_opaque(const ex& e) {
    return is_a<GiNaC::symbol>(e) || is_a<GiNaC::function>(e) || is_a<GiNaC::constant>(e);
}

bool is_even_power(const ex& e) { return is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::even); }

std::vector<ex> addends(const ex& e) {
    const ex sum = e.expand();
    return is_a<GiNaC::add>(sum) ? operands(sum) : std::vector<ex>{sum};
}

// Bounds low < e < high that hold for e alone: of a function by its row, of a constant by its ball.
std::optional<std::pair<numeric, numeric>> range_of(const ex& e) {
    const std::optional<Function> f = is_constant(e) ? std::nullopt : function_of(e);
    if (f && !row_of(*f).low.empty() && !row_of(*f).high.empty()) {
        const auto bound = [](std::string_view text) { return numeric(cln::cl_N(parse_rational(text))); };
        return std::pair(bound(row_of(*f).low), bound(row_of(*f).high));
    }
    constexpr int digits = 6, bits = 24;
    const auto ball = is_constant(e) ? enclose(e) : std::nullopt;
    if (!ball || ball->sign() == 0 || accurate_bits(*ball) < bits) return std::nullopt;
    const numeric near(cln::cl_N(rounded(*ball, digits))), margin = GiNaC::abs(near) / 100000;
    return std::pair(near - margin, near + margin);
}

} // namespace

bool Atoms::collect(const ex& e, const SignsOf& signs) {
    if (is_a<numeric>(e)) return e.info(GiNaC::info_flags::rational);
    if (is_arithmetic(e)) {
        const std::vector<ex> parts = is_a<GiNaC::power>(e) ? std::vector{e.op(0)} : operands(e);
        return std::all_of(parts.begin(), parts.end(), [&](const ex& part) { return collect(part, signs); });
    }
    const std::optional<Function> f = function_of(e);
    if (!is_constant(e) && (is_exponential(f) || is_circular(f))) {
        collect_terms(is_circular(f) ? Kind::angle : Kind::exponential, e.op(0));
        return true;
    }
    if (!is_a<GiNaC::power>(e)) {
        Atom& atom = atoms_[find(Kind::value, e).atom];
        atom.signs = atom.signs & signs(e);
        return true;
    }
    const ex& base = e.op(0);
    if (!e.op(1).info(GiNaC::info_flags::rational)) return false;
    if (const SignSet inner = is_even_power(base) ? signs(base.op(0)) : SignSet::all(); inner.is_known()) {
        const ex root = GiNaC::pow(inner.positive ? base.op(0) : -base.op(0), base.op(1) * e.op(1));
        known_roots_[e] = root;
        return collect(root, signs);
    }
    if (!collect(base, signs)) return false;
    Atom& atom = atoms_[find(Kind::value, base).atom];
    atom.signs = atom.signs & signs(base);
    refine(atom, ex_to<numeric>(e.op(1)).denom());
    return true;
}

// How often the index can be halved.
std::size_t Atoms::halvings(const Atom& atom) {
    std::size_t count = 0;
    for (numeric left = atom.index; left.is_even() && !is_opaque(atom.key); left /= 2) ++count;
    return count;
}

void Atoms::refine(Atom& atom, const numeric& index) {
    atom.index = GiNaC::lcm(atom.index, index);
    if (atom.kind != Kind::value) return;
    const std::size_t halved = halvings(atom);
    const bool odd_root = atom.index != GiNaC::pow(numeric(2), numeric(static_cast<long>(halved)));
    while (atom.t.size() < halved + (odd_root ? 1 : 0)) atom.t.emplace_back("t");
}

Atoms::Multiple Atoms::find(Kind kind, const ex& key) {
    if (const auto known = multiple(kind, key)) return *known;
    atoms_.push_back({kind, key, 1, SignSet::all(), {GiNaC::symbol("t")}});
    return {atoms_.size() - 1, 1};
}

// The key as a multiple of that of a known atom: exp(u/2) by exp(u/3), ratio 3/2.
std::optional<Atoms::Multiple> Atoms::multiple(Kind kind, const ex& key) const {
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
        if (atoms_[k].kind != kind) continue;
        if (atoms_[k].key.is_equal(key)) return Multiple{k, 1};
        const ex ratio = kind == Kind::value ? ex(0) : (key / atoms_[k].key).normal();
        if (!ratio.is_zero() && ratio.info(GiNaC::info_flags::rational))
            return Multiple{k, ex_to<numeric>(ratio)};
    }
    return std::nullopt;
}

void Atoms::collect_terms(Kind kind, const ex& argument) {
    for (const ex& term : addends(argument)) {
        const auto [atom, ratio] = find(kind, term);
        refine(atoms_[atom], ratio.denom());
    }
}

ex Atoms::rational(const ex& e) const {
    if (is_a<numeric>(e)) return e;
    if (is_arithmetic(e) && is_a<GiNaC::power>(e)) return GiNaC::pow(rational(e.op(0)), e.op(1));
    if (is_arithmetic(e)) {
        GiNaC::exvector parts;
        for (const ex& part : e) parts.push_back(rational(part));
        return is_a<GiNaC::add>(e) ? ex(GiNaC::add(parts)) : ex(GiNaC::mul(parts));
    }
    if (const auto known = known_roots_.find(e); known != known_roots_.end()) return rational(known->second);
    const std::optional<Function> f = function_of(e);
    if (!is_constant(e) && is_circular(f)) {
        const Unit unit = angle(e.op(0));
        return f == Function::sine     ? unit.sine
               : f == Function::cosine ? unit.cosine
                                       : unit.sine / unit.cosine;
    }
    if (!is_constant(e) && is_exponential(f)) {
        const ex up = exponential(e.op(0)), down = 1 / up;
        if (f == Function::hyperbolic_tangent) return (up - down) / (up + down);
        return f == Function::exponential ? up : (f == Function::hyperbolic_sine ? up - down : up + down) / 2;
    }
    const bool root = is_a<GiNaC::power>(e);
    const Atom& atom = atoms_[multiple(Kind::value, root ? e.op(0) : e)->atom];
    return GiNaC::pow(atom.t.front(), (root ? e.op(1) : ex(1)) * atom.index);
}

// The factor of a term, and how many times the key of its atom it is, in units of the index.
std::pair<const Atoms::Atom&, int> Atoms::times(Kind kind, const ex& term) const {
    const auto [atom, ratio] = *multiple(kind, term);
    const numeric n = ratio * atoms_[atom].index;
    if (GiNaC::abs(n) > most_multiples) throw NoQuotient{};
    return {atoms_[atom], n.to_int()};
}

ex Atoms::exponential(const ex& argument) const {
    ex product = 1;
    for (const ex& term : addends(argument)) {
        const auto [atom, n] = times(Kind::exponential, term);
        product *= GiNaC::pow(atom.t.front(), n);
    }
    return product;
}

Atoms::Unit Atoms::angle(const ex& argument) const {
    Unit total{1, 0};
    for (const ex& term : addends(argument)) {
        const auto [atom, n] = times(Kind::angle, term);
        const ex t = n < 0 ? -atom.t.front() : ex(atom.t.front()), square = 1 + t * t;
        const Unit once = atom.at_pi ? Unit{-1, 0} : Unit{(1 - t * t) / square, 2 * t / square};
        for (int k = 0; k < std::abs(n); ++k)
            total = {total.cosine * once.cosine - total.sine * once.sine,
                     total.sine * once.cosine + total.cosine * once.sine};
    }
    return total;
}

std::vector<GiNaC::symbol> Atoms::symbols() const {
    std::vector<GiNaC::symbol> all;
    for (const Atom& a : atoms_) all.insert(all.end(), a.t.begin(), a.t.end());
    return all;
}

std::vector<Atoms::Root> Atoms::roots() const {
    std::vector<Root> all;
    for (const Atom& a : atoms_)
        for (std::size_t k = a.kind == Kind::value ? halvings(a) : 0; k-- > 0;)
            all.push_back({a.t[k], k + 1 < a.t.size() ? ex(a.t[k + 1]) : rational(a.key)});
    return all;
}

std::vector<ex> Atoms::positive() const {
    std::vector<ex> all;
    for (const Atom& a : atoms_) {
        const ex t = a.t.front();
        if (a.kind == Kind::exponential || a.signs.is_positive())
            all.insert(all.end(), a.t.begin(), a.t.end());
        if (a.signs == SignSet::of(-1) && a.index == 1) all.push_back(-t);
        if (!a.signs.zero) all.push_back(t * t);
        if (a.kind != Kind::value) continue;
        if (const auto range = range_of(a.index == 1 ? a.key : GiNaC::pow(a.key, 1 / a.index))) {
            all.push_back(t - range->first);
            all.push_back(range->second - t);
        }
    }
    return all;
}

std::size_t Atoms::angles() const {
    return static_cast<std::size_t>(
        std::count_if(atoms_.begin(), atoms_.end(), [](const Atom& a) { return a.kind == Kind::angle; }));
}

void Atoms::set_odd_multiples_of_pi(std::size_t set) {
    for (Atom& a : atoms_) {
        if (a.kind != Kind::angle) continue;
        a.at_pi = set % 2 != 0;
        set /= 2;
    }
}

} // namespace resonform
