// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/table.hpp"

#include "algebra/number/error.hpp"
#include "verify/run/cache.hpp"
#include "verify/run/parallel.hpp"
#include "verify/run/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <optional>

namespace resonform {

namespace {

using Table = std::vector<std::vector<SymbolicPoint>>;

// Numbers beyond the range of double, too.
class Packer {
public:
    void put(const Wide& x) {
        int exponent = 0;
        const Parts parts = to_parts(Wide(frexp(x, &exponent)));
        bytes_ += fmt::format("{:a} {:a} {:a} {}\n", parts[0], parts[1], parts[2], exponent);
    }
    void put(int number) { bytes_ += fmt::format("{}\n", number); }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

class Unpacker {
public:
    explicit Unpacker(const std::string& bytes) : at_(bytes.c_str()) {}
    Wide number() {
        Parts parts{};
        for (double& part : parts) part = std::strtod(at_, &next_), at_ = next_;
        const int exponent = integer();
        return ldexp(from_parts<Wide>(parts), exponent);
    }
    int integer() {
        const long value = std::strtol(at_, &next_, 10);
        at_ = next_;
        return static_cast<int>(value);
    }

private:
    const char* at_;
    char* next_ = nullptr;
};

std::string pack(const Table& table) {
    Packer packer;
    for (const auto& row : table)
        for (const SymbolicPoint& point : row) {
            packer.put(static_cast<int>(point.status));
            packer.put(static_cast<int>(point.values.size()));
            for (const auto* list : {&point.values, &point.scales, &point.phase_parts})
                for (const Wide& x : *list) packer.put(x);
        }
    return packer.bytes();
}

Table unpack(const std::string& bytes, const std::vector<SymbolicPoints>& points) {
    Unpacker unpacker(bytes);
    Table table;
    for (const SymbolicPoints& p : points) {
        table.emplace_back();
        for (std::size_t i = 0; i < p.times.size(); ++i) {
            SymbolicPoint point;
            point.status = static_cast<Status>(unpacker.integer());
            const int outputs = unpacker.integer();
            for (auto* list : {&point.values, &point.scales, &point.phase_parts})
                for (int k = 0; k < outputs; ++k) list->push_back(unpacker.number());
            table.back().push_back(std::move(point));
        }
    }
    return table;
}

// Where the solution starts is computed each time: it stands for the inverse map.
std::string key_of(const SymbolicSolution& solution, const std::vector<SymbolicPoints>& points) {
    Packer packer;
    for (const SymbolicPoints& p : points) {
        packer.put(p.inputs.eps);
        packer.put(p.inputs.slow_time_end);
        for (const auto* list : {&p.inputs.parameters, &p.inputs.start})
            for (const auto& named : *list) packer.put(named.second);
        for (const Wide& t : p.times) packer.put(t);
        const SymbolicStart start = solution.start().at(p.inputs);
        packer.put(static_cast<int>(start.status));
        packer.put(start.amplitude);
        for (const auto* list : {&start.slow, &start.angles})
            for (const Wide& x : *list) packer.put(x);
        for (const WideComplex& z : start.modes) {
            packer.put(z.re);
            packer.put(z.im);
        }
        for (const SymbolicStart::Sum& drift : start.drifts) {
            packer.put(drift.value);
            packer.put(drift.scale);
        }
    }
    return content_hash(solution.text() + packer.bytes());
}

std::vector<SymbolicPoint> row_of(const std::shared_ptr<const SymbolicSolution>& solution,
                                  const SymbolicPoints& points) {
    const Wide last =
        points.times.empty() ? Wide(0) : *std::max_element(points.times.begin(), points.times.end());
    const Wide reach = points.inputs.eps * last * (1 + Wide(0x1p-40));
    const SymbolicEvaluator at(solution, points.inputs, reach);
    std::vector<SymbolicPoint> row;
    for (const Wide& t : points.times) row.push_back(at(t));
    return row;
}

// Tells after each quarter of the starts; whichever thread comes to its end does.
class Quarters {
public:
    Quarters(std::size_t all, const std::function<void(const std::string&)>& tell) : all_(all), tell_(tell) {}
    void one_more() {
        if (!tell_) return;
        const std::lock_guard lock(mutex_);
        ++done_;
        if (4 * done_ / all_ > 4 * (done_ - 1) / all_ && done_ < all_)
            tell_(fmt::format("the exact solution in 50 digits: {} of {} starts", done_, all_));
    }

private:
    std::mutex mutex_;
    std::size_t done_ = 0, all_;
    const std::function<void(const std::string&)>& tell_;
};

} // namespace

std::vector<std::vector<SymbolicPoint>>
symbolic_values(const std::shared_ptr<const SymbolicSolution>& solution,
                const std::vector<SymbolicPoints>& points, const std::filesystem::path& cache,
                const std::function<void(const std::string&)>& progress) {
    const std::filesystem::path file = cache / (key_of(*solution, points) + ".symbolic");
    if (const auto bytes = load_checked(file)) return unpack(*bytes, points);
    Table table(points.size());
    Quarters quarters(points.size(), progress);
    in_parallel(points.size(), [&](std::size_t j) {
        table[j] = row_of(solution, points[j]);
        quarters.one_more();
    });
    try {
        store_checked(file, pack(table));
    } catch (const Error& error) { // a full disk is no reason to throw it away
        if (progress) progress(fmt::format("the exact values are not kept: {}", error.diagnostic().value));
    }
    return table;
}

} // namespace resonform
