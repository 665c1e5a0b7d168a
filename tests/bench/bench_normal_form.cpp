// SPDX-License-Identifier: GPL-3.0-or-later
// bench_normal_form [pendulum | cubic | chain | rivals]...      all of them, if none is named
// bench_normal_form SYSTEM_FILE ORDER...
//
// How long the engine takes for a normal form, and how that grows. For each order: derivation and
// certificate (the least of several runs; the equations are expanded before, and read for certificates once),
// terms of map and normal form, resident memory above the bare process, growth exponent against the order
// before. With symbolic frequencies coefficients are held in a graph, whose nodes are counted. The rivals
// (bench/rivals) are programs written by hand for the pendulum alone; they and the engine take turns in one
// run.
#include "bench/measure.hpp"

#include "certify/certificate.hpp"
#include "expand/expansion/graded_field.hpp"
#include "model/files/read_system.hpp"
#include "model/system/system_file.hpp"
#include "normalize/recursion/poincare.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>

namespace {

using namespace resonform;
using bench::least_seconds;
using bench::peak_megabytes;

const std::string source = RESONFORM_SOURCE_DIR;
const std::string pendulum = source + "/systems/almost_holonomic_pendulum/system.toml";

template <class Part> std::size_t size_of(const BasicSeries<Part>& series) {
    std::size_t terms = 0;
    for (int n = 0; n <= series.through(); ++n) terms += series.part(n).size();
    return terms;
}

template <class Part> std::size_t count_terms(const NormalizationOf<Part>& n) {
    std::size_t terms = 0;
    for (const auto* group : {&n.normal_form.mode, &n.normal_form.angle, &n.normal_form.slow,
                              &n.normal_form.drift, &n.map.mode, &n.map.angle, &n.map.slow, &n.map.drift})
        for (const auto& series : *group) terms += size_of(series);
    return terms;
}

std::shared_ptr<const GradedField> field_of(const std::string& file) {
    const auto system = std::make_shared<const System>(read_system(file));
    return std::make_shared<const GradedField>(
        expand(std::make_shared<const FirstOrderSystem>(solve_for_highest(system))));
}

struct Row {
    double derive = 0, certify = 0, megabytes = 0;
    std::size_t terms = 0, nodes = 0;
};

Row in_ring(const std::shared_ptr<const GradedField>& field, const Certifier& certifier, int order) {
    Row row;
    Normalization n;
    row.derive = least_seconds([&] {
        n = {}; // or two would be held at a time
        n = normalize_poincare(field, order);
    });
    row.megabytes = peak_megabytes();
    row.certify = least_seconds([&] { static_cast<void>(certifier(n.normal_form, n.map)); });
    row.terms = count_terms(n);
    return row;
}

Row in_graph(const std::shared_ptr<const GradedField>& field, int order) {
    Row row;
    std::optional<GraphNormalization> n;
    row.derive = least_seconds([&] {
        n.reset();
        n.emplace(normalize_in_graph(field, order));
    });
    row.megabytes = peak_megabytes();
    row.certify = least_seconds([&] { static_cast<void>(certify(*n)); });
    row.terms = count_terms(n->result);
    row.nodes = n->domain.graph().size();
    return row;
}

void table(const std::string& file, const std::vector<int>& orders) {
    const auto field = field_of(file);
    const double prepare = least_seconds([&] { static_cast<void>(Certifier(field)); });
    const Certifier certifier(field);
    const double floor = peak_megabytes();
    fmt::print("\n{}\nequations read for certificates in {:.3f} ms\n\n| order | derivation ms | certificate "
               "ms | ratio | terms | nodes | MB above {:.0f} | "
               "growth |\n|---|---|---|---|---|---|---|---|\n",
               file, 1e3 * prepare, floor);
    double last_time = 0;
    int last_order = 0;
    for (const int order : orders) {
        const Row row =
            suits_graph(*field, order) ? in_graph(field, order) : in_ring(field, certifier, order);
        const double growth =
            last_order == 0 ? 0 : std::log(row.derive / last_time) / std::log(double(order) / last_order);
        fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {} | {} | {:.1f} | {:.1f} |\n", order, 1e3 * row.derive,
                   1e3 * row.certify, row.certify / row.derive, row.terms, row.nodes, row.megabytes - floor,
                   growth);
        std::fflush(stdout);
        last_time = row.derive;
        last_order = order;
    }
}

// The seconds behind the last `label` in what a shell command prints; none if it fails.
std::optional<double> seconds_printed(const std::string& command, const std::string& label) {
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    std::string text;
    char chunk[4096];
    while (const std::size_t count = std::fread(chunk, 1, sizeof chunk, pipe)) text.append(chunk, count);
    if (pclose(pipe) != 0) return std::nullopt;
    const std::size_t at = text.rfind(label);
    if (at == std::string::npos) return std::nullopt;
    return std::strtod(text.c_str() + at + label.size(), nullptr);
}

void compare_with_rivals() {
    struct Rival {
        std::string name;
        int order;
        std::string command, label;
    };
    const std::string folder = source + "/tests/bench/rivals/";
    std::vector<Rival> rivals;
    for (const int order : {5, 7, 9, 11})
        rivals.push_back(
            {"pend_plain.py", order, fmt::format("python3 {}pend_plain.py {}", folder, order), "time"});
    rivals.push_back({"pend_sympy.py", 11, fmt::format("python3 {}pend_sympy.py 11", folder), "time"});
    rivals.push_back(
        {"pend_flint.cpp (z only)", 21,
         fmt::format(
             "p=$(mktemp) && g++ -O3 {}pend_flint.cpp -lflint -lgmp -o $p && $p; r=$?; rm -f $p; exit $r",
             folder),
         "K 21"});
    const auto field = field_of(pendulum);
    fmt::print("\n| rival | order | rival s | engine s | ratio |\n|---|---|---|---|---|\n");
    for (const Rival& rival : rivals) {
        const double before =
            least_seconds([&] { static_cast<void>(normalize_poincare(field, rival.order)); });
        const std::optional<double> theirs = seconds_printed(rival.command + " 2>/dev/null", rival.label);
        const double after =
            least_seconds([&] { static_cast<void>(normalize_poincare(field, rival.order)); });
        const double ours = std::min(before, after);
        if (theirs)
            fmt::print("| {} | {} | {:.3f} | {:.5f} | {:.1f} |\n", rival.name, rival.order, *theirs, ours,
                       *theirs / ours);
        else
            fmt::print("| {} | {} | does not run here | {:.5f} | |\n", rival.name, rival.order, ours);
        std::fflush(stdout);
    }
}

void run(const std::string& part) {
    if (part == "pendulum") table(pendulum, {3, 5, 7, 9, 11, 15, 21, 31});
    if (part == "cubic") table(source + "/tests/bench/systems/three_cubic.toml", {2, 3, 4, 5, 6, 7});
    if (part == "chain") table(source + "/tests/bench/systems/chain_of_three.toml", {3, 4, 5, 6, 7, 8, 9});
    if (part == "rivals") compare_with_rivals();
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> parts{"rivals", "pendulum", "cubic", "chain"};
    std::vector<std::string> asked(argv + 1, argv + argc);
    try {
        if (asked.empty()) asked = parts;
        if (std::find(parts.begin(), parts.end(), asked.front()) != parts.end()) {
            for (const std::string& part : asked) run(part);
            return 0;
        }
        std::vector<int> orders;
        for (std::size_t k = 1; k < asked.size(); ++k) orders.push_back(std::atoi(asked[k].c_str()));
        table(asked.front(), orders);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
