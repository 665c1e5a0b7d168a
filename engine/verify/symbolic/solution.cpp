// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/solution.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/functions.hpp"
#include "solve/flow/slow_flow.hpp"
#include "solve/slow_law.hpp"
#include "solve/small_divisors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace resonform {

namespace {

using Of = SymbolicVariable::Kind;

std::set<GeneratorId> generators_in(const SymbolicSum& sum) {
    std::set<GeneratorId> ids;
    for (const SymbolicTerm& term : sum)
        for (const auto& power : term.powers) ids.insert(power.first);
    return ids;
}

template <class List> const auto& output_of(const List& outputs, const std::string& name) {
    const auto found =
        std::find_if(outputs.begin(), outputs.end(), [&](const auto& o) { return o.name == name; });
    if (found == outputs.end())
        bad_input({"the output is not a variable of the system", name, "remove it from outputs", {}});
    return *found;
}

std::string text_of(const SymbolicSum& sum) {
    std::string text;
    for (const SymbolicTerm& term : sum) {
        text += term.coefficient.str();
        for (const auto& [id, exponent] : term.powers) text += fmt::format(" {}^{}", id, exponent);
        text += "\n";
    }
    return text + ";";
}

} // namespace

SymbolicSolution::SymbolicSolution(const Solution& solution, const Scene& scene, bool fixed)
    : solution_(solution), scene_(scene) {
    if (fixed) fix_ = scene.fix;
    std::vector<GiNaC::ex> fixed_values;
    for (const auto& [name, value] : fix_) fixed_values.push_back(value);
    const Tape tape = Tape::constants(solution.system(), fixed_values);
    const std::vector<Float128> none(solution.system().parameters.size());
    const std::vector<Float128> numbers = evaluate_constants(tape, none, Float128(0));
    std::size_t next = 0;
    for (const auto& named : fix_) fix_values_.emplace(named.first, numbers[next++]);
    const RingPtr ring = solution.flow ? solution.normalization->normal_form.field->ring : solution.ring;
    ring_ = std::make_unique<SymbolicRing>(ring, fix_, solution.system());
    if (solution.flow)
        read_flow();
    else
        read_closed();
    add_corrections();
    add_conditions();
    keep_what_is_needed();
}

std::size_t SymbolicSolution::add(SymbolicVariable variable) {
    variables_.push_back(std::move(variable));
    return variables_.size() - 1;
}

void SymbolicSolution::add_slow(const Variable& variable, GeneratorId id, std::size_t start,
                                const Polynomial& rate, int power) {
    SymbolicVariable slow{Of::slow, id};
    slow.power = power;
    slow.start = start;
    slow.rate = ring_->fixed()(rate);
    if (const auto path = slow_path(ring_->ring(), id, rate)) {
        slow.drive = ring_->fixed()(path->drive);
        slow.decline = ring_->fixed()(path->decline);
    }
    add(std::move(slow));
    slow_symbols_.push_back(GiNaC::ex_to<GiNaC::symbol>(variable.jet.front()));
    const SymbolicSum itself{{1, {{id, 1}}}};
    if (variable.positive)
        conditions_.push_back({SymbolicCondition::Kind::slow, itself});
    else if (variable.nonzero)
        conditions_.push_back({SymbolicCondition::Kind::keeps_sign, itself});
}

void SymbolicSolution::add_layers(const std::function<Polynomial(const Polynomial&)>& lifted) {
    for (const MovingDivisor& moving : moving_divisors(*solution_.normalization))
        layers_.push_back({ring_->fixed()(lifted(moving.divisor)), ring_->fixed()(lifted(moving.rate))});
    for (const StandingDivisor& standing : standing_divisors(*solution_.normalization))
        conditions_.push_back(
            {SymbolicCondition::Kind::standing, ring_->fixed()(lifted(standing.square - standing.least))});
}

void SymbolicSolution::add_corrections() {
    if (!solution_.modes.empty()) modulus_ = ring_->fixed()(leading_modulus(solution_));
    const std::vector<Mode>& modes = solution_.normalization->normal_form.field->modes;
    for (FirstCorrection& correction : first_corrections(solution_)) {
        SymbolicCorrection added{std::move(correction), {}, modulus_, true};
        if (solution_.flow)
            for (const std::size_t k : added.correction.modes)
                if (!modes[k].is_damped()) added.needs.push_back({1, {{modes[k].z, 1}}});
        for (const Polynomial& p : added.correction.polynomials()) {
            added.polynomials.push_back(ring_->fixed()(p));
            added.needs.insert(added.needs.end(), added.polynomials.back().begin(),
                               added.polynomials.back().end());
        }
        added.is_layer = !needs_quadratures(solution_, added.correction);
        if (!added.is_layer || added.correction.quantity)
            conditions_.push_back({SymbolicCondition::Kind::correction, added.needs, corrections_.size()});
        corrections_.push_back(std::move(added));
    }
}

std::vector<Wide> SymbolicSolution::moduli(const SymbolicValues<Wide>& values, const Wide& eps) const {
    if (!solution_.flow) return {value_of(modulus_, values).size()};
    const std::vector<Mode>& modes = solution_.normalization->normal_form.field->modes;
    std::vector<Wide> result;
    for (const SymbolicVariable& v : variables_)
        if (v.kind == Of::mode)
            result.push_back(modes[v.start].is_damped()
                                 ? Wide(0)
                                 : Wide(values[v.id].size() / math::power(eps, v.weight)));
    return result;
}

void SymbolicSolution::read_closed() {
    const FixedRing& fixed = ring_->fixed();
    const Ring& ring = ring_->ring();
    const System& system = solution_.system();
    start_ = closed_start(solution_, scene_, *ring_);
    slow_time_ = solution_.slow_time;
    for (std::size_t k = 0; k < solution_.slow.size(); ++k) {
        const SlowLaw& law = solution_.slow[k];
        add_slow(system.variables[law.variable], law.generator, k, law.rate, 0);
    }
    for (const Primitive& p : solution_.primitives) {
        if (p.kind != PrimitiveKind::quadrature) {
            primitives_.push_back({p.id, p.kind == PrimitiveKind::logarithm, fixed(p.argument)});
            continue;
        }
        SymbolicVariable quadrature{Of::quadrature, p.id};
        quadrature.rate =
            fixed(p.over_slow_time ? p.argument : ring.multiply(p.argument, solution_.slow.front().rate));
        add(std::move(quadrature));
    }
    for (const ModeSolution& mode : solution_.modes) {
        SymbolicVariable phase{Of::phase};
        phase.power = 1;
        phase.rate = fixed(mode.phase_rate.total(mode.phase_rate.through()));
        SymbolicVariable angle{Of::angle, mode.phase};
        angle.phase = add(std::move(phase));
        add(std::move(angle));
        constants_.push_back({mode.amplitude, std::nullopt});
    }
    for (std::size_t k = 0; k < solution_.drift.size(); ++k)
        constants_.push_back({solution_.drift[k].constant, k});
    for (const std::string& name : scene_.outputs) {
        const auto slow = std::find_if(solution_.slow.begin(), solution_.slow.end(), [&](const SlowLaw& law) {
            return system.variables[law.variable].name == name;
        });
        Polynomial all;
        if (slow != solution_.slow.end()) {
            all = ring.gen(slow->generator);
        } else {
            const Series& series = output_of(solution_.outputs, name).value;
            all = series.total(series.through());
        }
        if (!scene_.oscillating && !solution_.modes.empty()) {
            std::vector<Term> mean;
            for (const Term& t : all.terms())
                if (ring.exponent(t.monomial, solution_.modes.front().phase) == 0) mean.push_back(t);
            all = Polynomial::from_terms(std::move(mean));
        }
        outputs_.push_back({name, fixed.written_out(all), std::nullopt});
    }
    add_layers([this](const Polynomial& p) { return (*solution_.from_normal_form)(p); });
}

void SymbolicSolution::read_flow() {
    const FixedRing& fixed = ring_->fixed();
    const GradedField& field = *solution_.normalization->normal_form.field;
    const SlowFlow& flow = *solution_.flow;
    const int power = field.ring->weights_in_one(); // of eps, in T = eps t
    start_ = flow_start_finder(solution_, scene_, *ring_);
    const auto all = [](const Series& series) { return series.total(series.through()); };
    for (std::size_t k = 0; k < field.slow.size(); ++k)
        add_slow(field.system().variables[field.slow[k].variable], field.slow[k].generator, k,
                 all(flow.slow[k]), power);
    const std::size_t phases = variables_.size(), decays = phases + flow.phases.size();
    const auto add_phases = [&](Of kind, const std::vector<Polynomial>& rates) {
        for (const Polynomial& rate : rates) {
            SymbolicVariable phase{kind};
            phase.power = power;
            phase.rate = fixed(rate);
            add(std::move(phase));
        }
    };
    add_phases(Of::phase, flow.phases);
    add_phases(Of::exponent, flow.decays);
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        SymbolicVariable mode{Of::mode, field.modes[k].z, field.modes[k].zbar};
        mode.weight = field.ring->generator(mode.id).weight;
        mode.power = mode.weight + power;
        if (flow.modes[k].phase) mode.phase = phases + *flow.modes[k].phase;
        if (flow.modes[k].decay) mode.decay = decays + *flow.modes[k].decay;
        mode.start = k;
        mode.rate = fixed(all(flow.modes[k].rate));
        add(std::move(mode));
    }
    for (std::size_t k = 0; k < field.angles.size(); ++k) {
        SymbolicVariable angle{Of::angle, field.angles[k].phase};
        angle.power = power;
        angle.phase = phases + *flow.angles[k].phase;
        angle.start = k;
        angle.rate = fixed(all(flow.angles[k].rate));
        add(std::move(angle));
    }
    const std::size_t drifts = variables_.size();
    for (std::size_t k = 0; k < field.drift.size(); ++k) {
        SymbolicVariable drift{Of::drift};
        drift.power = power;
        drift.start = k;
        drift.rate = fixed(all(flow.drift[k]));
        add(std::move(drift));
    }
    for (const std::string& name : scene_.outputs) {
        const FlowOutput& output = output_of(flow.outputs, name);
        Polynomial p = all(output.value);
        if (!scene_.oscillating) p = mean_part(field, flow, p);
        outputs_.push_back({name, fixed.written_out(p), std::nullopt});
        if (output.drift) outputs_.back().drift = drifts + *output.drift;
    }
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (const Mode& mode = field.modes[k]; mode.is_damped() && !flow.modes[k].passes)
            conditions_.push_back({flow.modes[k].either ? SymbolicCondition::Kind::keeps_sign
                                                        : SymbolicCondition::Kind::radicand,
                                   fixed(flow.modes[k].leading_rate(mode))});
    const std::vector<FadingDivisor> fading = fading_divisors(solution_, scene_.outputs);
    for (const SymbolicRing::Root& root : ring_->roots())
        if (root.divisor && !passes_zero(flow, field, ring_->ring().generator(root.id).radicand) &&
            !fades(fading, root.id))
            conditions_.push_back({SymbolicCondition::Kind::keeps_sign, {{1, {{root.id, 1}}}}});
    add_layers([](const Polynomial& p) { return p; });
}

void SymbolicSolution::add_conditions() {
    for (const SymbolicRing::Root& root : ring_->roots())
        if (!root.positive.empty()) conditions_.push_back({SymbolicCondition::Kind::radicand, root.positive});
    for (const SymbolicPrimitive& p : primitives_)
        if (p.logarithm) conditions_.push_back({SymbolicCondition::Kind::radicand, p.argument});
    const System& system = solution_.system();
    std::vector<GiNaC::ex> expressions;
    for (const Declaration& declared : system.positive) {
        SymbolicCondition condition{SymbolicCondition::Kind::declared, {}, expressions.size()};
        std::size_t next = 0;
        for (const SymbolicVariable& v : variables_) // for the generators it needs
            if (v.kind == Of::slow && declared.value.has(slow_symbols_[next++]))
                condition.sum.push_back({1, {{v.id, 1}}});
        conditions_.push_back(std::move(condition));
        expressions.push_back(declared.value);
    }
    declared_ = std::make_unique<Tape>(Tape::of(system, slow_symbols_, expressions));
}

void SymbolicSolution::keep_what_is_needed() {
    std::set<GeneratorId> used;
    const auto use = [&](const SymbolicSum& sum, const auto& again) -> void {
        for (const GeneratorId id : generators_in(sum)) {
            if (!used.insert(id).second) continue;
            for (const SymbolicRing::Root& root : ring_->roots())
                if (root.id == id) again(root.radicand, again);
            for (const SymbolicPrimitive& p : primitives_)
                if (p.id == id) again(p.argument, again);
            for (SymbolicVariable& v : variables_) {
                if (v.id != id && v.conjugate != id) continue;
                v.needed = true;
                again(v.rate, again);
                for (const std::optional<std::size_t>& turns : {v.phase, v.decay}) {
                    if (!turns) continue;
                    variables_[*turns].needed = true;
                    again(variables_[*turns].rate, again);
                }
            }
        }
    };
    for (const SymbolicOutput& output : outputs_) {
        use(output.sum, use);
        if (!output.drift) continue;
        variables_[*output.drift].needed = true;
        use(variables_[*output.drift].rate, use);
    }
    std::erase_if(primitives_, [&](const SymbolicPrimitive& p) { return used.count(p.id) == 0; });
    // Drops conditions and layers with moving generators that are not computed.
    const auto unknown = [&](const SymbolicSum& sum, const auto& again) -> bool {
        for (const GeneratorId id : generators_in(sum)) {
            if (used.count(id) > 0) continue;
            const GeneratorKind kind = ring_->ring().generator(id).kind;
            if (kind != GeneratorKind::root && kind != GeneratorKind::small &&
                kind != GeneratorKind::parameter && kind != GeneratorKind::imaginary)
                return true;
            for (const SymbolicRing::Root& root : ring_->roots())
                if (root.id == id && again(root.radicand, again)) return true;
        }
        return false;
    };
    std::erase_if(conditions_, [&](const SymbolicCondition& c) { return unknown(c.sum, unknown); });
    std::erase_if(layers_, [&](const SymbolicLayer& layer) {
        return unknown(layer.divisor, unknown) || unknown(layer.rate, unknown);
    });
    for (SymbolicCorrection& added : corrections_)
        added.is_layer = added.is_layer && !unknown(added.needs, unknown);
}

// All of the system, in its order.
std::vector<Float128> SymbolicSolution::parameters(const SymbolicInputs& inputs) const {
    std::vector<Float128> values;
    for (const Parameter& p : solution_.system().parameters) {
        const auto given = inputs.parameters.find(p.name);
        const auto fixed = fix_values_.find(p.name);
        values.push_back(given != inputs.parameters.end() ? narrowed<Float128>(given->second)
                         : fixed != fix_values_.end()     ? fixed->second
                                                          : Float128(0));
    }
    return values;
}

std::vector<Float128> SymbolicSolution::declared_at(const std::vector<Wide>& slow,
                                                    const SymbolicInputs& inputs) const {
    std::vector<Float128> states;
    for (const Wide& x : slow) states.push_back(narrowed<Float128>(x));
    BoundTape<Float128> tape(*declared_, parameters(inputs), narrowed<Float128>(inputs.eps));
    std::vector<Float128> found(declared_->outputs().size());
    tape.evaluate(states.data(), found.data());
    return found;
}

std::string SymbolicSolution::text() const {
    std::string text = fmt::format("symbolic 8{}\n", solution_.system().eps_root == 1
                                                         ? ""
                                                         : fmt::format(" 1/{}", solution_.system().eps_root));
    for (const SymbolicRing::Root& root : ring_->roots())
        text += fmt::format("root {} {} {} {}", root.id, root.index,
                            root.data != nullptr ? fmt::format("{} {}", root.derivative, root.data->text())
                            : root.function      ? std::string(row_of(*root.function).name)
                                                 : "",
                            text_of(root.radicand));
    for (const SymbolicVariable& v : variables_)
        text += fmt::format("variable {} {} {} {} {} {} {}", static_cast<int>(v.kind), v.id, v.power,
                            v.phase.value_or(0), v.decay.value_or(0), v.needed, text_of(v.rate));
    for (const SymbolicPrimitive& p : primitives_)
        text += fmt::format("primitive {} {} {}", p.id, p.logarithm, text_of(p.argument));
    for (const SymbolicOutput& o : outputs_)
        text += fmt::format("output {} {} {}", o.name, o.drift.value_or(0), text_of(o.sum));
    for (const SymbolicCondition& c : conditions_)
        text += fmt::format("condition {} {} {}", static_cast<int>(c.kind), c.index, text_of(c.sum));
    for (const SymbolicLayer& layer : layers_)
        text += "layer " + text_of(layer.divisor) + text_of(layer.rate);
    for (const SymbolicCorrection& added : corrections_) {
        text += fmt::format("correction {} {}", added.is_layer, text_of(added.needs));
        for (const std::vector<FirstCorrection::Term>& terms : added.correction.sums)
            for (const FirstCorrection::Term& term : terms)
                text += fmt::format("{} {};", term.power_of_eps, fmt::join(term.powers, " "));
        for (const FirstCorrection::Slope& slope : added.correction.slopes)
            text += fmt::format("slope {};", fmt::join(slope.powers, " "));
    }
    return text + declared_->text();
}

} // namespace resonform
