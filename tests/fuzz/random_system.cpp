// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/random_system.hpp"

#include "fuzz/drawn_expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace resonform::test {

namespace {

using Texts = std::vector<std::string>;

constexpr std::uint64_t stream_of_systems = 77'777'777; // beyond the attempts at random scenes

enum class Linear { oscillates, relaxes, spirals, creeps, grows, saddle, unwinds, critical, ring };

// At eps = 0, without slow variables; in 96ths.
const std::vector<std::pair<Linear, int>> linear_parts = {
    {Linear::oscillates, 40}, {Linear::relaxes, 17}, {Linear::spirals, 13},
    {Linear::creeps, 8},      {Linear::grows, 8},    {Linear::saddle, 4},
    {Linear::unwinds, 4},     {Linear::critical, 1}, {Linear::ring, 1}};

struct Fast {
    std::string name;
    Linear linear;
    std::string weight; // "0", "1", "2", "1/2"
    [[nodiscard]] bool second_order() const {
        return linear != Linear::relaxes && linear != Linear::grows && linear != Linear::ring;
    }
    [[nodiscard]] bool decays() const {
        return linear == Linear::relaxes || linear == Linear::spirals || linear == Linear::creeps;
    }
    [[nodiscard]] bool lasts() const { return linear == Linear::oscillates; }
    [[nodiscard]] bool grows() const {
        return linear == Linear::grows || linear == Linear::saddle || linear == Linear::unwinds;
    }
};

class SystemWriter {
public:
    explicit SystemWriter(std::uint64_t seed) : draw_(seed, stream_of_systems) {
        draw_fast();
        draw_names();
        for (std::size_t k = 0; k < fast_.size(); ++k) write_fast(k);
        for (const std::string& s : slow_) write_slow(s);
        for (const std::string& p : angles_) write_angle(p);
        write_drifts();
        write_scene();
    }
    [[nodiscard]] WrittenScene written() const;

private:
    void draw_fast();
    void draw_names();
    void write_fast(std::size_t k);
    void write_slow(const std::string& s);
    void write_angle(const std::string& p);
    void write_drifts();
    void write_scene();

    std::string linear_part(std::size_t k);
    std::string frequency_squared(std::size_t k);
    std::string rate();
    std::string moving(const std::string& constant);
    std::string nonlinear_terms(const Fast& of);
    std::string forces(const Fast& of);
    std::string monomial(int degree);
    std::string positive_parameter();

    int count(const std::vector<int>& chances); // k with the chance chances[k]/sum
    std::string constant(double low, double high) { return "(" + number(draw_, low, high) + ")"; }
    std::string coefficient() { return drawn_coefficient(draw_, names_, 0.1, 1.5); }
    bool any(bool (Fast::*which)() const) const {
        return std::any_of(fast_.begin(), fast_.end(), [&](const Fast& f) { return (f.*which)(); });
    }
    void declare(const std::string& name, const std::string& role, const std::string& more = "") {
        variables_ += fmt::format("{} = {{ role = \"{}\"{} }}\n", name, role, more);
    }
    void equation(const std::string& name, const std::string& primes, const std::string& right) {
        equations_ += fmt::format("{0} = \"{0}{1} = {2}\"\n", name, primes, right);
    }
    void start(const std::string& name, const std::string& value) {
        start_ += fmt::format("\"{}\" = \"{}\"\n", name, value);
    }

    Draw draw_;
    std::vector<Fast> fast_;
    Names names_;
    Texts slow_, angles_, states_, outputs_, frequencies_;
    std::size_t drifts_ = 0, parameters_count_ = 0;
    std::string parameters_, functions_, variables_, equations_, relations_, fix_, bound_, start_, scene_;
    int order_ = 1;
};

int SystemWriter::count(const std::vector<int>& chances) {
    int sum = 0;
    for (const int c : chances) sum += c;
    int left = draw_.pick(sum), k = 0;
    while (left >= chances[static_cast<std::size_t>(k)]) left -= chances[static_cast<std::size_t>(k++)];
    return k;
}

void SystemWriter::draw_fast() {
    static const Texts names = {"x", "y", "z", "u"};
    const int n = count({1, 7, 7, 4, 1}), kind = count({24, 11, 4, 1});
    std::vector<int> chances;
    for (const auto& part : linear_parts) chances.push_back(part.second);
    for (int k = 0; k < n; ++k) {
        static const Texts mixed = {"0", "1", "2"};
        const Linear linear = linear_parts[static_cast<std::size_t>(count(chances))].first;
        const std::string weight = kind == 0 ? "1" : kind == 1 ? "0" : kind == 2 ? draw_.any(mixed) : "1/2";
        fast_.push_back({names[static_cast<std::size_t>(k)], linear, weight});
    }
    if (std::any_of(fast_.begin(), fast_.end(), [](const Fast& f) { return f.linear == Linear::ring; })) {
        fast_.clear();
        for (int k = 0; k < 3; ++k) fast_.push_back({names[static_cast<std::size_t>(k)], Linear::ring, "1"});
    }
    for (const Fast& f : fast_) {
        states_.push_back(f.name);
        if (f.second_order()) states_.push_back(f.name + "'");
    }
}

// What coefficients may depend on, declared before the first of them is drawn.
void SystemWriter::draw_names() {
    static const Texts slow = {"s", "r"}, angles = {"p", "q"};
    for (int k = count({3, 4, 1}); k > 0; --k) slow_.push_back(slow[slow_.size()]);
    for (int k = count({6, 3, 1}); k > 0; --k) angles_.push_back(angles[angles_.size()]);
    if (fast_.empty() && angles_.empty()) angles_.push_back("p");
    for (const std::string& s : slow_) {
        const bool positive = draw_.chance(3);
        declare(s, "slow", positive ? ", positive = true" : "");
        (positive ? names_.positive : names_.slow).push_back(s);
    }
    const bool left_to_caller = draw_.chance(6);
    for (int k = draw_.pick(4); k > 0; --k) {
        const std::string name = fmt::format("k{}", ++parameters_count_);
        const bool positive = draw_.chance(2);
        parameters_ += fmt::format("{} = {{{}}}\n", name, positive ? " positive = true " : "");
        (positive ? names_.positive : names_.free).push_back(name);
        if (!left_to_caller) fix_ += fmt::format("{} = \"{}\"\n", name, number(draw_, 0.4, 1.6));
    }
    if (slow_.empty() || !draw_.chance(10)) return;
    static const Texts values = {"exp(-{0}/2)", "1 + {0}^2", "sqrt(2 + {0}^2)", "2 + cos({0})"};
    functions_ = fmt::format("[functions]\nf = {{ of = [\"{}\"], positive = true }}\n", slow_.front());
    bound_ =
        fmt::format("[functions]\nf = \"{}\"\n", fmt::format(fmt::runtime(draw_.any(values)), slow_.front()));
    names_.functions.push_back("f(" + slow_.front() + ")");
}

std::string SystemWriter::positive_parameter() {
    Texts found;
    for (const std::string& name : names_.positive)
        if (name.front() == 'k') found.push_back(name);
    return found.empty() ? "" : draw_.any(found);
}

// One in four with a factor that may move.
std::string SystemWriter::moving(const std::string& constant) {
    if (!draw_.chance(4)) return constant;
    const std::string f = drawn_function(draw_, names_, true);
    return f.empty() ? constant : constant + "*" + f;
}

std::string SystemWriter::rate() {
    if (draw_.chance(8)) return moving(fmt::format("{:.0f}", draw_.log_uniform(1e3, 1e8)));
    const std::string k = draw_.chance(4) ? positive_parameter() : "";
    return moving(k.empty() ? constant(0.3, 4) : k);
}

std::string SystemWriter::frequency_squared(std::size_t k) {
    static const Texts squares = {"1", "4", "9"};
    if (k > 0 && relations_.empty() && fast_[k - 1].linear == Linear::oscillates && draw_.chance(8)) {
        if (const std::string first = positive_parameter();
            !first.empty() && frequencies_[k - 1] == first + "^2") {
            parameters_ += "w = { positive = true }\n";
            const int times = 1 + draw_.pick(2);
            relations_ =
                fmt::format("[relations]\nw = \"{}*{} + eps*{}\"\n", times, first, decimal(draw_, 0.2, 1));
            return "w^2";
        }
    }
    switch (draw_.pick(4)) {
    case 0: return draw_.any(squares);
    case 1:
        if (const std::string name = positive_parameter(); !name.empty()) return name + "^2";
        [[fallthrough]];
    default: return moving(constant(0.6, 6));
    }
}

std::string SystemWriter::linear_part(std::size_t k) {
    const std::string& x = fast_[k].name;
    const std::string other = fast_[(k + 1) % fast_.size()].name;
    switch (fast_[k].linear) {
    case Linear::oscillates: frequencies_[k] = frequency_squared(k); return "-" + frequencies_[k] + "*" + x;
    case Linear::relaxes: return "-" + rate() + "*" + x;
    case Linear::grows: return moving(constant(0.2, 1)) + "*" + x;
    case Linear::saddle: return moving(constant(0.2, 2)) + "*" + x;
    case Linear::ring: return "-" + constant(0.5, 3) + "*" + x + " + " + other;
    default: break;
    }
    const std::string first = fast_[k].linear == Linear::creeps ? rate() : constant(0.2, 1);
    const std::string second = fast_[k].linear == Linear::creeps ? constant(1.3, 3) : constant(0.6, 4);
    switch (fast_[k].linear) {
    case Linear::creeps: return fmt::format("-({0} + {1})*{2}' - {0}*{1}*{2}", first, second, x);
    case Linear::critical: return fmt::format("-2*{0}*{1}' - {0}^2*{1}", first, x);
    case Linear::unwinds: return fmt::format("2*{0}*{1}' - ({0}^2 + {2})*{1}", first, x, second);
    default: return fmt::format("-2*{0}*{1}' - ({0}^2 + {2})*{1}", first, x, second);
    }
}

std::string SystemWriter::monomial(int degree) {
    std::string m = coefficient();
    for (int k = 0; k < degree && !states_.empty(); ++k) {
        m += "*";
        m += draw_.any(states_);
    }
    if (!angles_.empty() && draw_.chance(3)) {
        m += draw_.chance(2) ? "*sin(" : "*cos(2*";
        m += draw_.any(angles_) + ")";
    }
    return m;
}

// What is expanded in a fast variable, only where all are small.
std::string SystemWriter::nonlinear_terms(const Fast& of) {
    static const Texts of_small = {"sin({0})",    "cos({0})",      "exp({0})",       "tanh({0})",
                                   "1/(1 + {0})", "sqrt(1 + {0})", "log(2 + {0}^2)", "atan({0})"};
    const bool finite = of.weight == "0";
    const bool small =
        std::none_of(fast_.begin(), fast_.end(), [](const Fast& f) { return f.weight == "0"; });
    std::string terms;
    for (int n = 1 + draw_.pick(3); n > 0; --n) {
        terms += finite ? " + eps*" : " + ";
        terms += monomial(finite ? 1 + draw_.pick(3) : 2 + draw_.pick(2));
        if (small && draw_.chance(6)) terms += "*" + fmt::format(fmt::runtime(draw_.any(of_small)), of.name);
    }
    if (finite && draw_.chance(30)) terms += fmt::format(" - {0}^2", of.name);
    return terms;
}

std::string SystemWriter::forces(const Fast& of) {
    std::string terms;
    if (of.second_order() && draw_.chance(2))
        terms += fmt::format(" - eps*{}*{}'", constant(0.05, 0.8), of.name);
    if (!angles_.empty() && draw_.chance(2)) {
        const bool large = of.weight == "0" || draw_.chance(6);
        terms += large ? " + eps*" : " + eps^2*";
        terms += coefficient();
        terms += "*cos(" + draw_.any(angles_) + ")";
    }
    if (draw_.chance(12)) terms += " + eps*" + coefficient();
    return terms;
}

void SystemWriter::write_fast(std::size_t k) {
    const Fast& of = fast_[k];
    frequencies_.resize(fast_.size());
    declare(of.name, "fast", of.weight == "1" ? "" : fmt::format(", weight = \"{}\"", of.weight));
    std::string right = linear_part(k);
    right += nonlinear_terms(of);
    right += forces(of);
    equation(of.name, of.second_order() ? "''" : "'", right);
    const std::string size = of.weight == "0" ? "" : of.weight == "1" ? "*eps" : "*eps^(" + of.weight + ")";
    for (const char* prime : {"", "'"}) {
        if (*prime != 0 && !of.second_order()) break;
        const char* sign = draw_.chance(2) ? "-" : "";
        start(of.name + prime, fmt::format("{}{}{}", sign, decimal(draw_, 0.1, 0.8), size));
    }
    outputs_.push_back(of.name);
}

void SystemWriter::write_slow(const std::string& s) {
    std::string right = "eps*" + constant(0.2, 1);
    switch (draw_.pick(4)) {
    case 0: break;
    case 1: right += fmt::format(" - eps*{}*{}", constant(0.2, 1), s); break;
    case 2: right = fmt::format("eps*{0}*{1}*(1 - {1}/3)", constant(0.2, 1), s); break;
    default:
        right += fmt::format(" - eps*{}*{}", constant(0.2, 1), s);
        right += " + eps*" + monomial(1 + draw_.pick(2));
    }
    equation(s, "'", right);
    start(s, decimal(draw_, 0.3, 1.5));
    if (fast_.empty() || draw_.chance(2)) outputs_.push_back(s);
}

void SystemWriter::write_angle(const std::string& p) {
    declare(p, "angle");
    std::string right = draw_.chance(4) ? positive_parameter() : "";
    right = moving(right.empty() ? constant(0.5, 2.5) : right);
    if (draw_.chance(3)) right += " + eps*" + coefficient() + "*sin(" + p + ")";
    equation(p, "'", right);
    start(p, decimal(draw_, 0.1, 3));
}

void SystemWriter::write_drifts() {
    static const Texts names = {"d", "g"};
    const int least = outputs_.empty() ? 1 : 0; // angles are no outputs
    for (int k = std::max(count({2, 1, 1}), least); k > 0; --k) {
        const std::string& name = names[drifts_++];
        declare(name, "drift");
        std::string right = "eps*" + monomial(draw_.pick(3));
        const bool finite =
            std::any_of(fast_.begin(), fast_.end(), [](const Fast& f) { return f.weight == "0"; });
        if (!finite && !fast_.empty() && draw_.chance(2)) right += " + " + monomial(1 + draw_.pick(2));
        equation(name, "'", right);
        start(name, decimal(draw_, 0.1, 2));
        outputs_.push_back(name);
    }
}

// transients = false only with an output that does not merely decay.
void SystemWriter::write_scene() {
    const std::size_t n = fast_.size();
    order_ = n >= 4 ? 1 : 1 + draw_.pick(n >= 2 || slow_.size() + angles_.size() > 2 ? 2 : 3);
    const auto heavy = [](const Fast& f) { return f.weight == "2"; };
    if (std::any_of(fast_.begin(), fast_.end(), heavy)) order_ = std::max(order_, 2);
    const int time_scale = draw_.chance(10) ? 0 : draw_.chance(12) ? 2 : 1;
    const bool lasting = any(&Fast::lasts) || n == 0;
    if (draw_.chance(20) && lasting) scene_ += "oscillating = false\n";
    if (draw_.chance(8) && lasting && any(&Fast::decays)) {
        scene_ += "transients = false\n";
        outputs_.erase(std::remove_if(outputs_.begin(), outputs_.end(),
                                      [&](const std::string& name) {
                                          return std::any_of(fast_.begin(), fast_.end(), [&](const Fast& f) {
                                              return f.name == name && !f.lasts();
                                          });
                                      }),
                       outputs_.end());
    }
    if (draw_.chance(3) && any(&Fast::grows)) scene_ += "growing = \"project\"\n";
    if (draw_.chance(12)) scene_ += "error_estimate = true\n";
    while (outputs_.size() > 1 && draw_.chance(4))
        outputs_.erase(outputs_.begin() + draw_.pick(static_cast<int>(outputs_.size())));
    scene_ = fmt::format("order = {}\ntime_scale = {}\noutputs = [\"{}\"]\n{}{}", order_, time_scale,
                         fmt::join(outputs_, "\", \""), scene_, bound_);
    if (!fix_.empty()) scene_ += "[fix]\n" + fix_;
    scene_ += "[start]\n" + start_ + "[verify]\neps = ";
    scene_ += time_scale == 2 ? "[0.1, 0.05, 0.04, 0.025]\n" : "[0.05, 0.02, 0.01, 0.005]\n";
}

WrittenScene SystemWriter::written() const {
    WrittenScene result;
    result.system = "[system]\nname = \"random\"\n";
    if (!parameters_.empty()) result.system += "[parameters]\n" + parameters_;
    result.system += functions_ + "[variables]\n" + variables_ + "[equations]\n" + equations_ + relations_;
    result.scene = scene_;
    result.order = order_;
    result.roles = fmt::format("{} fast, {} slow, {} angles, {} drifts", fast_.size(), slow_.size(),
                               angles_.size(), drifts_);
    return result;
}

} // namespace

WrittenScene random_system(std::uint64_t seed) { return SystemWriter(seed).written(); }

} // namespace resonform::test
