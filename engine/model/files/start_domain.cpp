// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/start_domain.hpp"

#include "algebra/number/error.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/regular.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

class StartDomain {
public:
    StartDomain(const Scene& scene, const TomlNode* fix) : scene_(scene), fix_(fix) {
        for (const Variable& v : scene.system->variables)
            if (v.role == Role::slow)
                if (const StartValue* start = scene.start_of(v.name)) values_[v.jet.front()] = start->value;
    }

    void check(const Declaration& declared) const {
        const Estimate estimate = where_regular([&] {
                                      const GiNaC::ex value = scene_.fixed(declared.value.subs(values_));
                                      return scene_.estimate(scene_.system->with_data(value));
                                  }).value_or(Estimate::unbounded);
        if (estimate != Estimate::unknown && estimate != Estimate::positive) complain(declared);
    }

private:
    [[noreturn]] void complain(const Declaration& declared) const {
        const std::string where = declared.source.file + ":" + std::to_string(declared.source.line);
        Diagnostic d{"a motion starts in the declared domain, where " + excerpt(declared.text) + " > 0", "",
                     "give a value inside, or correct [domain] in " + where, whole_file(scene_.file)};
        const auto add = [&](const std::string& name, const std::string& text, const SourceText& source) {
            if (d.value.empty()) d.place = place_of(source);
            d.value += (d.value.empty() ? "" : ", ") + name + " = " + excerpt(text);
        };
        for (const Variable& v : scene_.system->variables)
            if (v.role == Role::slow && declared.value.has(v.jet.front()))
                if (const StartValue* start = scene_.start_of(v.name))
                    add(start->name, start->text, start->source);
        for (const Parameter& p : scene_.system->parameters)
            if (const TomlNode* fixed = fix_ == nullptr ? nullptr : fix_->find(p.name);
                fixed != nullptr && declared.value.has(p.symbol))
                add(p.name, fixed->text, fixed->source);
        bad_input(d);
    }

    const Scene& scene_;
    const TomlNode* fix_;
    GiNaC::exmap values_;
};

// Data are for a range of a slow variable, in which the motion starts.
void check_data(const Scene& scene) {
    for (const NamedFunction& f : scene.system->functions) {
        const StartValue* start = scene.start_of(f.of);
        if (f.data == nullptr || start == nullptr) continue;
        const GiNaC::ex value = scene.fixed(start->value);
        if (!value.info(GiNaC::info_flags::rational)) continue;
        if (f.data->holds(cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N()))) continue;
        bad_input({fmt::format("the data of {} reach from {} to {}", f.name, f.data->breakpoints.front(),
                               f.data->breakpoints.back()),
                   f.of + " = " + excerpt(start->text), "start in between, or give more data",
                   place_of(start->source)});
    }
}

} // namespace

void check_start_domain(const Scene& scene, const TomlNode* fix) {
    check_data(scene);
    const StartDomain start(scene, fix);
    for (const Declaration& declared : scene.system->positive) start.check(declared);
}

} // namespace resonform
