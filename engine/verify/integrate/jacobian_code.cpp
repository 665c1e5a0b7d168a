// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/tape_code.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

namespace {

using Op = Tape::Op;

// What d(result) = left d(left operand) + right d(right operand) is in C++; "" : nothing, "1": the
// differential itself.
struct Slopes {
    std::string left, right = {};
};

Slopes slopes_of(const Tape::Instruction& s, const std::string& a, const std::string& b,
                 const std::string& result, const std::string& second) {
    switch (s.op) {
    case Op::add: return {"1", "1"};
    case Op::subtract: return {"1", "-1"};
    case Op::multiply:
    case Op::scale: return {b, a};
    case Op::square: return {"2*" + a};
    case Op::divide: return {"1/" + b, "-" + result + "/" + b};
    case Op::sqrt: return {"0.5/" + result};
    case Op::power: return {fmt::format("{0}*std::pow({1}, {0} - 1)", b, a)};
    case Op::exp: return {result};
    case Op::sin_cos:
    case Op::sinh_cosh:
    case Op::tan_secant:
    case Op::tanh_sech: return {second};
    case Op::function:
    case Op::data: return {b};
    }
    return {};
}

// Of the second result.
std::string second_slope(Op op, const std::string& result, const std::string& second) {
    switch (op) {
    case Op::sin_cos: return "-" + result;
    case Op::sinh_cosh: return result;
    case Op::tan_secant: return "2*" + result + "*" + second;
    case Op::tanh_sech: return "-2*" + result + "*" + second;
    default: return "";
    }
}

class JacobianText {
public:
    explicit JacobianText(const Tape& tape)
        : tape_(tape), constants_(names_of_constants(tape)), depends_(static_cast<std::size_t>(tape.size())) {
        for (int i = 0; i < tape_.state_count(); ++i) depends(tape_.constant_count() + i).insert(i);
    }

    std::string print() {
        std::string out =
            "extern \"C\" void rf_jacobian(const double* c, const double* u, double* matrix) {\n"
            "    (void)c; (void)u;\n";
        for (const Tape::Instruction& step : tape_.body()) out += differentiated(step);
        const int states = tape_.state_count();
        for (std::size_t i = 0; i < tape_.outputs().size(); ++i)
            for (int k = 0; k < states; ++k)
                out += fmt::format("    matrix[{}] = {};\n",
                                   static_cast<std::size_t>(k) * tape_.outputs().size() + i,
                                   derivative(tape_.outputs()[i], k));
        return out + "}\n";
    }

private:
    std::string value(int r) const {
        if (r < tape_.constant_count()) return constants_.at(r);
        const int i = r - tape_.constant_count();
        return i < tape_.state_count() ? fmt::format("u[{}]", i) : fmt::format("v{}", i);
    }
    std::set<int>& depends(int r) { return depends_[static_cast<std::size_t>(r)]; }
    std::string derivative(int r, int state) {
        if (depends(r).count(state) == 0) return "0";
        const int i = r - tape_.constant_count();
        return i < tape_.state_count() ? "1" : fmt::format("d{}_{}", i, state);
    }

    std::string differentiated(const Tape::Instruction& s) {
        std::string out = "    " + value_line(s, "const double ", [this](int r) { return value(r); });
        const std::string result = value(s.result), second = value(s.result + 1);
        const Slopes slopes = slopes_of(s, value(s.left), value(s.right), result, second);
        const std::string of_second = second_slope(s.op, result, second);
        if (!of_second.empty()) out += chained(s.result + 1, {{s.left, of_second}});
        std::vector<std::pair<int, std::string>> terms{{s.left, slopes.left}};
        if (!slopes.right.empty()) terms.emplace_back(s.right, slopes.right);
        return out + chained(s.result, terms);
    }

    // The derivatives of register r: sums of slopes times those of other registers.
    std::string chained(int r, const std::vector<std::pair<int, std::string>>& terms) {
        for (const auto& [operand, slope] : terms)
            depends(r).insert(depends(operand).begin(), depends(operand).end());
        std::string out;
        for (const int state : depends(r)) {
            std::string sum;
            for (const auto& [operand, slope] : terms)
                if (depends(operand).count(state) > 0)
                    sum +=
                        fmt::format("{}({})*{}", sum.empty() ? "" : " + ", slope, derivative(operand, state));
            out += fmt::format("    const double d{}_{} = {};\n", r - tape_.constant_count(), state, sum);
        }
        return out;
    }

    const Tape& tape_;
    std::map<int, std::string> constants_;
    std::vector<std::set<int>> depends_; // of each register: states with a derivative
};

} // namespace

std::string jacobian_text(const Tape& tape) { return JacobianText(tape).print(); }

} // namespace resonform
