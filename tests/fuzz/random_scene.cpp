// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/random_scene.hpp"

#include "fuzz/drawn_expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace resonform::test {

namespace {

using Texts = std::vector<std::string>;

enum class SlowLaw { none, explicit_law, relaxing, driven };
enum class Motion { oscillates, relaxes, spirals, creeps };

class SceneWriter {
public:
    SceneWriter(std::uint64_t seed, int attempt)
        : draw_(seed, static_cast<std::uint64_t>(attempt)), decays_(seed >= first_seed_of_decay) {
        if (decays_)
            write_decaying_system();
        else if (draw_.chance(8))
            write_canonical();
        else
            write_equations();
        write_drifts();
        write_plan();
    }

    [[nodiscard]] WrittenScene written() const {
        WrittenScene result;
        result.system = "[system]\nname = \"random\"\n" +
                        (parameters_.empty() ? "" : "[parameters]\n" + parameters_) + "[variables]\n" +
                        variables_ + domain_ + hamiltonian_ + "[equations]\n" + equations_ + relations_ +
                        style_;
        result.scene =
            fmt::format("order = {}\ntime_scale = {}\noutputs = [\"{}\"]\n{}[start]\n{}[verify]\neps = {}\n",
                        order_, time_scale_, fmt::join(outputs_, "\", \""),
                        fix_.empty() ? "" : "[fix]\n" + fix_, start_, ladder_);
        result.roles = roles_;
        result.order = order_;
        return result;
    }

private:
    void write_canonical();
    void write_equations();
    void write_oscillator(std::size_t k);
    void write_decaying_system();
    void write_decaying(const std::string& x, Motion motion);
    [[nodiscard]] std::string rate();
    void write_slow();
    void write_angle();
    void write_drifts();
    void write_plan();

    std::string decimal(double low, double high) { return test::decimal(draw_, low, high); }
    std::string number(double low, double high) { return test::number(draw_, low, high); }
    std::string parameter(double low, double high, bool positive);
    std::string coefficient(double low, double high);
    std::string monomial(int degree);
    std::string frequency_squared(std::size_t k);
    Texts resonant_frequencies();
    void declare(const std::string& name, const std::string& role, const std::string& more = "");
    void equation(const std::string& name, const std::string& right, const std::string& primes = "'");
    void start(const std::string& name, const std::string& value);
    void start_oscillator(const std::string& x, const std::string& velocity);

    Draw draw_;
    bool decays_;
    bool finite_ = false, from_constants_ = false, hamiltonian_style_ = false;
    SlowLaw law_ = SlowLaw::none;
    Texts fast_, states_, angles_, outputs_, frequencies_, known_;
    int count_ = 0; // of parameters
    int order_ = 1, time_scale_ = 1, most_order_ = 5;
    std::string parameters_, variables_, equations_, relations_, domain_, hamiltonian_, style_, fix_, start_,
        ladder_, roles_;
};

std::string SceneWriter::parameter(double low, double high, bool positive) {
    static const Texts transcendental = {"pi/3", "1 + log(2)/3", "exp(1/3)", "cos(1)", "sqrt(2 + sqrt(3))/2"};
    const std::string name = "k" + std::to_string(++count_);
    parameters_ += fmt::format("{} = {{{}}}\n", name, positive ? " positive = true " : "");
    const std::string sign = !positive && draw_.chance(2) ? "-" : "";
    switch (draw_.pick(4)) {
    case 0: fix_ += fmt::format("{} = \"{}({})\"\n", name, sign, number(low, high)); break;
    case 1: fix_ += fmt::format("{} = \"{}({})\"\n", name, sign, draw_.any(transcendental)); break;
    default: fix_ += fmt::format("{} = {}{}\n", name, sign, decimal(low, high));
    }
    if (positive) known_.push_back(name);
    return name;
}

std::string SceneWriter::coefficient(double low, double high) {
    static const Texts simple = {"1", "1/2", "1/3", "2/3", "3/4", "5/4"};
    static const Texts of_slow = {"s", "sqrt(1 + s^2)", "(1 + s^2)", "1/(1 + s^2)", "1/sqrt(2 + s^2)"};
    constexpr int most_parameters = 3;
    std::string c = draw_.chance(2) ? "-" : "";
    switch (draw_.pick(4)) {
    case 0: c += draw_.any(simple); break;
    case 1:
        if (count_ < most_parameters) {
            c += parameter(low, high, draw_.chance(2));
            break;
        }
        [[fallthrough]];
    default: c += number(low, high);
    }
    static const Texts functions = {"exp(-s)", "cos(2*s)", "log(2 + s^2)", "atan(s)", "tanh(s)"};
    c = "(" + c + ")";
    if (law_ != SlowLaw::none && draw_.chance(3)) c += "*" + draw_.any(decays_ ? functions : of_slow);
    return c;
}

std::string SceneWriter::monomial(int degree) {
    std::string m = coefficient(0.1, 1.5);
    for (int k = 0; k < degree && !states_.empty(); ++k) m += "*" + draw_.any(states_);
    if (!angles_.empty() && draw_.chance(3))
        m += (draw_.chance(2) ? "*sin(" : "*cos(2*") + angles_.front() + ")";
    return m;
}

void SceneWriter::declare(const std::string& name, const std::string& role, const std::string& more) {
    variables_ += fmt::format("{} = {{ role = \"{}\"{} }}\n", name, role, more);
}

void SceneWriter::equation(const std::string& name, const std::string& right, const std::string& primes) {
    equations_ += fmt::format("{0} = \"{0}{1} = {2}\"\n", name, primes, right);
}

void SceneWriter::start(const std::string& name, const std::string& value) {
    start_ += fmt::format("\"{}\" = \"{}\"\n", name, value);
}

// From constants all, or all from physical values.
void SceneWriter::start_oscillator(const std::string& x, const std::string& velocity) {
    const std::string size = finite_ ? "" : "*eps", sign = draw_.chance(2) ? "-" : "";
    if (from_constants_) {
        start("amplitude." + x, decimal(0.2, 1));
        start("phase." + x, sign + decimal(0.1, 3));
    } else {
        start(x, decimal(0.2, 1) + size);
        start(velocity, sign + decimal(0.1, 0.8) + size);
    }
}

// Two in resonance, exactly or with a detuning; or apart.
Texts SceneWriter::resonant_frequencies() {
    switch (draw_.pick(5)) {
    case 0: return {"1", "4", "9"};
    case 1: return {"1", "1", "4"};
    case 2: return {"1", "2", "5"};
    case 3: {
        const std::string first = parameter(0.7, 1.4, true);
        parameters_ += "w2 = { positive = true }\n";
        relations_ = fmt::format("[relations]\nw2 = \"{}*{} + eps*{}\"\n", draw_.chance(2) ? 2 : 1, first,
                                 decimal(0.2, 1));
        return {first + "^2", "w2^2", "7"};
    }
    default: return {number(0.7, 1.4), number(1.7, 2.4), number(3.3, 4.1)};
    }
}

std::string SceneWriter::frequency_squared(std::size_t k) {
    static const Texts of_slow = {"(1 + s^2)", "sqrt(2 + s^2)", "(2 + s)", "1/(1 + s^2)"};
    if (fast_.size() > 1) return "(" + frequencies_[k] + ")";
    if (law_ != SlowLaw::none && draw_.chance(2)) {
        const std::string text = draw_.any(of_slow);
        if (text == "(2 + s)") domain_ = "[domain]\npositive = [\"2 + s\"]\n";
        return text;
    }
    if (draw_.chance(2)) return parameter(0.6, 1.8, true) + "^2";
    return "(" + number(0.6, 1.8) + ")";
}

void SceneWriter::write_oscillator(std::size_t k) {
    const std::string& x = fast_[k];
    declare(x, "fast", finite_ ? ", weight = 0" : "");
    std::string right = fmt::format("-{}*{}", frequency_squared(k), x), less = finite_ ? "eps*" : "";
    for (int n = 1 + draw_.pick(2); n > 0; --n)
        right += " + " + less + monomial(finite_ ? 1 + draw_.pick(3) : 2 + draw_.pick(2));
    if (draw_.chance(2)) right += fmt::format(" - eps*({})*{}'", decimal(0.05, 0.8), x);
    if (draw_.chance(4)) right += " + eps^2*" + coefficient(0.1, 1.5) + "*" + x;
    if (!angles_.empty())
        right += fmt::format(" + eps{}*{}*cos({})", finite_ || draw_.chance(3) ? "" : "^2",
                             coefficient(0.1, 1.5), angles_.front());
    equation(x, right, "''");
    start_oscillator(x, x + "'");
    outputs_.push_back(x);
}

// Of a damped mode, 0.5 ... 3; it may depend on the slow variable.
std::string SceneWriter::rate() {
    static const Texts of_slow = {"(1 + s^2)", "sqrt(2 + s^2)", "(1 + exp(-s))", "(2 + cos(s))"};
    const std::string constant = "(" + number(0.5, 3) + ")";
    return law_ != SlowLaw::none && draw_.chance(3) ? constant + "*" + draw_.any(of_slow) : constant;
}

void SceneWriter::write_decaying(const std::string& x, Motion motion) {
    declare(x, "fast", finite_ ? ", weight = 0" : "");
    const std::string less = finite_ ? "eps*" : "", size = finite_ ? "" : "*eps";
    std::string right;
    if (motion == Motion::relaxes) {
        right = fmt::format("-{}*{}", rate(), x);
    } else if (motion == Motion::spirals) {
        const std::string damping = "(" + number(0.3, 1.5) + ")";
        right = fmt::format("-2*{0}*{1}' - ({0}^2 + {2})*{1}", damping, x, number(0.6, 4));
    } else {
        const std::string one = "(" + number(0.4, 1) + ")", other = "(" + number(1.3, 3) + ")";
        right = fmt::format("-({0} + {1})*{2}' - {0}*{1}*{2}", one, other, x);
    }
    for (int n = 1 + draw_.pick(2); n > 0; --n)
        right += " + " + less + monomial(finite_ ? 1 + draw_.pick(3) : 2 + draw_.pick(2));
    if (!angles_.empty() && draw_.chance(2))
        right += fmt::format(" + eps*{}*cos({})", coefficient(0.1, 1.5), angles_.front());
    equation(x, right, motion == Motion::relaxes ? "'" : "''");
    start(x, (draw_.chance(2) ? "-" : "") + decimal(0.2, 1) + size);
    if (motion != Motion::relaxes) start(x + "'", decimal(0.1, 0.8) + size);
    outputs_.push_back(x);
}

// One or two fast variables of which the last decays, all from physical values.
void SceneWriter::write_decaying_system() {
    static const std::vector<SlowLaw> laws = {SlowLaw::none, SlowLaw::explicit_law, SlowLaw::relaxing,
                                              SlowLaw::driven};
    static const std::vector<Motion> kinds = {Motion::relaxes, Motion::spirals, Motion::creeps};
    law_ = draw_.any(laws);
    finite_ = draw_.chance(2);
    if (draw_.chance(5)) angles_ = {"p"};
    fast_ = draw_.chance(3) ? Texts{"y"} : Texts{"x", "y"};
    std::vector<Motion> motions;
    for (const std::string& x : fast_) {
        const bool oscillates = x == "x" && draw_.pick(4) > 0;
        motions.push_back(oscillates ? Motion::oscillates : draw_.any(kinds));
        states_.push_back(x);
        if (motions.back() != Motion::relaxes) states_.push_back(x + "'");
    }
    frequencies_ = {number(0.7, 1.4), ""};
    for (std::size_t k = 0; k < fast_.size(); ++k)
        if (motions[k] == Motion::oscillates)
            write_oscillator(k);
        else
            write_decaying(fast_[k], motions[k]);
    write_slow();
    write_angle();
    most_order_ = fast_.size() == 1 && law_ != SlowLaw::driven ? 3 : 2;
    roles_ = fmt::format("{} {}fast, decaying{}{}", fast_.size(), finite_ ? "finite " : "",
                         law_ == SlowLaw::none ? "" : ", slow", angles_.empty() ? "" : ", angle");
}

void SceneWriter::write_slow() {
    if (law_ == SlowLaw::none) return;
    const bool positive = draw_.chance(2);
    declare("s", "slow", positive ? ", positive = true" : "");
    std::string right = "eps*(" + number(0.2, 1) + ")";
    if (law_ != SlowLaw::explicit_law) right += " - eps*(" + number(0.2, 1) + ")*s";
    if (law_ == SlowLaw::driven)
        right += " + eps*" + monomial(1 + draw_.pick(2)) +
                 (finite_ || states_.empty() || draw_.chance(2) ? "" : " + " + monomial(2));
    if (fast_.empty()) right += " + eps*" + coefficient(0.1, 0.8) + "*cos(p)";
    equation("s", right);
    start("s", decimal(0.3, 1.5));
    if (law_ != SlowLaw::explicit_law || fast_.empty()) outputs_.push_back("s");
}

// Of constant frequency beside an oscillator: one that moves would pass through resonances.
void SceneWriter::write_angle() {
    if (angles_.empty()) return;
    static const Texts of_slow = {"1 + s^2", "2 + s", "s", "sqrt(1 + s^2)"};
    declare("p", "angle");
    std::string right = fast_.empty() ? draw_.any(of_slow) : "(" + number(0.5, 2.5) + ")";
    if (right == "2 + s") domain_ = "[domain]\npositive = [\"2 + s\"]\n";
    if (draw_.chance(3)) right += " + eps*" + coefficient(0.1, 0.8) + "*sin(p)";
    equation("p", right);
    start("p", decimal(0.1, 3));
}

void SceneWriter::write_equations() {
    const int kind = draw_.pick(10); // how many fast variables
    const int fast = kind == 0 ? 0 : kind < 6 ? 1 : kind < 9 ? 2 : 3;
    static const std::vector<SlowLaw> laws = {SlowLaw::none, SlowLaw::none, SlowLaw::explicit_law,
                                              SlowLaw::relaxing, SlowLaw::driven};
    law_ = fast == 0 ? draw_.any(std::vector<SlowLaw>{SlowLaw::explicit_law, SlowLaw::relaxing})
           : fast > 1 && draw_.chance(2) ? SlowLaw::none
                                         : draw_.any(laws);
    finite_ = fast > 0 && draw_.chance(4);
    from_constants_ = draw_.chance(2);
    if (fast == 0 || draw_.chance(5)) angles_ = {"p"};
    for (int k = 0; k < fast; ++k) fast_.push_back(Texts{"x", "y", "z"}[static_cast<std::size_t>(k)]);
    for (const std::string& x : fast_) states_.insert(states_.end(), {x, x + "'"});
    if (fast > 1) frequencies_ = resonant_frequencies();
    for (std::size_t k = 0; k < fast_.size(); ++k) write_oscillator(k);
    write_slow();
    write_angle();
    const bool flow =
        finite_ || fast != 1 || !angles_.empty() || law_ == SlowLaw::relaxing || law_ == SlowLaw::driven;
    most_order_ = !flow ? 5 : fast == 3 ? 1 : fast == 2 || law_ == SlowLaw::driven ? 2 : 3;
    roles_ = fmt::format("{} {}fast{}{}", fast, finite_ ? "finite " : "",
                         law_ == SlowLaw::none           ? ""
                         : law_ == SlowLaw::explicit_law ? ", slow"
                         : law_ == SlowLaw::relaxing     ? ", relaxing slow"
                                                         : ", driven slow",
                         angles_.empty() ? "" : ", angle");
}

// One or two canonical pairs.
void SceneWriter::write_canonical() {
    const bool two = draw_.chance(2);
    fast_ = two ? Texts{"x", "y"} : Texts{"x"};
    frequencies_ =
        two ? resonant_frequencies() : Texts{draw_.chance(2) ? parameter(0.6, 1.8, true) : number(0.6, 1.8)};
    std::string energy, momenta;
    for (std::size_t k = 0; k < fast_.size(); ++k) {
        const std::string& x = fast_[k];
        energy += fmt::format("{}(p{}^2 + ({})*{}^2)/2", k == 0 ? "" : " + ", x, frequencies_[k], x);
        momenta += fmt::format("{}{} = \"p{}\"", k == 0 ? "" : ", ", x, x);
        states_.insert(states_.end(), {x, "p" + x});
        declare(x, "fast");
        declare("p" + x, "fast");
        start_oscillator(x, "p" + x);
        outputs_.push_back(x);
    }
    for (int n = 1 + draw_.pick(2); n > 0; --n) energy += " + " + monomial(3 + draw_.pick(2));
    hamiltonian_ = fmt::format("[hamiltonian]\nenergy = \"{}\"\nmomenta = {{ {} }}\n", energy, momenta);
    hamiltonian_style_ = relations_.empty() && draw_.chance(2);
    if (hamiltonian_style_) style_ = "[normal_form]\nstyle = \"hamiltonian\"\n";
    most_order_ = two ? 2 : 4;
    roles_ = fmt::format("{} canonical", fast_.size());
}

void SceneWriter::write_drifts() {
    const int drifts = hamiltonian_style_ ? 0 : draw_.pick(3);
    for (int k = 0; k < drifts; ++k) {
        const std::string name = "d" + std::to_string(k + 1);
        declare(name, "drift");
        std::string right = "eps*" + monomial(draw_.pick(3));
        if (!finite_ && !states_.empty() && draw_.chance(2)) right += " + " + monomial(1 + draw_.pick(2));
        if (!known_.empty() && draw_.chance(3))
            right = fmt::format("({})/{}^{}", right, draw_.any(known_), 1 + draw_.pick(19));
        equation(name, right);
        start(draw_.chance(2) && hamiltonian_.empty() ? name : "constant." + name, decimal(0.1, 2));
        outputs_.push_back(name);
    }
    if (drifts > 0) roles_ += drifts == 1 ? ", drift" : ", 2 drifts";
}

void SceneWriter::write_plan() {
    order_ = 1 + draw_.pick(most_order_);
    const bool long_times = law_ == SlowLaw::none && angles_.empty() && draw_.chance(8);
    time_scale_ = long_times ? 2 : draw_.chance(10) ? 0 : 1;
    ladder_ = long_times ? "[0.1, 0.05, 0.04, 0.025]" : "[0.05, 0.02, 0.01, 0.005]";
    while (outputs_.size() > 1 && draw_.chance(4))
        outputs_.erase(outputs_.begin() + draw_.pick(static_cast<int>(outputs_.size())));
}

} // namespace

WrittenScene random_scene(std::uint64_t seed, int attempt) { return SceneWriter(seed, attempt).written(); }

} // namespace resonform::test
