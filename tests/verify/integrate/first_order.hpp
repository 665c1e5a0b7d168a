// SPDX-License-Identifier: GPL-3.0-or-later
// First-order systems made by hand, without a file.
#pragma once

#include "model/exact/first_order_system.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace resonform::test {

// Parameters first, then states, then the rates of the states.
class Builder {
public:
    GiNaC::symbol parameter(const std::string& name) {
        system_->parameters.push_back({name, true, true, "", GiNaC::symbol(name), {}});
        return system_->parameters.back().symbol;
    }
    GiNaC::symbol state(const std::string& name) {
        states_.push_back({name, states_.size(), 0, GiNaC::symbol(name), GiNaC::ex(0)});
        return states_.back().symbol;
    }
    [[nodiscard]] GiNaC::symbol eps() const { return system_->eps; }
    FirstOrderSystem build(const std::vector<GiNaC::ex>& rates) {
        for (std::size_t i = 0; i < rates.size(); ++i) states_[i].rate = rates[i];
        return {system_, states_};
    }
    [[nodiscard]] const System& system() const { return *system_; }

private:
    std::shared_ptr<System> system_ = std::make_shared<System>();
    std::vector<State> states_;
};

// The almost holonomic pendulum, eq. (15), states psi, psi', x, y, xi; parameters g, r, v.
inline FirstOrderSystem almost_holonomic_pendulum() {
    Builder b;
    const GiNaC::symbol g = b.parameter("g"), r = b.parameter("r"), v = b.parameter("v");
    const GiNaC::symbol psi = b.state("psi"), p = b.state("psi'"), x = b.state("x"), y = b.state("y"),
                        xi = b.state("xi");
    const GiNaC::ex s = pow(xi, 2) + pow(r, 2), rate = b.eps() * v;
    return b.build({p, (-xi * rate * p - g * sqrt(s) * sin(psi) + r * xi * pow(rate, 2) / s) / s,
                    (r * cos(psi) - xi * sin(psi)) / sqrt(s) * rate,
                    (r * sin(psi) + xi * cos(psi)) / sqrt(s) * rate, rate});
}

} // namespace resonform::test
