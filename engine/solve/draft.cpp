// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/draft.hpp"

#include "algebra/ring/cancellation.hpp"
#include "algebra/ring/constant.hpp"
#include "algebra/ring/ring_copy.hpp"
#include "solve/quadrature.hpp"
#include "solve/route.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

Generator make(GeneratorKind kind, std::string name, bool invertible = false) {
    Generator g;
    g.kind = kind;
    g.name = std::move(name);
    g.invertible = invertible;
    return g;
}

// The positive slow variable as rho^index.
Generator root_of(const RingBuilder& builder, GeneratorId x, int index, std::string name) {
    Generator g = make(GeneratorKind::root, std::move(name), true);
    g.positive = true;
    g.index = index;
    g.radicand = builder.gen(x);
    return g;
}

// The sign and the powers of constants that all terms share: -r for -r (v^2/g ... + C^2/4 ...).
Polynomial shared_factor(const Ring& ring, const Polynomial& p) {
    Monomial factor;
    for (GeneratorId id = Ring::imaginary_unit + 1; id < ring.size(); ++id) {
        const GeneratorKind kind = ring.generator(id).kind;
        if (kind != GeneratorKind::parameter && kind != GeneratorKind::constant) continue;
        int least = ring.exponent(p.terms().front().monomial, id);
        for (const Term& t : p.terms()) least = std::min(least, ring.exponent(t.monomial, id));
        if (least > 0) factor = factor + ring.monomial(id, least);
    }
    const auto negative =
        std::count_if(p.terms().begin(), p.terms().end(), [](const Term& t) { return t.coefficient < 0; });
    return {factor, 2 * static_cast<std::size_t>(negative) > p.size() ? Rational(-1) : Rational(1)};
}

} // namespace

Draft::Draft(std::shared_ptr<const Normalization> normalization, const SolveOptions& options,
             const std::vector<Refinement>& refinements) {
    solution.normalization = std::move(normalization);
    solution.order = options.order;
    solution.truncation = options.truncation;
    const GradedField& field = *normal_form().field;
    const std::size_t refined = refinements.size(),
                      constants = 1 + 2 * field.modes.size() + field.drift.size();
    RingBuilder builder(field.ring->size() + static_cast<int>(refined + constants));
    copy_generators(builder, refinements);
    add_constants(builder);
    solution.ring = builder.freeze();
    rebuild_lift();
    set_clock();
}

void Draft::copy_generators(RingBuilder& builder, const std::vector<Refinement>& refinements) {
    const Ring& old = *normal_form().field->ring;
    RingCopy copy(old, builder);
    for (GeneratorId id = Ring::imaginary_unit + 1; id < old.size(); ++id) {
        const Generator& g = old.generator(id);
        if (g.kind == GeneratorKind::fast) continue;
        const auto refinement = std::find_if(refinements.begin(), refinements.end(),
                                             [&](const Refinement& r) { return r.base == id; });
        if (refinement == refinements.end()) {
            copy.copy(id);
            continue;
        }
        const int factor = refinement->factor;
        const std::string name =
            factor == 1 ? g.name : fresh_name(builder, fmt::format("{}_{}", g.name, factor));
        if (g.kind == GeneratorKind::root) {
            copy.copy_refined(id, factor, name);
        } else {
            copy.copy(id);
            if (factor > 1) builder.add(root_of(builder, builder.id(g.name), factor, name));
        }
        refined_.push_back({id, name, factor});
    }
}

void Draft::add_constants(RingBuilder& builder) {
    const GradedField& field = *normal_form().field;
    const System& system = field.system();
    const auto add = [&](GeneratorKind kind, const std::string& name, bool invertible = false) {
        return builder.add(make(kind, fresh_name(builder, name), invertible));
    };
    solution.eps = builder.id(field.ring->generator(field.eps).name);
    if (std::all_of(field.slow.begin(), field.slow.end(),
                    [&](const SlowVariable& slow) { return explicit_law(field, slow)->relaxes(); }))
        solution.slow_time = add(GeneratorKind::slow, "T");
    for (const Mode& mode : field.modes) {
        const std::string& variable = system.variables[mode.variable].name;
        ModeSolution m;
        m.variable = mode.variable;
        m.amplitude_name = system.constant_name("amplitude", variable);
        m.phase_name = system.constant_name("phase", variable);
        m.amplitude = add(GeneratorKind::constant, m.amplitude_name);
        solution.modes.push_back(std::move(m));
    }
    for (const DriftVariable& drift : field.drift) {
        DriftSolution d;
        d.variable = drift.variable;
        d.constant_name = system.constant_name("constant", drift.name);
        d.constant = add(GeneratorKind::constant, d.constant_name);
        solution.drift.push_back(std::move(d));
    }
    for (ModeSolution& mode : solution.modes) mode.phase = add(GeneratorKind::phase, "phase", true);
}

void Draft::set_clock() {
    const GradedField& field = *normal_form().field;
    if (field.slow.empty()) {
        clock_ = *solution.slow_time;
        clock_rate_ = ring().one();
        return;
    }
    const SlowVariable& slow = field.slow.front();
    const SlowPath path = *explicit_law(field, slow);
    clock_ = *ring().find(slow.name);
    clock_rate_ = *quotient_in_ring(ring(), lift(slow.rate), ring().gen(solution.eps));
    solution.slow.push_back({slow.variable, clock_, clock_rate_, {lift(path.drive), lift(path.decline)}});
}

Polynomial Draft::power_of(GeneratorId base, const Rational& exponent) const {
    const auto found =
        std::find_if(refined_.begin(), refined_.end(), [&](const RefinedRoot& r) { return r.base == base; });
    const Rational power = exponent * found->factor;
    return ring().gen(*ring().find(found->name), cln::cl_I_to_int(cln::numerator(power)));
}

void Draft::rebuild_lift() {
    const RingPtr& old = normal_form().field->ring;
    std::vector<std::pair<GeneratorId, Polynomial>> images;
    for (const RefinedRoot& r : refined_)
        if (old->generator(r.base).kind == GeneratorKind::root)
            images.emplace_back(r.base, ring().gen(*ring().find(r.name), r.factor));
    for (const Mode& mode :
         normal_form().field->modes) { // never met: lift() is for polynomials without modes
        images.emplace_back(mode.z, Polynomial());
        images.emplace_back(mode.zbar, Polynomial());
    }
    solution.from_normal_form =
        std::make_shared<const RingMap>(RingMap::by_name(old, solution.ring, std::move(images)));
}

void Draft::rewrite(const RingMap& map) {
    const auto rewrite_series = [&](Series& s) {
        for (int n = 0; n <= s.through(); ++n) s.set(n, map(s.part(n)));
    };
    for (SlowLaw& slow : solution.slow)
        slow = {
            slow.variable, slow.generator, map(slow.rate), {map(slow.path.drive), map(slow.path.decline)}};
    for (ModeSolution& mode : solution.modes) {
        mode.envelope = map(mode.envelope);
        rewrite_series(mode.factor);
        rewrite_series(mode.phase_rate);
    }
    for (DriftSolution& drift : solution.drift) rewrite_series(drift.value);
    for (Primitive& primitive : solution.primitives) primitive.argument = map(primitive.argument);
    clock_rate_ = map(clock_rate_);
}

GeneratorId Draft::extend(Generator g, bool exponential) {
    const RingPtr before = solution.ring;
    RingBuilder builder(before->size() + 1);
    RingCopy(*before, builder).copy_all();
    g.name = fresh_name(builder, std::move(g.name));
    const Polynomial self = builder.gen(builder.next());
    for (auto& [variable, derivative] : g.derivatives) {
        derivative = builder.import(*before, derivative);
        if (exponential) derivative = builder.multiply(derivative, self);
    }
    const GeneratorId id = builder.add(std::move(g));
    solution.ring = builder.freeze();
    rewrite(RingMap::by_name(before, solution.ring));
    rebuild_lift();
    return id;
}

Polynomial Draft::integrate(const Polynomial& rate, const std::string& name) {
    if (rate.empty()) return {};
    const bool relaxes = !is_constant(ring(), clock_rate_);
    if (relaxes && is_constant(ring(), rate)) return ring().multiply(rate, ring().gen(*solution.slow_time));
    auto integrand = relaxes ? rate : quotient_in_ring(ring(), rate, clock_rate_);
    if (integrand) integrand = cancelled(ring(), *integrand);
    if (!integrand || uses_slow_time(*integrand)) return quadrature(rate, name, true);
    const auto closed = close_primitive(ring(), clock_, *integrand, relaxes ? clock_rate_ : ring().one());
    if (!closed) return quadrature(*integrand, name, relaxes || solution.slow.empty());

    const RingPtr before = solution.ring;
    std::vector<GeneratorId> ids;
    for (const auto& [coefficient, log] : closed->logarithmic) {
        const RingMap now = RingMap::by_name(before, solution.ring);
        ids.push_back(logarithm(now(log.argument), now(log.derivative)));
    }
    const RingMap now = RingMap::by_name(before, solution.ring);
    Polynomial result = now(closed->algebraic);
    for (std::size_t k = 0; k < ids.size(); ++k)
        result = result + ring().multiply(now(closed->logarithmic[k].first), ring().gen(ids[k]));
    return result;
}

bool Draft::uses_slow_time(const Polynomial& p) const {
    if (solution.slow.empty()) return false; // T is the clock
    const auto holds = [&](GeneratorId id) {
        return std::any_of(p.terms().begin(), p.terms().end(),
                           [&](const Term& t) { return ring().exponent(t.monomial, id) != 0; });
    };
    return (solution.slow_time && holds(*solution.slow_time)) ||
           std::any_of(
               solution.primitives.begin(), solution.primitives.end(),
               [&](const Primitive& primitive) { return primitive.over_slow_time && holds(primitive.id); });
}

Polynomial Draft::quadrature(const Polynomial& integrand, const std::string& name, bool over_slow_time) {
    const Polynomial factor = shared_factor(ring(), integrand);
    const Polynomial argument = *quotient_in_ring(ring(), integrand, factor);
    Generator g = make(GeneratorKind::primitive, name);
    // Over slow time with a slow variable present, the rate of the latter does not divide out, and
    // d/d(slow) is no element of the ring: it is left out, and nothing differentiates it.
    if (!over_slow_time || solution.slow.empty()) g.derivatives.emplace_back(clock_, argument);
    const RingPtr before = solution.ring;
    const GeneratorId id = extend(std::move(g));
    const RingMap now = RingMap::by_name(before, solution.ring);
    solution.primitives.push_back(
        {id, ring().generator(id).name, PrimitiveKind::quadrature, now(argument), over_slow_time});
    return ring().multiply(now(factor), ring().gen(id));
}

GeneratorId Draft::logarithm(const Polynomial& argument, const Polynomial& derivative) {
    int number = 1;
    for (const Primitive& p : solution.primitives) {
        if (p.kind != PrimitiveKind::logarithm) continue;
        if (p.argument == argument) return p.id;
        ++number;
    }
    Generator g = make(GeneratorKind::primitive, fmt::format("L{}", number));
    g.derivatives.emplace_back(clock_, derivative);
    const RingPtr before = solution.ring;
    const GeneratorId id = extend(std::move(g));
    solution.primitives.push_back({id, ring().generator(id).name, PrimitiveKind::logarithm,
                                   RingMap::by_name(before, solution.ring)(argument), false});
    return id;
}

Polynomial Draft::exponential(const Polynomial& argument, const std::string& name) {
    Generator g = make(GeneratorKind::primitive, name, true);
    g.positive = true;
    const bool over_slow_time = uses_slow_time(argument);
    if (!over_slow_time) g.derivatives.emplace_back(clock_, ring().derivative(argument, clock_));
    const RingPtr before = solution.ring;
    const GeneratorId id = extend(std::move(g), true);
    solution.primitives.push_back({id, ring().generator(id).name, PrimitiveKind::exponential,
                                   RingMap::by_name(before, solution.ring)(argument), over_slow_time});
    return ring().gen(id);
}

} // namespace resonform
