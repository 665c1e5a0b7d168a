// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/tape_code.hpp"

#include "algebra/number/functions.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>

namespace resonform {

namespace {

using Op = Tape::Op;

// rf_data_omega(derivative, x): what runtime/spline.hpp computes.
std::string data_text(const Tape& tape) {
    std::set<std::string> names;
    std::string out;
    for (const Tape::Data& data : tape.data()) {
        const PiecewisePolynomial& samples = *data.samples;
        if (!names.insert(samples.name).second) continue;
        const auto list = [](const std::vector<double>& numbers) {
            std::string text;
            for (const double x : numbers) text += fmt::format("{:a}, ", x);
            return text;
        };
        out += fmt::format(
            "double rf_data_{}(int derivative, double x) {{\n"
            "    static constexpr double breakpoints[] = {{{}}}, coefficients[] = {{{}}};\n"
            "    return resonform::Spline{{breakpoints, coefficients, {}, {}}}.at(derivative, x);\n}}\n",
            samples.name, list(samples.breakpoints), list(samples.coefficients), samples.pieces(),
            samples.degree);
    }
    return out;
}

std::string rates_text(const Tape& tape) {
    const std::map<int, std::string> constants = names_of_constants(tape);
    const auto value = [&](int r) {
        if (r < tape.constant_count()) return constants.at(r);
        const int i = r - tape.constant_count();
        return i < tape.state_count() ? fmt::format("u[{}]", i) : fmt::format("v{}", i);
    };
    std::string out = "extern \"C\" void rf_rates(const double* c, const double* u, double* rates) {\n"
                      "    (void)c; (void)u;\n";
    for (const Tape::Instruction& step : tape.body())
        out += "    " + value_line(step, "const double ", value);
    for (std::size_t i = 0; i < tape.outputs().size(); ++i)
        out += fmt::format("    rates[{}] = {};\n", i, value(tape.outputs()[i]));
    return out + "}\n";
}

} // namespace

std::string value_line(const Tape::Instruction& s, const std::string& type,
                       const std::function<std::string(int)>& value) {
    const std::string a = value(s.left), b = value(s.right), to = type + value(s.result) + " = ";
    const auto second = [&](const std::string& text) {
        return "    " + type + value(s.result + 1) + " = " + text + ";\n";
    };
    const auto call = [&](std::string_view f) { return fmt::format("{}std::{}({});\n", to, f, a); };
    const std::string result = value(s.result);
    switch (s.op) {
    case Op::add: return to + a + " + " + b + ";\n";
    case Op::subtract: return to + a + " - " + b + ";\n";
    case Op::multiply:
    case Op::scale: return to + a + "*" + b + ";\n";
    case Op::square: return to + a + "*" + a + ";\n";
    case Op::divide: return to + a + "/" + b + ";\n";
    case Op::sqrt: return call("sqrt");
    case Op::power: return to + "std::pow(" + a + ", " + b + ");\n";
    case Op::exp: return call("exp");
    case Op::sin_cos: return call("sin") + second("std::cos(" + a + ")");
    case Op::sinh_cosh: return call("sinh") + second("std::cosh(" + a + ")");
    case Op::tan_secant: return call("tan") + second("1 + " + result + "*" + result);
    case Op::tanh_sech: return call("tanh") + second("1 - " + result + "*" + result);
    case Op::function: return call(row_of(s.function).name);
    case Op::data: return fmt::format("{}rf_data_{}({}, {});\n", to, s.data->name, s.derivative, a);
    }
    return "";
}

std::map<int, std::string> names_of_constants(const Tape& tape) {
    std::map<int, std::string> names;
    for (int r = 0; r < tape.constant_count(); ++r) names[r] = fmt::format("c[{}]", r);
    for (const Tape::Number& number : tape.numbers()) // longer ones are rounded when they are bound
        if (number.value[1] == 0) names[number.target] = fmt::format("({:a})", number.value[0]);
    return names;
}

std::string emit_tape(const Tape& tape) {
    std::string inverses;
    for (int n = 0; n <= highest_jet_order + 1; ++n)
        inverses += fmt::format("{:a}, ", n == 0 ? 0.0 : 1.0 / n);
    return std::string(tape.data().empty() ? "" : "#include \"runtime/spline.hpp\"\n") +
           "#include <cmath>\n\nnamespace {\nconstexpr double inverse[] = {" + inverses + "};\n" +
           data_text(tape) + "} // namespace\n\n" + rates_text(tape) + "\n" + jacobian_text(tape) + "\n" +
           jet_text(tape);
}

} // namespace resonform
