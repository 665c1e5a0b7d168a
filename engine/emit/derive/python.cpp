// SPDX-License-Identifier: GPL-3.0-or-later
// A normal form as a Python script for SymPy: symbols with their assumptions, one dictionary of terms
// for every variable. Importing it defines the dictionaries, running it prints the series.
#include "emit/derive/derive.hpp"
#include "emit/display/display.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/spelling.hpp"

#include <fmt/format.h>

#include <set>

namespace resonform {

namespace {

constexpr const char* script_end = R"(

def series(terms):
    """The sum of coefficient * product of the variables to their exponents."""
    return sum(c*prod(x**n for x, n in zip(variables, powers)) for powers, c in terms.items())


def main():
    for name, terms in normal_form.items():
        print(f"{name}' = {series(terms)}")
    for name, terms in near_identity_map.items():
        print(f"{name}: old = new + {series(terms)}")


if __name__ == "__main__":
    main()
)";

std::string python_name(const std::string& name) { return python_spelling().symbol(name, 0); }

std::string symbol_line(const std::string& name, const std::string& assumptions) {
    return fmt::format("{} = Symbol(\"{}\"{})\n", python_name(name), name, assumptions);
}

std::string real_symbol(const std::string& name, bool positive, bool nonzero) {
    if (positive) return symbol_line(name, ", positive=True");
    return symbol_line(name, nonzero ? ", real=True, nonzero=True" : ", real=True");
}

// The imported names: those of every script, and the functions in the coefficients.
std::string imported(const GradedField& field) {
    std::set<std::string> names{"I", "Rational", "Symbol", "exp", "prod", "sqrt"};
    if (field.ring->find("pi")) names.insert("pi");
    for (GeneratorId id = 0; id < field.ring->size(); ++id) {
        const Generator& g = field.ring->generator(id);
        if (g.kind != GeneratorKind::function) continue;
        if (g.of.function == Function::named)
            names.insert({"Derivative", "Function", "Subs"});
        else
            names.insert(display(*field.ring, field.ring->gen(id)).terms.front().factors.front().name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string symbols(const GradedField& field) {
    std::string text = real_symbol("eps", true, true);
    for (const Parameter& p : field.system().parameters) text += real_symbol(p.name, p.positive, p.nonzero);
    for (const SlowVariable& slow : field.slow) {
        const Variable& variable = field.system().variables[slow.variable];
        text += real_symbol(slow.name, variable.positive, variable.nonzero);
    }
    for (const AngleVariable& angle : field.angles) text += real_symbol(angle.name, false, false);
    for (const Mode& mode : field.modes) {
        text += symbol_line(mode.name, mode.is_real() ? ", real=True" : "");
        if (!mode.is_real()) text += symbol_line(mode.conjugate_name, "");
    }
    for (const NamedFunction& f : field.system().functions)
        text += fmt::format("{} = Function(\"{}\"{})\n", python_name(f.name), f.name,
                            f.positive  ? ", positive=True"
                            : f.nonzero ? ", real=True, nonzero=True"
                                        : ", real=True");
    return text;
}

// (a,) needs its comma.
std::string tuple(const std::string& elements, std::size_t size) {
    return "(" + elements + (size == 1 ? ",)" : ")");
}

std::string variables(const GradedField& field) {
    std::vector<std::string> names;
    for (GeneratorId id : field.outer()) {
        const Generator& g = field.ring->generator(id);
        const std::string name = python_name(g.name);
        names.push_back(g.kind == GeneratorKind::phase ? fmt::format("exp(I*{})", name) : name);
    }
    return "variables = " + tuple(fmt::format("{}", fmt::join(names, ", ")), names.size()) + "\n";
}

std::string dictionary(const GradedField& field, const std::string& name,
                       const std::vector<NamedSeries>& list) {
    const Ring& ring = *field.ring;
    const std::vector<GeneratorId> outer = field.outer();
    std::string text = name + " = {\n";
    for (const NamedSeries& series : list) {
        text += fmt::format("    \"{}\": {{\n", series.variable);
        for (const auto& [monomial, coefficient] : collect_in_order(ring, series.total, outer)) {
            std::vector<std::string> powers;
            for (GeneratorId id : outer) {
                const Rational power = ring.exponent_of_named(monomial, id);
                powers.push_back(cln::denominator(power) == 1
                                     ? to_string(power)
                                     : fmt::format("Rational(\"{}\")", to_string(power)));
            }
            text += fmt::format("        {}: {},\n",
                                tuple(fmt::format("{}", fmt::join(powers, ", ")), powers.size()),
                                spell(display(ring, coefficient), python_spelling()));
        }
        text += "    },\n";
    }
    return text + "}\n";
}

} // namespace

std::string normal_form_sympy(const Normalization& normalization, int order) {
    const NormalForm& normal_form = normalization.normal_form;
    const GradedField& field = *normal_form.field;
    std::string text = fmt::format("# {}\n# needs SymPy\nfrom sympy import {}\n\n",
                                   normal_form_title(normal_form, order), imported(field));
    text += symbols(field);
    text += "\n# exponents below are in this order\n" + variables(field);
    text += "\n# rates\n" + dictionary(field, "normal_form", rates_through(normal_form, order));
    text += "\n# old variable minus new one, as a function of the new ones\n";
    text += dictionary(field, "near_identity_map", map_through(normalization, order));
    return text + script_end;
}

} // namespace resonform
