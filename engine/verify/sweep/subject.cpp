// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/subject.hpp"

#include "algebra/number/error.hpp"
#include "verify/run/cache.hpp"
#include "verify/run/machine.hpp"

#include <algorithm>
#include <array>

namespace resonform {

namespace {

struct Kind {
    const char* name;
    std::vector<const char*> quantities;
    std::uint64_t cost;
};

// In the order of SweepKind. A ladder takes a second, an estimate two thousand calls of interpreters, a
// comparison with 50 digits as long as that.
const Kind& kind_at(SweepKind kind) {
    static const std::array<Kind, 4> kinds{{{"values", {}, 1},
                                            {"verify", {"error", "order"}, 1'000'000},
                                            {"validity", {"validity"}, 10'000},
                                            {"stability", {"ulp"}, 10'000}}};
    return kinds[static_cast<std::size_t>(kind)];
}

SweepKind kind_named(const std::string& name) {
    const std::vector<std::string> names = sweep_kinds();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        bad_input(Reason::file, {"the description of a sweep must be as it was written",
                                 name,
                                 "run the sweep again with another --output",
                                 {}});
    return static_cast<SweepKind>(found - names.begin());
}

// The same numbers may be asked for in several ways.
bool counts(const std::string& key) { return key != "over" && key != "suffix"; }

Json json_of(const std::optional<SweepSample>& sample) {
    if (!sample) return nullptr;
    return Json{{"count", sample->count}, {"seed", sample->seed}};
}

std::string hash_of(const SweepGrid& grid) {
    std::string bytes;
    for (std::size_t a = 0; a < grid.axes().size(); ++a) {
        bytes += grid.axes()[a].name() + "=";
        const std::vector<double>& values = grid.values(a);
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
    }
    return content_hash(bytes);
}

} // namespace

std::vector<std::string> sweep_kinds() {
    std::vector<std::string> names;
    for (const SweepKind kind :
         {SweepKind::values, SweepKind::verify, SweepKind::validity, SweepKind::stability})
        names.emplace_back(kind_at(kind).name);
    return names;
}

std::vector<std::string> quantities(SweepKind kind) {
    const std::vector<const char*>& names = kind_at(kind).quantities;
    return {names.begin(), names.end()};
}

std::uint64_t cost_of_point(SweepKind kind) { return kind_at(kind).cost; }

Json subject_json(const SweepSubject& subject, const SweepGrid& grid) {
    return Json{{"schema", "resonform.sweep_parts/1"},
                {"version", RESONFORM_VERSION},
                {"instructions", instruction_set()},
                {"system", subject.system},
                {"scene", subject.scene},
                {"code", subject.code},
                {"over", subject.over},
                {"grid", hash_of(grid)},
                {"sample", json_of(subject.sample)},
                {"what", kind_at(subject.what).name},
                {"tolerance", subject.tolerance},
                {"t", subject.times},
                {"interval", subject.interval},
                {"outputs", subject.outputs},
                {"suffix", subject.suffix}};
}

SweepSubject subject_of(const Json& json) {
    try {
        SweepSubject subject;
        subject.what = kind_named(json.at("what"));
        subject.tolerance = json.at("tolerance");
        subject.system = json.at("system");
        subject.scene = json.at("scene");
        subject.code = json.at("code");
        subject.over = json.at("over").get<std::vector<std::string>>();
        subject.times = json.at("t").get<std::vector<double>>();
        subject.interval = json.at("interval");
        subject.outputs = json.at("outputs").get<std::vector<std::string>>();
        subject.suffix = json.at("suffix");
        if (const Json& sample = json.at("sample"); !sample.is_null())
            subject.sample = SweepSample{sample.at("count"), sample.at("seed")};
        return subject;
    } catch (const Json::exception& wrong) {
        bad_input(Reason::file, {"the description of a sweep must be as it was written",
                                 wrong.what(),
                                 "run the sweep again with another --output",
                                 {}});
    }
}

std::string difference(const Json& one, const Json& other) {
    for (const auto& [key, value] : one.items())
        if (counts(key) && (!other.contains(key) || other.at(key) != value)) return key;
    return "";
}

std::string identity(const Json& subject) {
    std::string text;
    for (const auto& [key, value] : subject.items())
        if (counts(key)) text += key + value.dump();
    return content_hash(text);
}

} // namespace resonform
