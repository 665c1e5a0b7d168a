// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/points/source.hpp"

#include "algebra/graph/bounds.hpp"

#include <map>

namespace resonform {

namespace {

Rational number(Residue r) { return Rational(static_cast<unsigned long>(r)); }

// All series of a normalisation in one order.
template <class NormalFormType, class Map, class Visit>
void each_series(NormalFormType& normal_form, Map& map, Visit visit) {
    for (auto* list : {&normal_form.mode, &normal_form.angle, &normal_form.slow, &normal_form.drift})
        for (auto& series : *list) visit(series);
    for (auto* list : {&map.mode, &map.angle, &map.slow, &map.drift})
        for (auto& series : *list) visit(series);
}

} // namespace

GraphSource::GraphSource(const GraphNormalization& normalization) : normalization_(normalization) {
    const NormalizationOf<GraphPart>& from = normalization.result;
    each_series(from.normal_form, from.map, [&](const BasicSeries<GraphPart>& series) { add(series); });
    normal_form_.field = from.normal_form.field;
    normal_form_.through = from.normal_form.through;
    normal_form_.style = from.normal_form.style;
    normal_form_.mode.resize(from.normal_form.mode.size());
    normal_form_.angle.resize(from.normal_form.angle.size());
    normal_form_.slow.resize(from.normal_form.slow.size());
    normal_form_.drift.resize(from.normal_form.drift.size());
    map_.through = from.map.through;
    map_.mode.resize(from.map.mode.size());
    map_.angle.resize(from.map.angle.size());
    map_.slow.resize(from.map.slow.size());
    map_.drift.resize(from.map.drift.size());
}

void GraphSource::add(const BasicSeries<GraphPart>& series) {
    for (int weight = 0; weight <= series.through(); ++weight) {
        add(series.part(weight), series_, weight, -1);
        for (const SlowVariable& s : normalization_.result.normal_form.field->slow)
            add(normalization_.domain.derivative(series.part(weight), s.generator), series_, weight,
                s.generator);
    }
    ++series_;
}

void GraphSource::add(const GraphPart& part, std::size_t series, int weight, GeneratorId slow) {
    for (std::size_t k = 0; k < part.size(); ++k) {
        slots_.push_back({series, weight, normalization_.domain.monomial(part.keys[k]), slow});
        coefficients_.push_back(part.coefficients[k]);
    }
}

void GraphSource::go_to(const Point& point) {
    const std::vector<Residue> values = values_at(point);
    std::vector<std::map<int, std::vector<Term>>> terms(series_);
    const Ring& ring = *normal_form_.field->ring;
    for (std::size_t k = 0; k < slots_.size(); ++k) {
        const Slot& slot = slots_[k];
        std::vector<Term>& list = terms[slot.series][slot.weight];
        if (slot.slow < 0) {
            list.push_back({slot.monomial, number(values[k])});
            continue;
        }
        const Residue start = point.values[static_cast<std::size_t>(slot.slow)];
        list.push_back({slot.monomial + ring.monomial(slot.slow), number(values[k])});
        list.push_back({slot.monomial, number(point.field.negate(point.field.multiply(values[k], start)))});
    }
    std::vector<Series> series(series_);
    for (std::size_t k = 0; k < series_; ++k)
        for (auto& [weight, list] : terms[k]) series[k].set(weight, Polynomial::from_terms(std::move(list)));
    distribute(std::move(series));
}

void GraphSource::distribute(std::vector<Series> series) {
    std::size_t next = 0;
    each_series(normal_form_, map_, [&](Series& to) { to = std::move(series[next++]); });
}

std::vector<Residue> GraphSource::values_at(const Point& point) const {
    const GraphReplay replay(normalization_.domain.graph(), coefficients_);
    ModularReplay modular(replay, point.field);
    std::vector<ModularReplay::Block> leaves;
    const Ring& ring = *normal_form_.field->ring;
    for (const LeafId leaf : replay.leaves()) {
        const Monomial m =
            normalization_.domain.polynomial(LeafPolynomial::leaf(leaf)).terms().front().monomial;
        GeneratorId id = 0;
        while (ring.exponent(m, id) == 0) ++id;
        leaves.emplace_back().fill(point.values[static_cast<std::size_t>(id)]);
    }
    const auto blocks = modular.evaluate(leaves);
    if (!blocks) throw UnluckyPoint();
    std::vector<Residue> values;
    for (const ModularReplay::Block& block : *blocks) values.push_back(block[0]);
    return values;
}

double GraphSource::error() const {
    const GraphBounds bounds = bounds_of(normalization_.domain.graph());
    const double once = 2.0 * bounds.degree / 0x1p60 + bounds.bits / 60 / primes_to_choose_from;
    return (normal_form_.through + 1) * once;
}

} // namespace resonform
