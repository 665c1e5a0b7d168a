// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/scope.hpp"

#include "algebra/number/functions.hpp"

#include <algorithm>

namespace resonform {

void Scope::define(const std::string& name, const GiNaC::ex& value) { define_derivative(name, 0, value); }

void Scope::define_derivative(const std::string& name, int primes, const GiNaC::ex& value) {
    values_[{name, primes}] = value;
}

const FunctionValue* Scope::value_of(const std::string& function) const {
    const auto found = functions_.find(function);
    return found != functions_.end() && found->second ? &*found->second : nullptr;
}

const Scope::Data* Scope::data_of(const std::string& function) const {
    const auto found = data_.find(function);
    return found == data_.end() ? nullptr : &found->second;
}

const Scope::Withheld* Scope::withheld(const std::string& name) const {
    const auto found = withheld_.find(name);
    return found == withheld_.end() ? nullptr : &found->second;
}

const GiNaC::ex* Scope::find(const std::string& name, int primes) const {
    const auto found = values_.find({name, primes});
    return found == values_.end() ? nullptr : &found->second;
}

bool Scope::has_derivatives() const {
    return std::any_of(values_.begin(), values_.end(),
                       [](const auto& entry) { return entry.first.second > 0; });
}

std::vector<std::string> Scope::names() const {
    std::vector<std::string> names;
    for (const auto& entry : values_) {
        if (names.empty() || names.back() != entry.first.first) names.push_back(entry.first.first);
    }
    return names;
}

const std::vector<std::string>& function_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const FunctionRow& row : function_rows()) {
            all.emplace_back(row.name);
            if (row.function == Function::logarithm) all.emplace_back("sqrt");
        }
        return all;
    }();
    return names;
}

} // namespace resonform
