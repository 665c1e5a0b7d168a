// SPDX-License-Identifier: GPL-3.0-or-later
// resonform certify SYSTEM --order N: is the normal form right, by the second route?
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/watch.hpp"
#include "emit/display/json.hpp"
#include "model/files/read_system.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace resonform {

namespace {

Json to_json(const System& system, const Certificate& certificate) {
    Json document = json_head("resonform.certificate/1", system);
    document.update(Json{{"holds", certificate.holds},
                         {"through_weight", json_rational(certificate.through_weight)},
                         {"residual_zero", certificate.residual_zero},
                         {"normal_form_scan", certificate.normal_form_scan},
                         {"route", certificate.route},
                         {"points", certificate.points},
                         {"primes", certificate.primes},
                         {"error_probability", json_number(certificate.error_probability)},
                         {"complaint", certificate.complaint}});
    return document;
}

void print_text(const System& system, const Certificate& certificate) {
    put("{}: normal form and map through weight {}\n", system.name_with_settings(),
        to_string(certificate.through_weight));
    put("  map and normal form put into the original equations   {}\n",
        !certificate.residual_zero ? "RESIDUAL NOT ZERO"
        : system.digits > 0        ? "residual small"
                                   : "residual zero");
    put("  {}        {}\n",
        system.style == Style::poincare ? "every term resonant, no kernel term in the map"
                                        : "normal form and map are those of the style    ",
        certificate.normal_form_scan ? "yes" : "NO");
    put("  route: {}, {} points, primes {}\n", certificate.route, certificate.points,
        fmt::join(certificate.primes, ", "));
    if (certificate.holds && system.digits > 0)
        put("The certificate holds: all residuals are small, to more than {} digits.\n", system.digits);
    else if (certificate.holds)
        put("The certificate holds; a wrong result would pass with probability below {:.0e}.\n",
            certificate.error_probability);
    else
        put("The certificate does NOT hold: {}\n", certificate.complaint);
}

std::shared_ptr<const Normalization> checked(const std::string& argument, const std::string& order,
                                             const SystemChanges& changes, const DerivationLimits& limits) {
    const Home home = find_home();
    const auto file = find_system(argument, home);
    return watched(limits, [&](Watch& watch) {
        const auto system = std::make_shared<const System>(changed_system(file, changes, home));
        const int through = read_order("--order", order, system->eps_root);
        return normalize_with_certificate(expand_system(system, watch), through, watch);
    });
}

int run_certify(const std::string& argument, const std::string& order, const SystemChanges& changes,
                const DerivationLimits& limits, const std::string& format) {
    const auto normalization = checked(argument, order, changes, limits);
    const System& system = normalization->normal_form.field->system();
    if (format == "json")
        put("{}", document_text(to_json(system, normalization->certificate)));
    else
        print_text(system, normalization->certificate);
    return normalization->certificate.holds ? done : check_failed;
}

} // namespace

void add_certify(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand(
        "certify",
        "check the normal form by a second route, with the probability that a wrong one would pass");
    const Text system = add_required(*command, "SYSTEM", "", system_help);
    const Text order = add_required(*command, "--order", order_values, "weight of normal form and map");
    const FormatOption format(*command, {"text", "json"});
    const Text style = add_style(*command);
    const Text digits = add_digits(*command);
    const Texts settings = add_settings(*command);
    const LimitOptions limits(*command);
    on_choice(*command, action, [=] {
        return run_certify(*system, *order,
                           {read_settings(*settings), read_style(*style), read_digits(*digits)},
                           limits.value(), format.value());
    });
}

} // namespace resonform
