// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.hpp"

#include "cli/arguments.hpp"
#include "model/system/style.hpp"
#include "normalize/recursion/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace resonform {

Text add_text(CLI::App& command, const std::string& name, const std::string& values, const std::string& help,
              const std::string& default_text) {
    auto text = std::make_shared<std::string>(default_text);
    CLI::Option* option = command.add_option(name, *text, help)->type_name(values);
    if (!default_text.empty()) option->capture_default_str();
    return text;
}

Text add_required(CLI::App& command, const std::string& name, const std::string& values,
                  const std::string& help) {
    auto text = std::make_shared<std::string>();
    command.add_option(name, *text, help)->type_name(values)->required();
    return text;
}

Text add_output(CLI::App& command, const std::string& name, const std::string& values,
                const std::string& help) {
    auto path = std::make_shared<std::string>();
    const auto keep = [path, option = name.substr(name.find("--"))](const std::string& given) {
        if (given.empty())
            bad_argument(option, "the path must not be empty", "", "give a path, or leave it out");
        *path = given;
    };
    command.add_option_function<std::string>(name, keep, help)->type_name(values);
    return path;
}

Texts add_settings(CLI::App& command) {
    auto texts = std::make_shared<std::vector<std::string>>();
    command.add_option("--set", *texts, "exact numbers in place of parameters: g=1 r=4/5")
        ->type_name("NAME=VALUE");
    return texts;
}

Text add_style(CLI::App& command) {
    return add_text(command, "--style", fmt::format("{}", fmt::join(style_names(), "|")),
                    "which normal form, in place of the style of the system file");
}

Text add_digits(CLI::App& command) {
    return add_text(command, "--digits", fmt::format("{}..{}", fewest_digits, most_digits),
                    "coefficients in numbers of so many digits, for systems that are too large for symbols; "
                    "wants --set for every parameter; default: exact coefficients");
}

FormatOption::FormatOption(CLI::App& command, std::vector<std::string> known)
    : known_(std::move(known)), text_(add_text(command, "--format", fmt::format("{}", fmt::join(known_, "|")),
                                               "how to print", known_.front())) {}

std::string FormatOption::value() const { return read_choice("--format", *text_, known_); }

} // namespace resonform
