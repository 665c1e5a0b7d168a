// SPDX-License-Identifier: GPL-3.0-or-later
// SymPy as a second judge: the script runs and agrees with the example; every coefficient string of the
// JSON has the value of its polynomial at random rational points.
#include "emit/derive/derive.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "model/system/names.hpp"
#include "printed.hpp"
#include "support/shell.hpp"

#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <sstream>

namespace resonform::test {
namespace {

constexpr const char* compare_with_example = R"(
import json, sys
import script
from sympy import simplify, sympify
example = json.load(open(sys.argv[1]))
names = {s: getattr(script, s) for s in ("g", "r", "v", "xi")}
order = [str(s) for s in script.variables]
seen = 0
for entry in example["normal_form"]:
    key = tuple(entry["exponents"].get(name, 0) for name in order)
    ours = script.normal_form[entry["variable"]].pop(key)
    theirs = sympify(entry["coefficient"], locals=names)
    assert simplify(ours - theirs) == 0, (entry, ours)
    values = {names["g"]: 2, names["r"]: 3, names["v"]: -5, names["xi"]: 7}
    assert abs((ours - theirs).subs(values).evalf(30)) < 1e-25
    seen += 1
assert seen == 11 and not any(script.normal_form.values())
print("same")
)";

TEST(SympyScript, RunsAndEqualsTheExample) {
    const Scratch scratch;
    write(scratch.path() / "script.py", print_normal_form(*pendulum(3), 3, Format::sympy));
    write(scratch.path() / "judge.py", compare_with_example);
    const auto example = source_dir() / "tests" / "emit" / "almost_holonomic_pendulum_order_3.json";
    const Outcome outcome = run("python3 judge.py '" + example.string() + "'", scratch.path());
    EXPECT_EQ(outcome.out, "same\n") << outcome.err;
    const Outcome printed = run("python3 script.py", scratch.path());
    EXPECT_EQ(printed.code, 0) << printed.err;
    EXPECT_NE(printed.out.find("x: old = new + "), std::string::npos) << printed.out;
}

TEST(SympyScript, NamesThatTheScriptUses) {
    const Scratch scratch;
    const auto normalization = certified(field_with_odd_names("series"), 3);
    write(scratch.path() / "script.py", print_normal_form(*normalization, 3, Format::sympy));
    const Outcome outcome = run("python3 script.py", scratch.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("sum' = "), std::string::npos) << outcome.out;
}

// The names that a system file may have are those that SymPy takes as locals.
TEST(Sympy, TakesEveryNameThatAFileMayHave) {
    std::string names;
    for (const char* name :
         {"S",   "N",        "O",        "Q",     "C",    "e",    "j",       "beta",  "gamma",  "zeta",
          "re",  "im",       "print",    "match", "case", "type", "_Matrix", "Float", "Symbol", "series",
          "sum", "Rational", "Function", "var",   "self", "exec", "id",      "len"})
        if (is_identifier(name) && !is_reserved(name)) names += std::string(" ") + name;
    EXPECT_NE(names.find(" Rational"), std::string::npos);
    const Scratch scratch;
    write(scratch.path() / "judge.py", R"py(
import keyword, sys
from sympy import Symbol, sympify
for name in sys.argv[1:]:
    text = f"-I*{name}**3*(2*{name}**2 + 5)/(128*(r**2 + {name})**(5/2))"
    value = sympify(text, locals={name: Symbol(name), "r": Symbol("r")})
    assert value.free_symbols == {Symbol(name), Symbol("r")}, name
print(" ".join(keyword.kwlist))
)py");
    const Outcome outcome = run("python3 judge.py" + names, scratch.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream keywords(outcome.out);
    for (std::string word; keywords >> word;) EXPECT_TRUE(is_reserved(word)) << word;
}

// A polynomial's value, its roots taken numerically: nothing of the printers is used.
class Evaluation {
public:
    Evaluation(const Ring& ring, std::map<std::string, Rational> values)
        : ring_(ring), values_(std::move(values)) {}

    [[nodiscard]] std::complex<long double> operator()(const Polynomial& p) const {
        std::complex<long double> sum = 0;
        for (const Term& term : p.terms()) {
            std::complex<long double> product = to_double(term.coefficient);
            for (GeneratorId id = 0; id < ring_.size(); ++id)
                for (int e = ring_.exponent(term.monomial, id); e != 0; e += e > 0 ? -1 : 1)
                    product = e > 0 ? product * generator(id) : product / generator(id);
            sum += product;
        }
        return sum;
    }

private:
    [[nodiscard]] std::complex<long double> generator(GeneratorId id) const {
        const Generator& g = ring_.generator(id);
        if (g.kind == GeneratorKind::imaginary) return {0, 1};
        if (g.kind == GeneratorKind::root)
            return std::pow((*this)(g.radicand).real(), 1.0L / static_cast<long double>(g.index));
        return static_cast<long double>(to_double(values_.at(g.name)));
    }

    const Ring& ring_;
    std::map<std::string, Rational> values_;
};

struct Sample {
    std::string expression;
    std::map<std::string, Rational> values;
    std::complex<long double> expected;
};

std::vector<Sample> samples_of(const Normalization& normalization, int order, std::mt19937& random) {
    const GradedField& field = *normalization.normal_form.field;
    const Ring& ring = *field.ring;
    std::vector<NamedSeries> all = rates_through(normalization.normal_form, order);
    for (NamedSeries& series : map_through(normalization, order)) all.push_back(std::move(series));
    std::vector<Sample> samples;
    for (const NamedSeries& series : all)
        for (const auto& [monomial, coefficient] : ring.collect(series.total, field.outer())) {
            std::map<std::string, Rational> values;
            for (GeneratorId id = 0; id < ring.size(); ++id)
                if (const auto kind = ring.generator(id).kind;
                    kind == GeneratorKind::parameter || kind == GeneratorKind::slow)
                    values[ring.generator(id).name] = Rational(1 + static_cast<int>(random() % 40)) / 8;
            samples.push_back(
                {json_expression(ring, coefficient), values, Evaluation(ring, values)(coefficient)});
        }
    return samples;
}

constexpr const char* evaluate = R"(
import json
from sympy import Rational, Symbol, sympify
worst = 0
for sample in json.load(open("samples.json")):
    symbols = {name: Symbol(name) for name in sample["values"]}
    value = sympify(sample["expression"], locals=symbols)
    assert value.free_symbols <= set(symbols.values()), sample["expression"]
    at = complex(value.subs({symbols[n]: Rational(v) for n, v in sample["values"].items()}).evalf(30))
    expected = complex(sample["re"], sample["im"])
    worst = max(worst, abs(at - expected)/max(abs(expected), 1e-3))
assert worst < 1e-12, worst
print("equal")
)";

void check_strings(const Normalization& normalization, int order, std::size_t at_least) {
    std::mt19937 random(20261121);
    Json list = Json::array();
    for (const Sample& sample : samples_of(normalization, order, random)) {
        Json values = Json::object();
        for (const auto& [name, value] : sample.values) values[name] = to_string(value);
        list.push_back({{"expression", sample.expression},
                        {"values", values},
                        {"re", static_cast<double>(sample.expected.real())},
                        {"im", static_cast<double>(sample.expected.imag())}});
    }
    EXPECT_GE(list.size(), at_least);
    const Scratch scratch;
    write(scratch.path() / "samples.json", list.dump());
    write(scratch.path() / "judge.py", evaluate);
    const Outcome outcome = run("python3 judge.py", scratch.path());
    EXPECT_EQ(outcome.out, "equal\n") << outcome.err;
}

TEST(JsonStrings, HaveTheValuesOfTheirPolynomials) { check_strings(*pendulum(5), 5, 60); }

TEST(JsonStrings, NamesThatSympyOwnsToo) {
    const auto normalization = certified(field_with_odd_names("gamma"), 4);
    EXPECT_EQ(normal_form_json(*normalization, 4)["fast"][0]["eigenvalue"], "I*(tau**2 + lambda1)**(1/2)");
    check_strings(*normalization, 4, 10);
}

} // namespace
} // namespace resonform::test
