// SPDX-License-Identifier: GPL-3.0-or-later
// Times of emitted evaluators in every width of the processor, in ns and as multiples of a yardstick of the
// same run: build/release/tests/bench_evaluators --help. New times t in each repetition, nothing kept between
// calls; the least of many.
#include "bench/measure.hpp"
#include "bench/members.hpp"
#include "runtime/batch.hpp"
#include "support/program.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/program_defaults.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

void sines_baseline(const double* t, std::size_t n, double* c, double* s);
void sines_avx2(const double* t, std::size_t n, double* c, double* s);
void sines_avx512(const double* t, std::size_t n, double* c, double* s);

namespace resonform {
namespace {

constexpr std::size_t million = 1000000, block = 4096;
volatile double sink = 0; // keeps the compiler from dropping the timed calls
constexpr std::array names{"baseline", "avx2", "avx512"};
constexpr std::array sines{&sines_baseline, &sines_avx2, &sines_avx512};

struct Row {
    std::string scene, quantity, simd;
    double eps = 0;
    int order = 0;
    double ns = 0, yardstick = 0;
    double to_reach = 0; // of the ratio; 0: no aim
};

using Times = std::vector<double>;

// Random parts of an interval, drawn once.
const Times& parts(std::size_t n, bool sorted, std::size_t seed) {
    static std::map<std::tuple<std::size_t, bool, std::size_t>, Times> drawn;
    Times& t = drawn[{n, sorted, seed}];
    if (!t.empty()) return t;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0, 1);
    t.resize(n);
    for (double& x : t) x = part(random);
    if (sorted) std::sort(t.begin(), t.end());
    return t;
}

// Least ns a point of call(t) over times t that are new each time.
template <class Call> double least(std::size_t n, double end, bool sorted, const Call& call) {
    double best = 1e300;
    const std::size_t repetitions = n > 100000 ? 9 : 300;
    Times t(n);
    for (std::size_t r = 0; r < repetitions; ++r) {
        const Times& part = parts(n, sorted, r % 9);
        const double shift = 1 - 1e-3 * static_cast<double>(r / 9) / 40;
        for (std::size_t i = 0; i < n; ++i) t[i] = part[i] * (end * shift);
        const auto start = std::chrono::steady_clock::now();
        call(t);
        best = std::min(best, bench::seconds_since(start));
    }
    return best / static_cast<double>(n) * 1e9;
}

// What a width is measured by: sincos for a million points and for a block; one read and three writes.
struct Yardstick {
    double million_ns, block_ns, copy_ns;
    explicit Yardstick(std::size_t width) {
        std::vector<double> a(million), b(million), c(million);
        const auto of = [&](std::size_t n) {
            return least(n, 1000, true,
                         [&](const Times& t) { sines[width](t.data(), n, a.data(), b.data()); });
        };
        million_ns = of(million);
        block_ns = of(block);
        copy_ns = least(million, 1000, true, [&](const Times& t) {
            for (std::size_t i = 0; i < t.size(); ++i) a[i] = b[i] = c[i] = t[i];
        });
    }
};

class Bench {
public:
    // seen: of each row as soon as it is measured.
    explicit Bench(std::function<void(const Row&)> seen) : seen_(std::move(seen)) {}

    // Orders of a scene; the default start and interval.
    void scene(const std::string& system, const std::string& name, const std::vector<int>& orders,
               const std::vector<double>& list) {
        for (const int order : orders) {
            Scene scene = test::scene_of(system, name);
            scene.order = order;
            const Program program = build_program(test::solution_of(scene), scene, {true, false, true});
            const auto library = EvaluatorLibrary::build(
                program, std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache", {});
            for (const double eps : list) {
                std::fprintf(stderr, "%s/%s, order %d, eps = %g\n", system.c_str(), name.c_str(), order, eps);
                row_ = {system + "/" + name, "", "", eps, order, 0, 0, 0};
                measure(program, library, eps);
            }
            members(program, list);
        }
    }
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

private:
    void measure(const Program& program, const std::shared_ptr<const EvaluatorLibrary>& library, double eps) {
        const std::vector<double> parameters = default_parameters<double>(program, eps);
        const std::vector<double> start = default_start<double>(program, eps, parameters);
        const double slow_end = program.interval_slow_time, end = slow_end / eps;
        const auto construct = [&] { return Evaluator<double>(library, eps, parameters, start, slow_end); };
        row_.simd = "scalar";
        double constructing = 1e300, preparing = 1e300;
        for (int r = 0; r < 50; ++r) {
            const auto begin = std::chrono::steady_clock::now();
            const Evaluator<double> made = construct();
            const double after = bench::seconds_since(begin);
            constructing = std::min(constructing, after);
            made.prepare();
            preparing = std::min(preparing, bench::seconds_since(begin) - after);
        }
        add("construction", constructing * 1e9, 0, 0);
        add("tables", preparing * 1e9, 0, 0);
        const Evaluator<double> evaluator = construct();
        std::vector<double> values(program.outputs.size());
        const double sine = least(block, end, false, [&](const Times& t) {
            for (const double x : t) sink = std::sin(x) + std::cos(x);
        });
        add("one call",
            least(block, end, false,
                  [&](const Times& t) {
                      for (const double x : t) evaluator.call(x, values.data());
                  }),
            sine, row_.order == 3 ? 4.5 : 0);
        evaluator.prepare();
        for (std::size_t width = 0; width < names.size(); ++width) {
            if (!force_simd(static_cast<Simd>(width))) {
                std::fprintf(stderr, "SKIPPED: the processor lacks %s\n", names[width]);
                continue;
            }
            row_.simd = names[width];
            many(program, evaluator, end, width);
        }
    }

    // A sorted point, in units of the yardstick of a width.
    [[nodiscard]] double sorted_aim(std::size_t width) const {
        if (row_.scene == "almost_holonomic_pendulum/third_order")
            return row_.order == 3   ? 5
                   : row_.eps < 5e-3 ? std::array{6.0, 7.0, 7.5}[width]
                                     : std::array{7.5, 8.0, 9.0}[width];
        if (row_.scene == "almost_holonomic_pendulum/mean_motion") return 1.5;
        if (width == 0) return 0;
        if (row_.scene == "henon_heiles/third_order") return row_.order == 3 ? 5 : 7;
        if (row_.scene == "three_oscillators_chain/third_order") return row_.order == 3 ? 9 : 28;
        return 0;
    }

    void many(const Program& program, const Evaluator<double>& evaluator, double end, std::size_t width) {
        static const std::array<Yardstick, 3> yardsticks{Yardstick(0), Yardstick(1), Yardstick(2)};
        const Yardstick& by = yardsticks[width];
        std::vector<std::vector<double>> room(program.outputs.size(), std::vector<double>(million));
        std::vector<double*> all;
        for (auto& column : room) all.push_back(column.data());
        std::vector<unsigned char> status;
        const auto timed = [&](std::size_t n, bool sorted, const std::vector<double*>& to) {
            status.resize(n);
            return least(n, end, sorted, [&](const Times& t) { evaluator.batch(t, to, status); });
        };
        const bool pendulum = row_.scene == "almost_holonomic_pendulum/third_order", third = row_.order == 3;
        const double sorted = sorted_aim(width);
        add("sorted, 10^6", timed(million, true, all), by.million_ns, sorted);
        add("sorted, blocks of 4096", timed(block, true, all), by.block_ns, sorted);
        const double shuffled = pendulum && third ? std::array{8.5, 11.0, 13.0}[width] : 0;
        add("any order, 10^6", timed(million, false, all), by.million_ns, shuffled);
        if (all.size() > 1) {
            std::vector<double*> rest = all;
            rest.front() = nullptr;
            add("sorted, 10^6, without the first output", timed(million, true, rest), by.million_ns,
                pendulum && third ? 4.2 : 0);
        }
        status.resize(million);
        const double dt = end / static_cast<double>(million);
        add("grid, 10^6, by one read and three writes",
            least(million, end, true,
                  [&](const Times& t) { evaluator.grid(t[0] * 1e-3, dt * 0.999, all, status); }),
            by.copy_ns, pendulum && third ? std::array{7.5, 2.3, 2.2}[width] : 0);
    }

    // A final point with nothing tabulated, alone and as one of many.
    void members(const Program& program, const std::vector<double>& list) {
        constexpr std::array marches{"x86-64", "x86-64-v3", "x86-64-v4"};
        const bool pendulum = row_.scene == "almost_holonomic_pendulum/third_order";
        const auto aim = [&](double third, double fifth) {
            return !pendulum ? 0 : row_.order == 3 ? third : row_.order == 5 ? fifth : 0;
        };
        for (std::size_t width = 0; width < names.size(); ++width) {
            const std::vector<bench::MemberTimes> all = bench::time_members(program, marches[width], list);
            for (std::size_t k = 0; k < all.size(); ++k) {
                row_.simd = names[width];
                row_.eps = list[k];
                const double factor = width == 0 ? 3 : 1;
                add_ns("one final point", all[k].alone, aim(600, 1000));
                add_ns("ensemble, phase to 4e-13", all[k].plain, factor * aim(35, 65));
                add_ns("ensemble, full phase", all[k].full, factor * aim(100, 160));
            }
        }
    }

    // What is to be reached in ns is held against 1 ns.
    void add_ns(const std::string& quantity, double ns, double to_reach) {
        add(quantity, ns, to_reach > 0 ? 1 : 0, to_reach);
    }

    void add(const std::string& quantity, double ns, double yardstick, double to_reach) {
        Row row = row_;
        row.quantity = quantity;
        row.ns = ns;
        row.yardstick = yardstick;
        row.to_reach = to_reach;
        rows_.push_back(row);
        seen_(row);
    }

    std::function<void(const Row&)> seen_;
    Row row_;
    std::vector<Row> rows_;
};

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown";
}

void print_json(const std::vector<Row>& rows) {
    nlohmann::ordered_json document{{"schema", "resonform.benchmark/1"},
                                    {"machine", processor()},
                                    {"simd", names[static_cast<std::size_t>(simd())]},
                                    {"rows", nlohmann::ordered_json::array()}};
    for (const Row& r : rows) {
        nlohmann::ordered_json row{{"scene", r.scene}, {"quantity", r.quantity}, {"simd", r.simd},
                                   {"eps", r.eps},     {"order", r.order},       {"ns", r.ns}};
        row["yardstick_ns"] = r.yardstick > 0 ? nlohmann::ordered_json(r.yardstick) : nullptr;
        row["ratio"] = r.yardstick > 0 ? nlohmann::ordered_json(r.ns / r.yardstick) : nullptr;
        row["to_reach"] = r.to_reach > 0 ? nlohmann::ordered_json(r.to_reach) : nullptr;
        document["rows"].push_back(row);
    }
    std::printf("%s\n", document.dump(2).c_str());
}

void print_text(const Row& r, std::string& title) {
    const std::string own = fmt::format("{}, order {}, eps = {:g}", r.scene, r.order, r.eps);
    if (own != title) std::printf("%s\n", own.c_str());
    title = own;
    std::string line = fmt::format("  {:<42} {:<9} {:10.2f} ns", r.quantity, r.simd, r.ns);
    if (r.yardstick > 0) line += fmt::format(" {:7.2f} x {:.2f} ns", r.ns / r.yardstick, r.yardstick);
    if (r.to_reach > 0)
        line += fmt::format(", to reach {:g}{}", r.to_reach,
                            r.ns / r.yardstick > r.to_reach ? ": falls short" : "");
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
}

struct Subject {
    const char *system, *scene;
    std::vector<int> orders;
    std::vector<double> eps;
    [[nodiscard]] std::string name() const { return fmt::format("{}/{}", system, scene); }
};
const std::array subjects{
    Subject{"almost_holonomic_pendulum", "third_order", {3, 5, 7, 9}, {1e-3, 1e-2}},
    Subject{"almost_holonomic_pendulum", "mean_motion", {3}, {1e-3}},
    Subject{"henon_heiles", "third_order", {3, 5, 7}, {1e-2}},
    Subject{"three_oscillators_chain", "third_order", {3, 5}, {1e-2}},
};

} // namespace
} // namespace resonform

int main(int argc, char** argv) {
    using namespace resonform;
    std::vector<std::string> names_of_scenes, wanted;
    for (const Subject& subject : subjects) names_of_scenes.push_back(subject.name());
    std::string format = "text";
    CLI::App app("times of emitted evaluators, in ns and as multiples of a sincos of the same width");
    app.add_option("--scene", wanted, "measure this scene; may be repeated; default: all")
        ->check(CLI::IsMember(names_of_scenes));
    app.add_option("--format", format, "how to print")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    const Simd widest = simd();
    std::string title;
    Bench bench([&](const Row& row) {
        if (format == "text") print_text(row, title);
    });
    if (format == "text") std::printf("%s\n", processor().c_str());
    for (const Subject& subject : subjects)
        if (wanted.empty() || std::find(wanted.begin(), wanted.end(), subject.name()) != wanted.end())
            bench.scene(subject.system, subject.scene, subject.orders, subject.eps);
    force_simd(widest);
    if (format == "json") print_json(bench.rows());
}
