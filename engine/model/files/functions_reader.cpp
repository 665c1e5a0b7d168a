// SPDX-License-Identifier: GPL-3.0-or-later
// What functions depend on, and the values that a scene gives to those that are known by their names only.
#include "algebra/number/error.hpp"
#include "model/files/read_system.hpp"
#include "model/files/samples.hpp"
#include "model/files/spline.hpp"
#include "model/files/system_reader.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/expression.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"

#include <fmt/format.h>

#include <utility>

namespace resonform {

std::string SystemReader::argument_of(const TomlEntry& entry) const {
    const TomlNode* of = entry.value.find("of");
    const std::string hint = "write " + entry.key + " = { of = [\"tau\"] }";
    if (of == nullptr || of->type != TomlNode::Type::array || of->items.size() != 1)
        bad_input({"the function is not declared with the one name that it is a function of",
                   in_quotes(entry.key), hint, of == nullptr ? entry.place : place_of(of->source)});
    std::string name = string_of(of->items.front());
    const Variable* variable = system_.variable(name);
    if (system_.parameter(name) == nullptr && (variable == nullptr || variable->role != Role::slow)) {
        std::vector<std::string> known;
        for (const Parameter& p : system_.parameters) known.push_back(p.name);
        for (const Variable& v : system_.variables)
            if (v.role == Role::slow) known.push_back(v.name);
        bad_value(of->items.front(), "a declared function depends on neither a slow variable nor a parameter",
                  suggest(name, known));
    }
    return name;
}

// Each function has its value, and each value its function.
void SystemReader::give_values() {
    if (values_ == nullptr) return;
    if (values_->table != nullptr) check_table(*values_->table);
    std::vector<std::string> names;
    for (const NamedFunction& f : system_.functions) names.push_back(f.name);
    if (values_->table != nullptr)
        for (const TomlEntry& entry : values_->table->entries)
            if (system_.function(entry.key) == nullptr)
                bad_input(
                    Reason::name,
                    {"[functions] of a scene gives values to functions of its system", in_quotes(entry.key),
                     names.empty() ? "the system has none: remove the table" : suggest(entry.key, names),
                     entry.place});
    for (NamedFunction& f : system_.functions) {
        const TomlNode* node = values_->table == nullptr ? nullptr : values_->table->find(f.name);
        if (node == nullptr)
            bad_input(
                {"a scene gives a value to every function that its system knows by its name only",
                 "no value of " + in_quotes(f.name),
                 "write under [functions] its expression, as " + f.name + " = \"sqrt(1 + " + f.of + "^2)\"",
                 values_->place});
        if (node->type == TomlNode::Type::table && node->find("callable") != nullptr)
            read_callable(f, *node);
        else if (node->type == TomlNode::Type::table)
            read_data(f, *node);
        else
            f.value = value_of(f, *node);
    }
}

// An expression in the argument and parameters.
FunctionValue SystemReader::value_of(const NamedFunction& function, const TomlNode& node) const {
    FunctionValue result{GiNaC::symbol(function.of), 0};
    Scope scope;
    for (const Parameter& p : system_.parameters) scope.define(p.name, p.symbol);
    scope.define(function.of, result.argument);
    result.value = expression_of(node, scope);
    return result;
}

namespace {

// To see what the samples leave open: the last one stays.
DataPointer through_every_other(const Samples& samples, const std::string& name) {
    std::vector<double> x, y;
    for (std::size_t k = 0; k < samples.x.size(); ++k) {
        if (k % 2 != 0 && k + 1 != samples.x.size()) continue;
        x.push_back(samples.x[k]);
        y.push_back(samples.y[k]);
    }
    if (x.size() < static_cast<std::size_t>(samples.degree) + 1) return nullptr;
    PiecewisePolynomial data = spline_through(x, y, samples.degree);
    data.name = name;
    return std::make_shared<const PiecewisePolynomial>(std::move(data));
}

} // namespace

void SystemReader::require_slow_argument(const NamedFunction& function, const TomlNode& node,
                                         const std::string& what) const {
    if (system_.variable(function.of) == nullptr)
        bad_value(node, what + " a function of a slow variable, and " + function.of + " is a parameter",
                  "write its value as an expression");
}

// An object that emitted code is given. Its sign is seen only where it is called.
void SystemReader::read_callable(NamedFunction& function, const TomlNode& node) const {
    check_keys(node, {"callable"});
    const TomlNode& callable = *node.find("callable");
    if (!boolean_of(callable))
        bad_value(callable, "callable = false gives no value of " + function.name,
                  "write callable = true, an expression, or data");
    require_slow_argument(function, node, "a callable is");
    if (function.nonzero && !function.positive)
        bad_value(node,
                  "the system declares " + function.name +
                      " nonzero, and of a callable only that it is positive can be tested where it is called",
                  "declare it positive, or give an expression");
    function.callable = place_of(node.source);
}

// A spline through the columns of a file beside the scene.
void SystemReader::read_data(NamedFunction& function, const TomlNode& node) const {
    require_slow_argument(function, node, "data give");
    const Samples samples = read_samples(node, values_->place.file);
    PiecewisePolynomial data = spline_through(samples.x, samples.y, samples.degree);
    data.name = function.name;
    if (function.nonzero) {
        const int sign = data.sign();
        if (function.positive ? sign <= 0 : sign == 0)
            bad_value(node,
                      "the system declares " + function.name +
                          (function.positive ? " positive" : " nonzero") +
                          ", and the spline through the data is not proved to be so on its range",
                      "correct the data, or sample them more densely");
    }
    function.coarse_data = through_every_other(samples, function.name);
    function.data = std::make_shared<const PiecewisePolynomial>(std::move(data));
    function.data_text = fmt::format("spline of degree {} through {} points of {} ({}, {})", samples.degree,
                                     samples.x.size(), samples.file, samples.columns[0], samples.columns[1]);
}

void SystemReader::check_given_signs() const {
    for (const NamedFunction& f : system_.functions) {
        if (!f.value || !f.nonzero) continue;
        const Variable* variable = system_.variable(f.of);
        const GiNaC::ex value =
            f.value->at(variable != nullptr ? variable->jet.front() : system_.parameter(f.of)->symbol);
        if (f.positive ? provably_positive(value, system_) : provably_nonzero(value, system_)) continue;
        const std::string sign = f.positive ? "positive" : "nonzero";
        bad_value(*values_->table->find(f.name),
                  "the system declares " + f.name + " " + sign +
                      ", and its value is not proved to be so wherever " + f.of + " lies in the domain",
                  "give another value; or let the sign bound the motion: write positive = [\"" + f.name +
                      "(" + f.of + ")\"] under [domain] of the system");
    }
}

} // namespace resonform
