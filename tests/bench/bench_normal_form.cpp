// SPDX-License-Identifier: GPL-3.0-or-later
// bench_normal_form SYSTEM_FILE ORDER...: how long the engine takes for a normal form, and how that grows.
//
// For each order: derivation and certificate (the least of several runs, in milliseconds), terms of map
// and normal form, resident memory above the bare process, growth exponent against the order before.
#include "expand/graded_field.hpp"
#include "model/system_file.hpp"
#include "normalize/certificate.hpp"
#include "normalize/poincare.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>

namespace {

using namespace resonform;

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// The least time of at least three runs, and of as many as fit into half a second.
template <class Task> double least_time(Task task) {
    double least = 1e300, total = 0;
    for (int run = 0; run < 3 || (total < 500 && run < 100); ++run) {
        const auto start = std::chrono::steady_clock::now();
        task();
        const double time = milliseconds_since(start);
        least = std::min(least, time);
        total += time;
        if (total > 20000) break;
    }
    return least;
}

double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

std::size_t size_of(const Series& series) {
    std::size_t terms = 0;
    for (int n = 0; n <= series.through(); ++n) terms += series.part(n).size();
    return terms;
}

std::size_t count_terms(const Normalization& n) {
    std::size_t terms = 0;
    for (const auto* group : {&n.normal_form.mode, &n.normal_form.drift, &n.map.mode, &n.map.drift})
        for (const Series& series : *group) terms += size_of(series);
    return terms;
}

void run(const std::string& file, const std::vector<int>& orders) {
    const auto system = std::make_shared<const System>(read_system(file));
    const auto first_order = std::make_shared<const FirstOrderSystem>(solve_for_highest(system));
    double expansion = least_time([&] { static_cast<void>(expand(first_order)); });
    const auto field = std::make_shared<const GradedField>(expand(first_order));
    const double floor = peak_megabytes();
    fmt::print("{}: expansion set up in {:.2f} ms\n\n", file, expansion);
    fmt::print("| order | derivation ms | certificate ms | ratio | terms | MB above {:.0f} | growth |\n",
               floor);
    fmt::print("|---|---|---|---|---|---|---|\n");
    double last_time = 0;
    int last_order = 0;
    for (int order : orders) {
        Normalization result;
        const double derive = least_time([&] { result = normalize_poincare(field, order); });
        const double memory = peak_megabytes() - floor;
        const double check = least_time([&] { static_cast<void>(certify(result.normal_form, result.map)); });
        const double growth =
            last_order == 0 ? 0 : std::log(derive / last_time) / std::log(double(order) / last_order);
        fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {} | {:.1f} | {:.1f} |\n", order, derive, check,
                   check / derive, count_terms(result), memory, growth);
        std::fflush(stdout);
        last_time = derive;
        last_order = order;
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        fmt::print(stderr, "usage: bench_normal_form SYSTEM_FILE ORDER...\n");
        return 2;
    }
    try {
        std::vector<int> orders;
        for (int k = 2; k < argc; ++k) orders.push_back(std::atoi(argv[k]));
        run(argv[1], orders);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
