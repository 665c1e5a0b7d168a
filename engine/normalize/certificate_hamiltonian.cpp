// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_hamiltonian.hpp"

#include "normalize/certificate_lie.hpp"

#include <fmt/format.h>

#include <map>

namespace resonform {

Equation energy_as_equation(const System& system) {
    const Hamiltonian& h = *system.hamiltonian;
    return {"the energy", h.text, h.energy, h.source};
}

int canonical_bracket(const FirstOrderSystem& system, std::size_t left, std::size_t right) {
    const std::size_t a = system.states[left].variable, b = system.states[right].variable;
    for (const auto& [coordinate, momentum] : system.system->hamiltonian->pairs) {
        if (a == coordinate && b == momentum) return 1;
        if (a == momentum && b == coordinate) return -1;
    }
    return 0;
}

namespace {

class CanonicalCheck {
public:
    using Value = PointAlgebra::Value;
    using Row = std::map<GeneratorId, Value>; // dy/dw_b, or a row of T

    CanonicalCheck(const NormalForm& normal_form, const NearIdentityMap& map, CertificateRoots& roots,
                   const Point& point)
        : normal_form_(normal_form), map_(map), form_(*normal_form.hamiltonian), field_(*normal_form.field),
          weight_(field_.ring->generator(field_.modes.front().z).weight),
          algebra_(*field_.ring, point, normal_form.through + weight_), roots_(roots),
          jets_(Flow(algebra_, roots_, normal_form, map).jets()) {}

    std::string complaint() {
        check_structure();
        check_map();
        check_rates();
        check_energy();
        check_generator();
        return sentence_;
    }

private:
    [[nodiscard]] Value value(const Polynomial& p) const { return gradient(Series({p})).value; }
    [[nodiscard]] Gradient<Value> gradient(const Series& s, Side side = Side::itself) const {
        return algebra_.gradient(s, side);
    }
    [[nodiscard]] Value minus(const Value& v) const { return algebra_.multiply(algebra_.number(-1), v); }

    void must_be_equal(const Value& a, const Value& b, int through, const std::string& sentence) {
        for (int n = 0; n <= through && sentence_.empty(); ++n)
            if (a[static_cast<std::size_t>(n)] != b[static_cast<std::size_t>(n)])
                sentence_ = fmt::format("weight {}: {}", to_string(field_.system().weight(n)), sentence);
    }

    // sum over the brackets of B (left_l right_r - left_r right_l)
    [[nodiscard]] Value bracket(const Row& left, const Row& right) const {
        Value sum = algebra_.number(0);
        for (const HamiltonianForm::Bracket& b : form_.brackets) {
            const Value minor = algebra_.add(algebra_.multiply(left.at(b.left), right.at(b.right)),
                                             minus(algebra_.multiply(left.at(b.right), right.at(b.left))));
            sum = algebra_.add(sum, algebra_.multiply(value(b.value), minor));
        }
        return sum;
    }

    void check_structure() {
        const Equation& equation = field_.system().equations.front();
        EquationEvaluator<PointAlgebra> evaluate(algebra_, roots_, jets_.values, equation);
        const Value i = algebra_.generator(Ring::imaginary_unit, 1);
        std::vector<Row> rows(field_.basis.states.size());
        for (std::size_t s = 0; s < rows.size(); ++s)
            for (std::size_t m = 0; m < field_.modes.size(); ++m) {
                const Complex& c = field_.basis.modes[m].column[s];
                const Value re = evaluate(c.re), im = algebra_.multiply(i, evaluate(c.im));
                rows[s][field_.modes[m].z] = algebra_.add(re, im);
                if (!field_.modes[m].is_real()) rows[s][field_.modes[m].zbar] = algebra_.add(re, minus(im));
            }
        for (std::size_t s = 0; s < rows.size(); ++s)
            for (std::size_t t = s + 1; t < rows.size(); ++t) {
                const int expected =
                    canonical_bracket(*field_.first_order, field_.basis.states[s], field_.basis.states[t]);
                must_be_equal(bracket(rows[s], rows[t]), algebra_.number(expected), 0,
                              "the brackets of the modes are not canonical");
            }
    }

    [[nodiscard]] Row map_row(std::size_t m, Side side) const {
        const Mode& mode = field_.modes[m];
        Row row;
        for (const HamiltonianForm::Bracket& b : form_.brackets)
            for (const GeneratorId id : {b.left, b.right}) row[id] = algebra_.number(0);
        row[side == Side::itself ? mode.z : mode.zbar] = algebra_.number(1);
        for (const auto& [id, slope] : gradient(map_.mode[m], side).slopes) {
            const GeneratorId partner = field_.ring->generator(id).conjugate;
            const GeneratorId by = side == Side::conjugate && partner >= 0 ? partner : id;
            if (row.count(by) != 0) row[by] = algebra_.add(row[by], slope);
        }
        return row;
    }

    void check_map() {
        std::map<GeneratorId, Row> rows;
        for (std::size_t m = 0; m < field_.modes.size(); ++m) {
            rows[field_.modes[m].z] = map_row(m, Side::itself);
            if (!field_.modes[m].is_real()) rows[field_.modes[m].zbar] = map_row(m, Side::conjugate);
        }
        for (auto a = rows.begin(); a != rows.end(); ++a)
            for (auto b = std::next(a); b != rows.end(); ++b) {
                Value expected = algebra_.number(0);
                for (const HamiltonianForm::Bracket& known : form_.brackets) {
                    if (known.left == a->first && known.right == b->first) expected = value(known.value);
                    if (known.left == b->first && known.right == a->first)
                        expected = minus(value(known.value));
                }
                must_be_equal(bracket(a->second, b->second), expected, normal_form_.through - weight_,
                              "the map is not canonical");
            }
    }

    void check_rates() {
        std::map<GeneratorId, Value> slopes;
        for (auto& [id, slope] : gradient(form_.energy).slopes) slopes[id] = slope;
        const auto slope = [&](GeneratorId id) {
            const auto found = slopes.find(id);
            return found == slopes.end() ? algebra_.number(0) : found->second;
        };
        for (std::size_t m = 0; m < field_.modes.size(); ++m) {
            Value rate = algebra_.number(0);
            for (const HamiltonianForm::Bracket& b : form_.brackets) {
                const Value factor = value(b.value);
                if (b.left == field_.modes[m].z) rate = algebra_.multiply(factor, slope(b.right));
                if (b.right == field_.modes[m].z) rate = minus(algebra_.multiply(factor, slope(b.left)));
            }
            const std::string& name = field_.modes[m].name;
            must_be_equal(gradient(normal_form_.mode[m]).value, rate, normal_form_.through,
                          fmt::format("{0}' is not {{{0}, K}}", name));
        }
    }

    void check_energy() {
        const Equation energy = energy_as_equation(field_.system());
        EquationEvaluator<PointAlgebra> evaluate(algebra_, roots_, jets_.values, energy);
        must_be_equal(evaluate(energy.residual), gradient(form_.energy).value, normal_form_.through + weight_,
                      "the energy along the map is not K");
    }

    void check_generator() {
        const FlowAtPoint flow(algebra_, *field_.ring, form_, normal_form_.through - weight_);
        for (std::size_t m = 0; m < field_.modes.size(); ++m) {
            const Mode& mode = field_.modes[m];
            const auto compare = [&](GeneratorId coordinate, Side side) {
                must_be_equal(
                    flow.at_one(coordinate),
                    algebra_.add(algebra_.generator(coordinate, 1), gradient(map_.mode[m], side).value),
                    normal_form_.through,
                    fmt::format("the map of {} is not the Lie series of the generator", mode.name));
            };
            compare(mode.z, Side::itself);
            if (!mode.is_real()) compare(mode.zbar, Side::conjugate);
        }
    }

    const NormalForm& normal_form_;
    const NearIdentityMap& map_;
    const HamiltonianForm& form_;
    const GradedField& field_;
    int weight_; // of the modes
    PointAlgebra algebra_;
    CertificateRoots& roots_;
    Jets<Value> jets_;
    std::string sentence_;
};

} // namespace

std::string canonical_complaint(const NormalForm& normal_form, const NearIdentityMap& map,
                                CertificateRoots& roots, const Point& point) {
    return CanonicalCheck(normal_form, map, roots, point).complaint();
}

} // namespace resonform
