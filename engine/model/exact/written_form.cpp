// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/written_form.hpp"

#include "algebra/number/number.hpp"
#include "model/text/eps_powers.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;
using Kind = ExactForm::Kind;
using Exponents = std::vector<int>; // by rank

class Writer {
public:
    explicit Writer(ExactForm& form) : form_(&form) {
        for (std::size_t k = 0; k < form.generators().size(); ++k) ranked_.push_back(k);
        std::stable_sort(ranked_.begin(), ranked_.end(), [&](std::size_t a, std::size_t b) {
            return form.generators()[a].kind < form.generators()[b].kind;
        });
    }

    std::string quotient(const ExactForm::Fraction& f) {
        if (f.numerator.is_zero()) return "0";
        if (!moves(f.denominator)) return grouped(f.numerator, f.denominator);
        return enclosed(grouped(f.numerator, 1)) + "/" +
               divisor(terms_of(f.denominator), grouped(f.denominator, 1));
    }

private:
    struct Term {
        Exponents exponents;
        numeric number;
        int pi = 0;
    };
    [[nodiscard]] const ExactForm::Generator& at(std::size_t rank) const {
        return form_->generators()[ranked_[rank]];
    }
    [[nodiscard]] bool moves(const ex& e) const {
        return std::any_of(form_->generators().begin(), form_->generators().end(),
                           [&](const auto& g) { return g.kind <= Kind::rate && e.has(g.symbol); });
    }
    static std::string enclosed(const std::string& sum) {
        return sum.find(' ') == std::string::npos ? sum : "(" + sum + ")";
    }

    Term term_of(const ex& product) const {
        Term term{Exponents(ranked_.size(), 0), 1, 0};
        const auto take = [&](const ex& base, int exponent) {
            if (GiNaC::is_a<numeric>(base)) term.number *= GiNaC::ex_to<numeric>(base).power(exponent);
            if (base.is_equal(GiNaC::Pi)) term.pi += exponent;
            for (std::size_t k = 0; k < ranked_.size(); ++k)
                if (base.is_equal(at(k).symbol)) term.exponents[k] += exponent;
        };
        const auto factor = [&](const ex& e) {
            if (GiNaC::is_a<GiNaC::power>(e))
                take(e.op(0), GiNaC::ex_to<numeric>(e.op(1)).to_int());
            else
                take(e, 1);
        };
        if (GiNaC::is_a<GiNaC::mul>(product))
            for (const ex& e : product) factor(e);
        else
            factor(product);
        return term;
    }
    // The terms in the order in which they are written.
    std::vector<Term> terms_of(const ex& polynomial) const {
        std::vector<Term> terms;
        if (GiNaC::is_a<GiNaC::add>(polynomial))
            for (const ex& e : polynomial) terms.push_back(term_of(e));
        else
            terms.push_back(term_of(polynomial));
        std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) {
            return std::make_pair(a.exponents, a.pi) > std::make_pair(b.exponents, b.pi);
        });
        return terms;
    }

    // |number| * pi * factors, those that move last.
    std::string product(const Term& term) const {
        std::vector<std::string> factors;
        const auto push = [&](const std::string& text, int exponent) {
            if (exponent != 0)
                factors.push_back(exponent == 1 ? text : text + "^" + std::to_string(exponent));
        };
        const auto push_generator = [&](const ExactForm::Generator& g, int exponent) {
            const auto eps = exponent == 0 ? std::nullopt : spell_eps_power(g.symbol, exponent);
            if (eps) // of a root of eps
                factors.push_back(*eps);
            else
                push(base(g, exponent), exponent);
        };
        if (const numeric size = GiNaC::abs(term.number); size != 1)
            factors.push_back(to_string(cln::the<cln::cl_RA>(size.to_cl_N())));
        push("pi", term.pi);
        for (int kind = static_cast<int>(Kind::eps); kind >= 0; --kind)
            for (std::size_t k = 0; k < ranked_.size(); ++k)
                if (static_cast<int>(at(k).kind) == kind) push_generator(at(k), term.exponents[k]);
        std::string text;
        for (const std::string& f : factors) text += (text.empty() ? "" : "*") + f;
        return text.empty() ? "1" : text;
    }
    // The text of a denominator, in parentheses unless it is one factor.
    static std::string divisor(const std::vector<Term>& terms, const std::string& text) {
        return terms.size() == 1 && factors(terms.front()) == 1 ? text : "(" + text + ")";
    }
    static int factors(const Term& term) {
        int count = (GiNaC::abs(term.number) == 1 ? 0 : 1) + (term.pi == 0 ? 0 : 1);
        for (const int n : term.exponents) count += n == 0 ? 0 : 1;
        return count;
    }
    static std::string base(const ExactForm::Generator& g, int exponent) {
        return exponent > 1 && g.text.back() == ')' && g.text.front() == '(' ? "(" + g.text + ")" : g.text;
    }
    static void append(std::string& sum, bool negative, const std::string& term) {
        sum += sum.empty() ? (negative ? "-" : "") : negative ? " - " : " + ";
        sum += term;
    }
    std::string sum(const std::vector<Term>& terms) const {
        std::string text;
        for (const Term& t : terms) append(text, t.number.is_negative(), product(t));
        return text;
    }

    // sqrt(s)/s is written 1/sqrt(s).
    [[nodiscard]] ExactForm::Fraction with_roots_below(ExactForm::Fraction f) const {
        for (const ExactForm::Generator& g : form_->generators()) {
            ex quotient;
            if (g.relation != ExactForm::Generator::Relation::root || g.index != 2 ||
                f.numerator.ldegree(g.symbol) == 0 || !GiNaC::divide(f.denominator, g.value, quotient) ||
                !quotient.integer_content().info(GiNaC::info_flags::integer)) // sqrt(2) stays above
                continue;
            f = {(f.numerator / g.symbol).expand(), (quotient * g.symbol).expand()};
        }
        return f;
    }

    std::string grouped(const ex& numerator, const ex& denominator);
    void append_group(std::string& text, const Exponents& monomial,
                      const ExactForm::Fraction& coefficient) const;

    ExactForm* form_;
    std::vector<std::size_t> ranked_; // indices of generators, in the order of terms
};

std::string Writer::grouped(const ex& numerator, const ex& denominator) {
    std::map<Exponents, ex, std::greater<>> groups;
    for (const Term& term : terms_of(numerator)) {
        Exponents moving = term.exponents;
        ex still = term.number * GiNaC::pow(GiNaC::Pi, term.pi);
        for (std::size_t k = 0; k < ranked_.size(); ++k) {
            if (at(k).kind <= Kind::rate) continue;
            still *= GiNaC::pow(at(k).symbol, moving[k]);
            moving[k] = 0;
        }
        groups[moving] += still;
    }
    std::string text;
    for (const auto& [monomial, still] : groups)
        append_group(text, monomial, with_roots_below(form_->fraction(still / denominator)));
    return text;
}

void Writer::append_group(std::string& text, const Exponents& monomial,
                          const ExactForm::Fraction& coefficient) const {
    std::vector<Term> terms = terms_of(coefficient.numerator);
    const std::vector<Term> below = terms_of(coefficient.denominator);
    const std::string denominator = sum(below);
    const bool one = denominator == "1";
    const bool still = std::all_of(monomial.begin(), monomial.end(), [](int n) { return n == 0; });
    if (still && one) {
        for (const Term& t : terms) append(text, t.number.is_negative(), product(t));
        return;
    }
    const bool negative = terms.front().number.is_negative();
    std::string numerator;
    if (terms.size() == 1) {
        for (std::size_t k = 0; k < monomial.size(); ++k) terms.front().exponents[k] += monomial[k];
        numerator = product(terms.front());
    } else {
        if (negative)
            for (Term& t : terms) t.number = -t.number;
        numerator = "(" + sum(terms) + ")" + (still ? "" : "*" + product({monomial, 1, 0}));
    }
    append(text, negative, numerator + (one ? "" : "/" + divisor(below, denominator)));
}

} // namespace

std::string written(ExactForm& form, const ex& e) {
    const ExactForm::Fraction f = form.fraction(e);
    return Writer(form).quotient(f);
}

} // namespace resonform
