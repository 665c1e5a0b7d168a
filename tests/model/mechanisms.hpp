// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism under test, and exact comparison of what is derived with what a paper prints.
#pragma once

#include "messages.hpp"
#include "model/exact/form.hpp"
#include "model/files/read_system.hpp"
#include "model/mechanics/derivation.hpp"

namespace resonform {

inline System system_named(const std::string& name) {
    return read_system(source_dir() / "systems" / name / "system.toml");
}

inline const DerivationSection& section(const std::vector<DerivationSection>& all,
                                        const std::string& heading) {
    for (const DerivationSection& s : all)
        if (s.heading == heading) return s;
    throw std::logic_error("no section " + heading);
}

inline std::string equation(const System& system, const std::string& variable) {
    for (const Equation& e : system.equations)
        if (e.variable == variable) return e.text;
    return "none";
}

// Texts over one scope of free symbols, compared identically.
class Comparison {
public:
    Comparison(const System& domain, const std::vector<std::string>& coordinates,
               const std::vector<std::string>& parameters)
        : form_(domain) {
        for (const std::string& name : coordinates)
            for (int primes = 0; primes <= 2; ++primes) {
                const GiNaC::symbol symbol(name + std::string(static_cast<std::size_t>(primes), '\''));
                scope_.define_derivative(name, primes, symbol);
                form_.add(symbol, ExactForm::Kind::coordinate);
            }
        for (const std::string& name : parameters) {
            const Parameter* known = domain.parameter(name);
            const GiNaC::symbol symbol = known == nullptr ? GiNaC::symbol(name) : known->symbol;
            scope_.define(name, symbol);
            form_.add(symbol, ExactForm::Kind::parameter);
        }
        scope_.define("eps", domain.eps);
        form_.add(domain.eps, ExactForm::Kind::eps);
        scope_.define("S", GiNaC::symbol("S"));
    }
    // Is lhs - rhs of one equation `factor` times that of the other?
    Zero same(const std::string& left, const std::string& right, const std::string& factor = "1") {
        const SourceText none;
        return form_.vanishes(read_equation(left, scope_, none) -
                              read_expression(factor, scope_, none) * read_equation(right, scope_, none));
    }

    // Is one equation, linear in `unknown`, a multiple of the other?
    Zero multiple(const std::string& left, const std::string& right, const std::string& unknown) {
        const GiNaC::ex a = read_equation(left, scope_, {}), b = read_equation(right, scope_, {});
        const auto x = GiNaC::ex_to<GiNaC::symbol>(read_expression(unknown, scope_, {}));
        return form_.vanishes(a * b.diff(x) - b * a.diff(x));
    }

private:
    ExactForm form_;
    Scope scope_;
};

} // namespace resonform
