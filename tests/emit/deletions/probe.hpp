// SPDX-License-Identifier: GPL-3.0-or-later
// What all numbers and statuses of an emitted evaluator are folded into, and a run of each mutant in a
// process of its own. Compiled beside a header in which statements are planted with gone(n) (deletions.hpp).
#pragma once

#include "runtime/in_range.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace probe {

class Digest {
public:
    void add(double x) {
        unsigned long long bits = 1;
        if (!std::isnan(x)) std::memcpy(&bits, &x, sizeof bits);
        fold(bits);
    }
    void add(int x) { fold(static_cast<unsigned long long>(x)); }
    void add(const char* text) {
        for (; *text != 0; ++text) fold(static_cast<unsigned char>(*text));
    }
    unsigned long long value() const { return hash_; }

private:
    void fold(unsigned long long word) { hash_ = (hash_ ^ word) * 0x100000001b3ULL + (hash_ >> 29); }
    unsigned long long hash_ = 0xcbf29ce484222325ULL;
};

// As resonform::in_range, or no: then everything is computed in numbers of any range.
inline bool ever_in_range = true;
template <class Number, class Compute, class Result, class... Inputs>
bool in_range(const Compute& compute, Result& result, const Inputs&... inputs) {
    return ever_in_range && resonform::in_range<Number>(compute, result, inputs...);
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double sentinel = 123.5;

template <class Number, std::size_t n> std::array<Number, n> filled() {
    std::array<Number, n> all;
    all.fill(Number(1.25));
    return all;
}

template <class E, std::size_t outputs> struct Probe {
    using Status = typename E::Status;
    using Numbers = std::array<double E::Values::*, outputs>;
    template <class Of> using Fields = std::vector<double Of::*>;

    // Columns of so many members, each of whose start values differ, entered in the arrays of `members`.
    std::vector<std::vector<double>> (*columns)(std::size_t n, const typename E::Start& at,
                                                typename E::Members& members);
    Numbers values;
    Fields<typename E::Start> start;
    Fields<typename E::Parameters> parameters;
    Digest digest;
    unsigned long long seed = 1;

    void add(Status status) { digest.add(static_cast<int>(status)); }

    template <class Call> void add_values(const Call& call) {
        typename E::Values v;
        for (auto value : values) v.*value = sentinel;
        add(call(v));
        for (auto value : values) digest.add(v.*value);
    }

    template <std::size_t... k> void add_many(const E& evaluator, double reach, std::index_sequence<k...>) {
        constexpr std::size_t n = 70;
        std::vector<double> t;
        for (std::size_t i = 0; i < n; ++i) t.push_back(reach * 1.05 * static_cast<double>(i) / n);
        for (const bool at_once : {false, true}) {
            std::array<std::vector<double>, outputs> rows;
            for (auto& row : rows) row.assign(n, sentinel);
            std::vector<Status> status(n);
            if (at_once)
                evaluator.grid(0, reach / n, n, rows[k].data()..., status.data());
            else
                evaluator.batch(t.data(), n, rows[k].data()..., status.data());
            for (const Status s : status) add(s);
            for (const auto& row : rows)
                for (const double x : row) digest.add(x);
        }
    }

    template <std::size_t... k>
    void add_members(double eps, const typename E::Start& at, std::index_sequence<k...>) {
        constexpr std::size_t n = 9;
        const std::vector<double> all_eps(n, eps);
        std::vector<double> t;
        for (std::size_t i = 0; i < n; ++i) t.push_back(0.9 * static_cast<double>(i) / (n * eps));
        typename E::Members members;
        members.eps = all_eps.data();
        const std::vector<std::vector<double>> kept = columns(n, at, members);
        std::array<std::vector<double>, outputs> rows;
        for (auto& row : rows) row.assign(n, sentinel);
        std::vector<Status> status(n);
        for (const bool full_phase : {true, false}) {
            if constexpr (requires { members.full_phase; }) members.full_phase = full_phase;
            E::ensemble(n, members, t.data(), rows[k].data()..., status.data());
            for (const Status s : status) add(s);
            for (const auto& row : rows)
                for (const double x : row) digest.add(x);
        }
    }

    void add_point(double eps, const typename E::Parameters& p, const typename E::Start& at, double end) {
        const E evaluator(eps, p, at, end);
        add(evaluator.construction_status());
        const double reach = end / eps;
        for (const double share : {0.0, 0.013, 0.31, 0.77, 0.999, 1.2, -0.1, none, 1e300})
            add_values([&](typename E::Values& v) { return evaluator(share * reach, v); });
        for (const double share : {0.0, 0.4, 1.0, -0.1, none})
            add_values([&](typename E::Values& v) { return E::at_end(eps, p, at, share * reach, v); });
        add(evaluator.prepare());
        add_many(evaluator, reach, std::make_index_sequence<outputs>());
        for (int s = 0; s < 10; ++s) digest.add(evaluator.why(static_cast<Status>(s)));
        add_members(eps, at, std::make_index_sequence<outputs>());
    }

    void add_defaults(double eps) {
        const typename E::Parameters p{};
        const typename E::Start at = E::default_start(eps, p);
        for (auto field : start) digest.add(at.*field);
        digest.add(E::default_slow_time_end(eps, p));
        add_values([&](typename E::Values& v) { return E(eps)(0.3 / eps, v); });
    }

    unsigned long long all() {
        for (const bool in_range : {true, false}) {
            ever_in_range = in_range;
            add_all();
        }
        return digest.value();
    }

    void add_all() {
        const typename E::Parameters p{};
        for (const double eps : {0.05, 0.01, 0.13, 0.6}) {
            add_defaults(eps);
            add_point(eps, p, E::default_start(eps, p), E::default_slow_time_end(eps, p));
        }
        const double eps = 0.05, end = E::default_slow_time_end(eps, p);
        const typename E::Start usual = E::default_start(eps, p);
        for (const double odd : {none, 0.0, -0.1, 1e-300, 1e150, 1e300, HUGE_VAL})
            add_point(odd, p, usual, end), add_point(eps, p, usual, odd);
        for (const double longer : {0.3, 3.0, 40.0}) add_point(eps, p, usual, longer * end);
        vary(start, usual, [&](const typename E::Start& at) { add_point(eps, p, at, end); });
        for (const double small : {1e-9, 1e-13, 1e-16}) add_point(small, p, usual, end);
        add_drawn(usual);
        vary(parameters, p, [&](const typename E::Parameters& q) { add_point(eps, q, usual, end); });
    }

private:
    // Each field set to other values in turn; then all of them at once.
    template <class Of, class Use>
    static void vary(const Fields<Of>& fields, const Of& usual, const Use& use) {
        for (auto field : fields)
            for (const double value :
                 {usual.*field * 1.37 + 0.11, -(usual.*field) - 0.3, 0.0, 3.1, none, 1e130, -1e300, 1e-170}) {
                Of changed = usual;
                changed.*field = value;
                use(changed);
            }
    }

    // Of any size and sign, some of them far outside of the domain.
    void add_drawn(const typename E::Start& usual) {
        for (int k = 0; k < drawn; ++k) {
            const double eps = std::pow(10, 2 - 7 * draw());
            typename E::Parameters p{};
            for (auto field : parameters) p.*field *= std::pow(10, 2 * draw() - 1);
            typename E::Start at = usual;
            for (auto field : start)
                if (draw() < 0.8) at.*field = std::pow(10, 5 * draw() - 2) * (draw() < 0.5 ? -1 : 1);
            add_point(eps, p, at, E::default_slow_time_end(eps, p) * std::pow(10, 2 * draw() - 1));
        }
    }

    double draw() {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(seed >> 40) / (1 << 24);
    }

    static constexpr int drawn = 300;
};

// Prints the mutants, numbered from 1, that give what the honest code gives.
template <class Run> int tell_survivors(int mutants, int& chosen, const Run& run) {
    unsigned long long honest = 0;
    for (int n = 0; n <= mutants; ++n) {
        int ends[2];
        if (pipe(ends) != 0) return 1;
        const pid_t child = fork();
        if (child == 0) {
            alarm(20); // a loop without end is another answer
            chosen = n;
            const unsigned long long found = run();
            _exit(write(ends[1], &found, sizeof found) == sizeof found ? 0 : 1);
        }
        close(ends[1]);
        unsigned long long found = 0;
        const bool answered = read(ends[0], &found, sizeof found) == sizeof found;
        close(ends[0]);
        waitpid(child, nullptr, 0);
        if (n == 0 && !answered) return 1;
        if (n == 0) honest = found;
        if (n > 0 && answered && found == honest) std::printf("%d\n", n);
    }
    return 0;
}

} // namespace probe
