// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/integrate.hpp"

#include "verify/integrate/cvode.hpp"
#include "verify/integrate/odeint.hpp"

namespace resonform {

const char* to_string(Method method) {
    switch (method) {
    case Method::taylor: return "Taylor";
    case Method::cvode_adams: return "CVODE Adams";
    case Method::cvode_bdf: return "CVODE BDF";
    case Method::arkode_explicit: return "ARKODE explicit";
    case Method::arkode_implicit: return "ARKODE implicit";
    case Method::dopri5: return "odeint dopri5";
    case Method::fehlberg78: return "odeint fehlberg78";
    case Method::bulirsch_stoer: return "odeint Bulirsch-Stoer";
    case Method::riccati: return "Riccati";
    }
    return "unknown";
}

bool has_dense_output(Method method) { return method != Method::fehlberg78; }

bool has_cheap_output(Method method) { return has_dense_output(method) && method != Method::arkode_explicit; }

std::unique_ptr<Integrator> make_integrator(Method method, RightHandSide rates, const Start& start) {
    switch (method) {
    case Method::cvode_adams:
    case Method::cvode_bdf: return make_cvode(method, rates, start);
    case Method::arkode_explicit:
    case Method::arkode_implicit: return make_arkode(method, rates, start);
    default: return make_odeint(method, rates, start);
    }
}

IntegrationResult integrate(Method method, const Tape& tape, const std::vector<double>& parameters,
                            double eps, const std::vector<double>& start, const std::vector<double>& times,
                            double tolerance) {
    if (method == Method::taylor) return integrate_taylor(tape, parameters, eps, start, times, tolerance);
    BoundTape<double> bound(tape, parameters, eps);
    const auto call = [](const void* context, const double* state, double* rates) {
        // It keeps its registers; nobody else has it.
        static_cast<BoundTape<double>*>(const_cast<void*>(context))->evaluate(state, rates);
    };
    Start from{start, tolerance, {}};
    for (std::size_t i = 0; i < start.size(); ++i) from.wanted.push_back(i);
    IntegrationResult result;
    result.values.assign(start.size(), std::vector<double>(times.size(), 0.0));
    const Run run = make_integrator(method, {call, &bound}, from)->run(times, result.values);
    result.steps = run.steps;
    result.evaluations = run.evaluations;
    result.failure = run.failure;
    return result;
}

} // namespace resonform
