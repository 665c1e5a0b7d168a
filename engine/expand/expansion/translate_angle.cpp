// SPDX-License-Identifier: GPL-3.0-or-later
// Angles in expressions: harmonics only, sin and cos of integer combinations.
#include "algebra/number/error.hpp"
#include "expand/expansion/translate.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

using GiNaC::ex;
using GiNaC::ex_to;
using Node = SeriesProgram::Node;

namespace {

constexpr int highest_harmonic = 1000;

[[noreturn]] void refuse_angle(const ex& e, const Place& place) {
    refuse({"an angle occurs in sin and cos of integer combinations of angles, with harmonics up to 1000",
            spell(e), "write the dependence as a trigonometric polynomial", place});
}

// k of an argument k phi + rest.
int harmonic_of(const ex& argument, const ex& angle, const ex& e, const Place& place) {
    const ex k = argument.diff(ex_to<GiNaC::symbol>(angle)).normal();
    if (!k.info(GiNaC::info_flags::integer) || GiNaC::abs(ex_to<GiNaC::numeric>(k)) > highest_harmonic)
        refuse_angle(e, place);
    return ex_to<GiNaC::numeric>(k).to_int();
}

} // namespace

// e^{i phi} = e^{i theta} e^{i m}
void Translator::bind_angle(const ex& symbol, GeneratorId phase, Node shift) {
    const Ring& ring = *coefficients_.ring();
    const Node turn = program_.product(program_.constant(ring.imaginary()), shift);
    const Node back = program_.sum({{-1, turn}});
    angles_.push_back({symbol,
                       program_.product(program_.constant(ring.gen(phase)), program_.exponential(turn)),
                       program_.product(program_.constant(ring.gen(phase, -1)), program_.exponential(back))});
}

bool Translator::holds_angle(const ex& e) const {
    return std::any_of(angles_.begin(), angles_.end(), [&](const Angle& a) { return e.has(a.symbol); });
}

// With P = e^{i sum k phi} = C + i S:  cos(sum k phi + u) = C cos u - S sin u, and likewise the sine.
Node Translator::of_angles(const ex& e, const Place& place) {
    const std::optional<Function> f = function_of(e);
    if (f != Function::sine && f != Function::cosine) refuse_angle(e, place);
    ex rest = e.op(0);
    const Node one = program_.constant(coefficients_.ring()->one());
    Node forward = one, backward = one;
    for (const Angle& angle : angles_) {
        const int k = harmonic_of(e.op(0), angle.symbol, e, place);
        if (k == 0) continue;
        rest -= k * angle.symbol;
        forward =
            program_.product(forward, program_.power(k > 0 ? angle.forward : angle.backward, std::abs(k)));
        backward =
            program_.product(backward, program_.power(k > 0 ? angle.backward : angle.forward, std::abs(k)));
    }
    rest = rest.expand();
    if (holds_angle(rest)) refuse_angle(e, place);
    const Rational half = Rational(1) / 2;
    const Node minus_i = program_.constant(-coefficients_.ring()->imaginary());
    const Node cosine = program_.sum({{half, forward}, {half, backward}});
    const Node sine = program_.product(minus_i, program_.sum({{half, forward}, {-half, backward}}));
    if (rest.is_zero()) return f == Function::cosine ? cosine : sine;
    const Node c = (*this)(GiNaC::cos(rest), place), s = (*this)(GiNaC::sin(rest), place);
    if (f == Function::cosine)
        return program_.sum({{1, program_.product(cosine, c)}, {-1, program_.product(sine, s)}});
    return program_.sum({{1, program_.product(sine, c)}, {1, program_.product(cosine, s)}});
}

} // namespace resonform
