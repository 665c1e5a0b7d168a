// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/recipe.hpp"

#include "emit/program/reused_places.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace resonform {

namespace {

using Value = StraightLine::Value;
using Kind = Recipe::Kind;

constexpr std::size_t most_slots = 1024; // runtime/kernel/view.hpp, most_factors

bool reads_a(Kind kind) {
    return kind == Kind::product || kind == Kind::sum || kind == Kind::difference ||
           kind == Kind::multiply_add || kind == Kind::multiply_subtract;
}
bool reads_b(Kind kind) { return kind != Kind::constant; }
bool reads_c(Kind kind) { return kind >= Kind::multiply_add && kind <= Kind::scaled_subtract; }

// First every operation has a place of its own; then places that are not needed any more are used again.
class RecipeBuilder {
public:
    RecipeBuilder(const Program& program, StraightLine& code) : code_(code) {
        for (const ProgramOutput& output : program.outputs) outputs_.push_back(code_.lower(output.value));
        for (const ProgramPhase& phase : program.phases) {
            auto place = static_cast<int>(degrees_.size());
            for (const Graph::Node symbol : phase.symbols()) places_[code_.lower(symbol)] = place++;
            degrees_.insert(degrees_.end(), 2, phase.decays() ? std::pair{0, 1} : std::pair{1, 0});
        }
        turned_ = static_cast<int>(degrees_.size());
    }

    std::optional<Recipe> build() {
        const std::vector<Value> order = code_.behind(outputs_, false);
        if (!find_turning(order)) return std::nullopt;
        for (const Value v : order)
            if (turning_.count(v) > 0 && places_.count(v) == 0 && !is_fused(v)) places_[v] = operate(v);
        for (const Value v : outputs_) recipe_.results.push_back(place_of_output(v));
        for (const int place : recipe_.results) {
            recipe_.turns = std::max(recipe_.turns, degree(place).first);
            recipe_.fades = std::max(recipe_.fades, degree(place).second);
        }
        if (!assign_slots()) return std::nullopt;
        return std::move(recipe_);
    }

private:
    struct Term { // constant (or -1) times the places
        Value constant = -1;
        std::vector<int> places;
    };
    [[nodiscard]] bool turns(Value v) const { return turning_.count(v) > 0; }
    [[nodiscard]] const std::pair<int, int>& degree(int place) const {
        return degrees_[static_cast<std::size_t>(place)];
    }

    // False: something else than sums and products turns.
    bool find_turning(const std::vector<Value>& order) {
        for (const Value v : outputs_) ++uses_[v];
        for (const Value v : order) {
            const StraightLine::Instruction& i = code_.at(v);
            const bool turning = places_.count(v) > 0 || std::any_of(i.operands.begin(), i.operands.end(),
                                                                     [&](Value w) { return turns(w); });
            if (!turning) continue;
            const bool polynomial =
                places_.count(v) > 0 || i.op == StraightLine::Op::add || i.op == StraightLine::Op::multiply;
            if (!polynomial) return false;
            turning_.insert(v);
            for (const Value operand : i.operands) {
                ++uses_[operand];
                if (i.op == StraightLine::Op::add) summed_.insert(operand);
            }
        }
        return true;
    }

    // A product that stands in one sum alone is computed with it.
    [[nodiscard]] bool is_fused(Value v) const {
        return code_.at(v).op == StraightLine::Op::multiply && uses_.at(v) == 1 && summed_.count(v) > 0;
    }

    int atom(Value v) {
        if (const auto known = places_.find(v); known != places_.end()) return known->second;
        recipe_.atoms.push_back(v);
        degrees_.emplace_back(0, 0);
        const int place = static_cast<int>(degrees_.size()) - 1;
        atoms_.push_back(place);
        return places_[v] = place;
    }
    int constant(Value v) {
        const auto [known, fresh] = constants_.try_emplace(v, static_cast<int>(recipe_.constants.size()));
        if (fresh) recipe_.constants.push_back(v);
        return known->second;
    }

    int append(Kind kind, int a, int b = 0, int c = 0) {
        std::pair<int, int> of{0, 0};
        const auto at_most = [](int n) { return std::min(n, 1000); };
        const auto times = [&](int place) {
            of = {at_most(of.first + degree(place).first), at_most(of.second + degree(place).second)};
        };
        const auto plus = [&](int place) {
            of = {std::max(of.first, degree(place).first), std::max(of.second, degree(place).second)};
        };
        const bool adds = kind == Kind::sum || kind == Kind::difference;
        if (reads_b(kind)) times(b);
        if (reads_a(kind)) adds ? plus(a) : times(a);
        if (reads_c(kind)) plus(c);
        degrees_.push_back(of);
        const int to = static_cast<int>(degrees_.size()) - 1;
        recipe_.operations.push_back({kind, to, a, b, c});
        return to;
    }

    Term term_of(Value v) {
        if (!is_fused(v)) return {-1, {place_of(v)}};
        return factors_of(v);
    }

    int place_of(Value v) {
        if (turns(v)) return places_.at(v);
        return atom(v);
    }

    Term factors_of(Value v) {
        Term term;
        std::vector<Value> slow, constants;
        for (const Value w : code_.at(v).operands) {
            if (turns(w))
                term.places.push_back(places_.at(w));
            else
                (code_.at(w).varying ? slow : constants).push_back(w);
        }
        if (!constants.empty()) term.constant = code_.product(std::move(constants));
        if (!slow.empty()) term.places.push_back(atom(code_.product(std::move(slow))));
        return term;
    }

    // The first `count` places of a term and its constant, multiplied.
    int multiplied(const Term& term, std::size_t count) {
        int place = term.places.front();
        if (term.constant >= 0) place = append(Kind::scaled, constant(term.constant), place);
        for (std::size_t k = 1; k < count; ++k) place = append(Kind::product, place, term.places[k]);
        return place;
    }

    // sum + term, sum - term
    int added(int sum, const Term& term, bool minus) {
        if (term.places.size() == 1 && term.constant < 0)
            return append(minus ? Kind::difference : Kind::sum, sum, term.places.front());
        if (term.places.size() == 1)
            return append(minus ? Kind::scaled_subtract : Kind::scaled_add, constant(term.constant),
                          term.places.front(), sum);
        const int most = multiplied(term, term.places.size() - 1);
        return append(minus ? Kind::multiply_subtract : Kind::multiply_add, most, term.places.back(), sum);
    }

    int operate(Value v) {
        if (code_.at(v).op == StraightLine::Op::add) return sum_of(v);
        const Term term = factors_of(v);
        return multiplied(term, term.places.size());
    }

    int sum_of(Value v) {
        const std::vector<Value> operands = code_.at(v).operands;
        const std::size_t positive = operands.size() - code_.at(v).negative;
        std::vector<Value> plus, minus; // of what does not turn
        int sum = -1;
        for (std::size_t k = 0; k < operands.size(); ++k)
            if (!turns(operands[k])) (k < positive ? plus : minus).push_back(operands[k]);
        const bool all_turn = plus.empty() && minus.empty();
        const Value still = all_turn ? -1 : code_.sum(std::move(plus), std::move(minus));
        if (still >= 0 && code_.at(still).varying) sum = atom(still);
        for (std::size_t k = 0; k < operands.size(); ++k) {
            if (!turns(operands[k])) continue;
            const Term term = term_of(operands[k]);
            if (sum >= 0) {
                sum = added(sum, term, k >= positive);
                continue;
            }
            sum = multiplied(term, term.places.size());
            if (k >= positive) sum = append(Kind::scaled, constant(code_.number(-1)), sum);
        }
        return still >= 0 && !code_.at(still).varying ? append(Kind::shifted, constant(still), sum) : sum;
    }

    int place_of_output(Value v) {
        if (code_.at(v).varying) return place_of(v);
        return append(Kind::constant, constant(v));
    }

    // Phases and atoms keep their places; the others follow.
    bool assign_slots() {
        std::vector<int> slot(degrees_.size(), -1), last(degrees_.size(), -1);
        for (int place = 0; place < turned_; ++place) slot[static_cast<std::size_t>(place)] = place;
        int first = turned_;
        for (const int place : atoms_) slot[static_cast<std::size_t>(place)] = first++;
        std::vector<Recipe::Operation>& list = recipe_.operations;
        const auto for_operands = [](auto& o, const auto& f) {
            if (reads_a(o.kind)) f(o.a);
            if (reads_b(o.kind)) f(o.b);
            if (reads_c(o.kind)) f(o.c);
        };
        for (std::size_t k = 0; k < list.size(); ++k)
            for_operands(list[k],
                         [&](int place) { last[static_cast<std::size_t>(place)] = static_cast<int>(k); });
        for (const int place : recipe_.results)
            last[static_cast<std::size_t>(place)] = static_cast<int>(list.size());
        ReusedPlaces free(static_cast<std::size_t>(first));
        for (std::size_t k = 0; k < list.size(); ++k) {
            Recipe::Operation& o = list[k];
            for_operands(o, [&](int& place) {
                const auto p = static_cast<std::size_t>(place);
                place = slot[p];
                if (place >= first && last[p] == static_cast<int>(k))
                    free.give_back(static_cast<std::size_t>(place));
            });
            const auto to = static_cast<std::size_t>(o.to);
            o.to = slot[to] = static_cast<int>(free.take());
        }
        for (int& place : recipe_.results) place = slot[static_cast<std::size_t>(place)];
        return free.used() <= most_slots;
    }

    StraightLine& code_;
    std::vector<Value> outputs_;
    Recipe recipe_;
    std::set<Value> turning_, summed_;
    std::map<Value, int> uses_, places_, constants_;
    std::vector<std::pair<int, int>> degrees_; // of each place
    std::vector<int> atoms_;                   // places
    int turned_ = 0;                           // places of the phases
};

} // namespace

std::optional<Recipe> recipe_of(const Program& program, StraightLine& code) {
    return RecipeBuilder(program, code).build();
}

} // namespace resonform
