// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate.hpp"

#include "verify/cvode.hpp"
#include "verify/odeint.hpp"

namespace resonform {

const char* to_string(Method method) {
    switch (method) {
    case Method::taylor: return "Taylor";
    case Method::cvode_adams: return "CVODE Adams";
    case Method::cvode_bdf: return "CVODE BDF";
    case Method::dopri5: return "odeint dopri5";
    case Method::fehlberg78: return "odeint fehlberg78";
    }
    return "unknown";
}

IntegrationResult integrate(Method method, const Tape& tape, const std::vector<double>& parameters,
                            double eps, const std::vector<double>& start, const std::vector<double>& times,
                            double tolerance) {
    switch (method) {
    case Method::taylor: return integrate_taylor(tape, parameters, eps, start, times, tolerance);
    case Method::cvode_adams:
    case Method::cvode_bdf:
        return integrate_cvode(method, BoundTape<double>(tape, parameters, eps), start, times, tolerance);
    case Method::dopri5:
    case Method::fehlberg78:
        return integrate_odeint(method, BoundTape<double>(tape, parameters, eps), start, times, tolerance);
    }
    return {};
}

} // namespace resonform
