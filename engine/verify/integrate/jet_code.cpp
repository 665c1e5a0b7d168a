// SPDX-License-Identifier: GPL-3.0-or-later
// The text of rf_jet.
#include "verify/integrate/tape.hpp"
#include "verify/integrate/tape_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace resonform {

namespace {

using Op = Tape::Op;
using Instruction = Tape::Instruction;

constexpr int unbounded = jet_pad + 1; // stands for: no polynomial, or one of high degree
constexpr std::size_t sums_of_one_loop = 8;

int degree_of(const Instruction& step, const std::vector<int>& degrees) {
    const int left = degrees[static_cast<std::size_t>(step.left)];
    const int right = degrees[static_cast<std::size_t>(step.right)];
    switch (step.op) {
    case Op::add:
    case Op::subtract: return std::max(left, right);
    case Op::multiply:
    case Op::scale: return left + right;
    case Op::square: return 2 * left;
    case Op::divide: return right == 0 ? left : unbounded;
    default: return left == 0 ? 0 : unbounded;
    }
}

// The degree in t of every value, as far as the equations show it.
std::vector<int> degrees_in_time(const Tape& tape) {
    std::vector<int> degrees(static_cast<std::size_t>(tape.size()), unbounded);
    std::fill_n(degrees.begin(), tape.constant_count(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (const Instruction& step : tape.body()) {
            const int degree = std::min(unbounded, degree_of(step, degrees));
            degrees[static_cast<std::size_t>(step.result)] = degree;
            if (has_two_results(step.op)) degrees[static_cast<std::size_t>(step.result) + 1] = degree;
        }
        for (std::size_t i = 0; i < tape.outputs().size(); ++i) {
            int& state = degrees[static_cast<std::size_t>(tape.constant_count()) + i];
            const int rate = degrees[static_cast<std::size_t>(tape.outputs()[i])];
            if (rate + 1 >= state) continue;
            state = rate + 1;
            changed = true;
        }
    }
    return degrees;
}

// Text of a jet at one order n: sums over products of lower coefficients first, all in one loop, then the
// coefficients one after the other.
class JetText {
public:
    explicit JetText(const Tape& tape)
        : tape_(tape), constants_(names_of_constants(tape)), degrees_(degrees_in_time(tape)) {
        for (const Instruction& step : tape.body()) coefficient(step);
    }

    [[nodiscard]] std::size_t rows() const {
        return static_cast<std::size_t>(tape_.size() - tape_.constant_count()) + weighted_.size();
    }

    [[nodiscard]] std::string text() const {
        std::string out =
            "extern \"C\" void rf_jet(const double* c, int order, double* rows) {\n    (void)c;\n";
        for (int r = tape_.constant_count(); r < tape_.size(); ++r)
            out += row_line(name(r), r - tape_.constant_count());
        for (const auto& [r, at] : weighted_) out += row_line(weighted_name(r), at);
        const auto first = [this](int r) { return at(r, "0"); };
        for (const Instruction& step : tape_.body()) out += "    " + value_line(step, "", first);
        out += inverses_;
        for (std::size_t i = 0; i < tape_.outputs().size(); ++i)
            out += fmt::format("    {}[1] = {};\n", state(i), at(tape_.outputs()[i], "0"));
        out += "    for (int n = 1; n < order; ++n) {\n        const double m = n, im = inverse[n], next = "
               "inverse[n + 1];\n"
               "        (void)m; (void)im;\n";
        for (int i = 0; i < tape_.state_count(); ++i) out += weight_line(tape_.constant_count() + i);
        out += full_sums() + half_sums();
        for (const auto& [r, line] : lines_) out += line + weight_line(r);
        for (std::size_t i = 0; i < tape_.outputs().size(); ++i)
            if (degree(tape_.outputs()[i]) > 0)
                out += fmt::format("        {}[n + 1] = next*{};\n", state(i), at(tape_.outputs()[i], "n"));
        return out + "    }\n}\n";
    }

private:
    [[nodiscard]] bool constant(int r) const { return r < tape_.constant_count(); }
    [[nodiscard]] int degree(int r) const { return degrees_[static_cast<std::size_t>(r)]; }
    [[nodiscard]] bool polynomial(int r) const { return degree(r) < unbounded; }
    [[nodiscard]] static std::string name(int r) { return fmt::format("r{}", r); }
    [[nodiscard]] static std::string weighted_name(int r) { return fmt::format("d{}", r); }
    [[nodiscard]] std::string state(std::size_t i) const {
        return name(tape_.constant_count() + static_cast<int>(i));
    }
    [[nodiscard]] static std::string row_line(const std::string& row, int at) {
        return fmt::format("    double* const {} = rows + {};\n", row,
                           static_cast<std::size_t>(at) * jet_stride + jet_pad);
    }
    // Coefficient `n` of a register; a constant has its value for coefficient 0.
    [[nodiscard]] std::string at(int r, const std::string& n) const {
        if (constant(r)) return n == "0" ? constants_.at(r) : "0.0";
        return fmt::format("{}[{}]", name(r), n);
    }

    // A row of j a_j, wherever j a_j is summed up.
    std::string weighted(int r) {
        weighted_.try_emplace(r, tape_.size() - tape_.constant_count() + static_cast<int>(weighted_.size()));
        return weighted_name(r);
    }
    // sum_{j=1}^{n-1} a_j b_{n-j}, ready when the order begins.
    std::string full(const std::string& a, const std::string& b) {
        full_.emplace_back(a, b);
        return fmt::format("s{}", full_.size() - 1);
    }
    // sum_{j=1}^{n-1} a_j a_{n-j}
    std::string half(int a) {
        half_.push_back(name(a));
        return fmt::format("h{}", half_.size() - 1);
    }
    // sum_{j=1}^{degree of a} factor(j) a_j b_{n-j}
    template <class Factor>
    [[nodiscard]] std::string short_sum(int a, const std::string& b, const Factor& factor) const {
        std::string out;
        for (int j = 1; j <= degree(a); ++j)
            out += fmt::format("{}{}{}*{}[n - {}]", j == 1 ? "" : " + ", factor(j), at(a, std::to_string(j)),
                               b, j);
        return out.empty() ? "0.0" : "(" + out + ")";
    }
    [[nodiscard]] std::string short_sum(int a, const std::string& b) const {
        return short_sum(a, b, [](int) { return std::string(); });
    }
    // sum_{j=1}^{n} j a_j b_{n-j}; b is another register than a, or a constant.
    std::string derivative_sum(int a, int b) {
        if (constant(b)) return fmt::format("(m*{}*{})", at(a, "n"), at(b, "0"));
        if (polynomial(a))
            return short_sum(a, name(b), [](int j) { return j == 1 ? "" : fmt::format("{}.0*", j); });
        return fmt::format("({} + m*{}*{})", full(weighted(a), name(b)), at(a, "n"), at(b, "0"));
    }
    // 1/x for the leading coefficient of a divisor, once in each expansion.
    std::string inverse(const std::string& divisor) {
        const auto [found, fresh] =
            inverse_names_.try_emplace(divisor, fmt::format("i{}", inverse_names_.size()));
        if (fresh) inverses_ += fmt::format("    const double {} = 1/({});\n", found->second, divisor);
        return found->second;
    }

    void product(const Instruction& s) {
        const int a = degree(s.left) <= degree(s.right) ? s.left : s.right,
                  b = a == s.left ? s.right : s.left;
        if (polynomial(a)) // b_{n-j} is zero for j > n
            return set(s.result,
                       at(a, "0") + "*" + at(b, "n") + (degree(a) == 0 ? "" : " + " + short_sum(a, name(b))));
        set(s.result, fmt::format("{} + {}*{} + {}*{}", full(name(a), name(b)), at(a, "0"), at(b, "n"),
                                  at(a, "n"), at(b, "0")));
    }
    void quotient(const Instruction& s) {
        const std::string rest = polynomial(s.right)
                                     ? short_sum(s.right, name(s.result))
                                     : fmt::format("({} + {}*{})", full(name(s.right), name(s.result)),
                                                   at(s.right, "n"), at(s.result, "0"));
        set(s.result, fmt::format("({} - {})*{}", at(s.left, "n"), rest, inverse(at(s.right, "0"))));
    }
    // n a_0 p_n = sum_{j=1}^n (j e - (n - j)) a_j p_{n-j} of p = a^e
    void power(const Instruction& s, const std::string& e) {
        const std::string scale = "*" + inverse(at(s.left, "0")) + "*im";
        if (polynomial(s.left))
            return set(s.result, short_sum(s.left, name(s.result), [&](int j) {
                                     return fmt::format("({}.0*({} + 1) - m)*", j, e);
                                 }) + scale);
        const std::string lower = full(name(s.left), name(s.result));
        set(s.result,
            fmt::format("(({} + 1)*{} - m*{} + {}*m*{}*{})", e, full(weighted(s.left), name(s.result)), lower,
                        e, at(s.left, "n"), at(s.result, "0")) +
                scale);
    }
    void square_root(const Instruction& s) {
        if (polynomial(s.left)) return power(s, "0.5");
        set(s.result,
            fmt::format("({} - {})*{}", at(s.left, "n"), half(s.result), inverse("2*" + at(s.result, "0"))));
    }
    void square(int a, int result, const std::string& sign) {
        set(result, polynomial(a) ? at(a, "0") + "*" + at(a, "n") + " + " + short_sum(a, name(a))
                                  : fmt::format("{}({} + 2*{}*{})", sign, half(a), at(a, "0"), at(a, "n")));
    }
    // s' = a' f, c' = sign a' g
    void pair(const Instruction& s, const std::string& sign) {
        const std::string first = derivative_sum(s.left, s.result + 1),
                          second = derivative_sum(s.left, s.result);
        set(s.result, first + "*im");
        set(s.result + 1, sign + second + "*im");
    }
    void with_square(const Instruction& s, const std::string& sign) {
        set(s.result, derivative_sum(s.left, s.result + 1) + "*im");
        square(s.result, s.result + 1, sign);
    }
    void coefficient(const Instruction& s) {
        switch (s.op) {
        case Op::add: return set(s.result, at(s.left, "n") + " + " + at(s.right, "n"));
        case Op::subtract: return set(s.result, at(s.left, "n") + " - " + at(s.right, "n"));
        case Op::multiply:
        case Op::scale: return product(s);
        case Op::square: return square(s.left, s.result, "");
        case Op::divide: return quotient(s);
        case Op::sqrt: return square_root(s);
        case Op::power: return power(s, at(s.right, "0"));
        case Op::exp: return set(s.result, derivative_sum(s.left, s.result) + "*im");
        case Op::sin_cos: return pair(s, "-");
        case Op::sinh_cosh: return pair(s, "");
        case Op::tan_secant: return with_square(s, "");
        case Op::tanh_sech: return with_square(s, "-");
        case Op::function:
        case Op::data: return set(s.result, derivative_sum(s.left, s.right) + "*im");
        }
    }

    void set(int r, const std::string& value) {
        if (degree(r) == 0) return;
        const std::string guard = polynomial(r) ? fmt::format("if (n <= {}) ", degree(r)) : "";
        lines_.emplace_back(r, fmt::format("        {}{}[n] = {};\n", guard, name(r), value));
    }
    [[nodiscard]] std::string weight_line(int r) const {
        return weighted_.count(r) == 0 ? ""
                                       : fmt::format("        {}[n] = m*{}[n];\n", weighted_name(r), name(r));
    }

    // The sums of one order, several in one loop.
    [[nodiscard]] std::string full_sums() const {
        std::string out;
        for (std::size_t begin = 0; begin < full_.size(); begin += sums_of_one_loop) {
            std::string declared, summed;
            for (std::size_t k = begin; k < std::min(full_.size(), begin + sums_of_one_loop); ++k) {
                declared += fmt::format("{}s{} = 0", k == begin ? "" : ", ", k);
                summed +=
                    fmt::format("            s{} += {}[j]*{}[n - j];\n", k, full_[k].first, full_[k].second);
            }
            out += fmt::format("        double {};\n        for (int j = 1; j < n; ++j) {{\n{}        }}\n",
                               declared, summed);
        }
        return out;
    }
    [[nodiscard]] std::string half_sums() const {
        std::string out;
        for (std::size_t k = 0; k < half_.size(); ++k)
            out += fmt::format(
                "        double h{0} = 0;\n        for (int j = 1; 2*j < n; ++j) h{0} += {1}[j]*{1}[n - j];\n"
                "        h{0} += h{0};\n        if (n % 2 == 0) h{0} += {1}[n/2]*{1}[n/2];\n",
                k, half_[k]);
        return out;
    }

    const Tape& tape_;
    std::map<int, std::string> constants_;
    std::vector<int> degrees_;
    std::map<int, int> weighted_; // register -> row
    std::vector<std::pair<std::string, std::string>> full_;
    std::vector<std::string> half_;
    std::map<std::string, std::string> inverse_names_;
    std::string inverses_;
    std::vector<std::pair<int, std::string>> lines_; // register -> its coefficient n
};

} // namespace

std::size_t jet_rows(const Tape& tape) { return JetText(tape).rows(); }

std::string jet_text(const Tape& tape) { return JetText(tape).text(); }

} // namespace resonform
