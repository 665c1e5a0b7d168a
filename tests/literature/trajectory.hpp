// SPDX-License-Identifier: GPL-3.0-or-later
// A system followed in doubles, from its equations of first order.
#pragma once

#include "support/exact.hpp"

#include <map>
#include <string>
#include <vector>

namespace resonform::test {

class Trajectory {
public:
    using Values = std::map<std::string, double>;

    // Values of parameters, eps and states ("x", "x'").
    Trajectory(const FirstOrderSystem& system, Values values) : values_(std::move(values)) {
        GiNaC::exmap known{{system.system->eps, values_.at("eps")}};
        for (const Parameter& p : system.system->parameters) known[p.symbol] = values_.at(p.name);
        for (const State& state : system.states) {
            names_.push_back(state.name);
            symbols_.push_back(state.symbol);
            rates_.push_back(state.rate.subs(known));
        }
    }
    // One step of Runge and Kutta.
    void step(double h) {
        const std::vector<double> y = state();
        const auto k1 = rates(y), k2 = rates(sum(y, k1, h / 2)), k3 = rates(sum(y, k2, h / 2)),
                   k4 = rates(sum(y, k3, h));
        for (std::size_t i = 0; i < y.size(); ++i)
            values_[names_[i]] = y[i] + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    [[nodiscard]] double operator[](const std::string& name) const { return values_.at(name); }
    // The rate of a state at this moment.
    [[nodiscard]] double rate(const std::string& name) const {
        const std::vector<double> all = rates(state());
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (names_[i] == name) return all[i];
        throw std::logic_error("no state " + name);
    }

private:
    [[nodiscard]] std::vector<double> state() const {
        std::vector<double> y;
        for (const std::string& name : names_) y.push_back(values_.at(name));
        return y;
    }
    [[nodiscard]] std::vector<double> rates(const std::vector<double>& y) const {
        GiNaC::exmap at;
        for (std::size_t i = 0; i < y.size(); ++i) at[symbols_[i]] = y[i];
        std::vector<double> result;
        for (const GiNaC::ex& rate : rates_)
            result.push_back(GiNaC::ex_to<GiNaC::numeric>(rate.subs(at).evalf()).to_double());
        return result;
    }
    static std::vector<double> sum(std::vector<double> y, const std::vector<double>& k, double h) {
        for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * k[i];
        return y;
    }

    Values values_;
    std::vector<std::string> names_;
    std::vector<GiNaC::symbol> symbols_;
    std::vector<GiNaC::ex> rates_;
};

} // namespace resonform::test
