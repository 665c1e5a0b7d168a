// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/hamiltonian.hpp"

#include <fmt/format.h>

#include <map>

namespace resonform {

int weight_of_modes(const GradedField& field) { return field.ring->generator(field.modes.front().z).weight; }

namespace {

// J: the bracket of two states of the first-order system, 1 for coordinate and momentum.
int canonical_bracket(const FirstOrderSystem& system, std::size_t left, std::size_t right) {
    const std::size_t a = system.states[left].variable, b = system.states[right].variable;
    for (const auto& [coordinate, momentum] : system.system->hamiltonian->pairs) {
        if (a == coordinate && b == momentum) return 1;
        if (a == momentum && b == coordinate) return -1;
    }
    return 0;
}

class CanonicalChecks {
public:
    using SlotRow = std::map<GeneratorId, Slot>; // dy/dw_b, or a row of T

    CanonicalChecks(CertificatePlan& plan, const GradedField& field, const HamiltonianForm& form)
        : plan_(plan), program_(plan.program), field_(field), form_(form), weight_(weight_of_modes(field)) {}

    void add(const Jets& jets, CertificateRoots& roots) {
        add_structure(jets, roots);
        add_map();
        add_rates();
        add_energy(jets, roots);
        note_coordinates();
    }

private:
    void must_be_equal(Slot a, Slot b, int weight, bool above_order, std::string sentence) {
        plan_.checks.push_back(
            {program_.difference(a, b), weight, above_order, ++stage_, std::move(sentence)});
    }

    // sum over the brackets of B (left_l right_r - left_r right_l)
    [[nodiscard]] Slot bracket(const SlotRow& left, const SlotRow& right) const {
        Slot sum = program_.number(0);
        for (const HamiltonianForm::Bracket& b : form_.brackets) {
            const Slot minor = program_.difference(program_.multiply(left.at(b.left), right.at(b.right)),
                                                   program_.multiply(left.at(b.right), right.at(b.left)));
            sum = program_.add(sum, program_.multiply(program_.value(b.value), minor));
        }
        return sum;
    }

    void add_structure(const Jets& jets, CertificateRoots& roots) {
        const Equation& equation = field_.system().equations.front();
        const Slot i = program_.generator(Ring::imaginary_unit, 1);
        std::vector<SlotRow> rows(field_.basis.states.size());
        for (std::size_t s = 0; s < rows.size(); ++s)
            for (std::size_t m = 0; m < field_.modes.size(); ++m) {
                const Complex& c = field_.basis.modes[m].column[s];
                const Slot re = substitute(program_, roots, jets.values, equation, c.re);
                const Slot im =
                    program_.multiply(i, substitute(program_, roots, jets.values, equation, c.im));
                rows[s][field_.modes[m].z] = program_.add(re, im);
                if (!field_.modes[m].is_real()) rows[s][field_.modes[m].zbar] = program_.difference(re, im);
            }
        for (std::size_t s = 0; s < rows.size(); ++s)
            for (std::size_t t = s + 1; t < rows.size(); ++t) {
                const int expected =
                    canonical_bracket(*field_.first_order, field_.basis.states[s], field_.basis.states[t]);
                must_be_equal(bracket(rows[s], rows[t]), program_.number(expected), 0, false,
                              "the brackets of the modes are not canonical");
            }
    }

    [[nodiscard]] SlotRow map_row(std::size_t m, Side side) const {
        const Mode& mode = field_.modes[m];
        const GeneratorId own = side == Side::itself ? mode.z : mode.zbar;
        SlotRow row;
        for (const HamiltonianForm::Bracket& b : form_.brackets)
            for (const GeneratorId by : {b.left, b.right}) {
                const GeneratorId partner = field_.ring->generator(by).conjugate;
                const GeneratorId id = side == Side::conjugate && partner >= 0 ? partner : by;
                row[by] = program_.add(program_.number(by == own ? 1 : 0),
                                       program_.slope({SeriesName::mode_shift, m}, side, id));
            }
        return row;
    }

    void add_map() {
        std::map<GeneratorId, SlotRow> rows;
        for (std::size_t m = 0; m < field_.modes.size(); ++m) {
            rows[field_.modes[m].z] = map_row(m, Side::itself);
            if (!field_.modes[m].is_real()) rows[field_.modes[m].zbar] = map_row(m, Side::conjugate);
        }
        for (auto a = rows.begin(); a != rows.end(); ++a)
            for (auto b = std::next(a); b != rows.end(); ++b) {
                Slot expected = program_.number(0);
                for (const HamiltonianForm::Bracket& known : form_.brackets) {
                    if (known.left == a->first && known.right == b->first)
                        expected = program_.value(known.value);
                    if (known.left == b->first && known.right == a->first)
                        expected = program_.minus(program_.value(known.value));
                }
                must_be_equal(bracket(a->second, b->second), expected, -weight_, true,
                              "the map is not canonical");
            }
    }

    void add_rates() {
        const auto slope = [&](GeneratorId id) {
            return program_.slope({SeriesName::energy}, Side::itself, id);
        };
        for (std::size_t m = 0; m < field_.modes.size(); ++m) {
            Slot rate = program_.number(0);
            for (const HamiltonianForm::Bracket& b : form_.brackets) {
                const Slot factor = program_.value(b.value);
                if (b.left == field_.modes[m].z) rate = program_.multiply(factor, slope(b.right));
                if (b.right == field_.modes[m].z)
                    rate = program_.minus(program_.multiply(factor, slope(b.left)));
            }
            must_be_equal(program_.value({SeriesName::mode_rate, m}, Side::itself), rate, 0, true,
                          fmt::format("{0}' is not {{{0}, K}}", field_.modes[m].name));
        }
    }

    void add_energy(const Jets& jets, CertificateRoots& roots) {
        const Hamiltonian& h = *field_.system().hamiltonian;
        const Equation energy{"the energy", h.text, h.energy, h.source}; // for messages
        must_be_equal(substitute(program_, roots, jets.values, energy, energy.residual),
                      program_.value({SeriesName::energy}, Side::itself), weight_, true,
                      "the energy along the map is not K");
    }

    void note_coordinates() {
        for (std::size_t m = 0; m < field_.modes.size(); ++m) {
            const Mode& mode = field_.modes[m];
            const auto note = [&](GeneratorId id, Side side) {
                const Slot shift = program_.value({SeriesName::mode_shift, m}, side);
                plan_.coordinates.push_back({id, program_.add(program_.generator(id, 1), shift), mode.name});
            };
            note(mode.z, Side::itself);
            if (!mode.is_real()) note(mode.zbar, Side::conjugate);
        }
    }

    CertificatePlan& plan_;
    CertificateProgram& program_;
    const GradedField& field_;
    const HamiltonianForm& form_;
    int weight_; // of the modes
    int stage_ = 0;
};

} // namespace

void add_canonical_checks(CertificatePlan& plan, const GradedField& field, const HamiltonianForm& form,
                          const Jets& jets, CertificateRoots& roots) {
    CanonicalChecks(plan, field, form).add(jets, roots);
}

} // namespace resonform
