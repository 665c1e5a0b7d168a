// SPDX-License-Identifier: GPL-3.0-or-later
// Where GiNaC divides by zero it throws, and what it throws depends on the place: a domain_error of functions
// and powers (pole_error is one), overflow_error of numbers and of normal(), runtime_exception of CLN.
#pragma once

#include <cln/exception.h>
#include <ginac/ginac.h>

#include <optional>
#include <stdexcept>

namespace resonform {

// What `build` returns; nullopt: it divides by zero, or takes log(0), on its way. Errors of the house pass.
template <class Build> auto where_regular(const Build& build) -> std::optional<decltype(build())> {
    try {
        return build();
    } catch (const std::domain_error&) {
    } catch (const std::overflow_error&) {
    } catch (const cln::runtime_exception&) {
    }
    return std::nullopt;
}

} // namespace resonform
