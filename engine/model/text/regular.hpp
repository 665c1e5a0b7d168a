// SPDX-License-Identifier: GPL-3.0-or-later
// GiNaC throws where it divides by zero, but the type depends on the place: a domain_error of functions and
// powers (pole_error is one), overflow_error of numbers and of normal(), runtime_exception of CLN.
#pragma once

#include <cln/exception.h>
#include <ginac/ginac.h>

#include <optional>
#include <stdexcept>

namespace resonform {

// Returns build(); nullopt: it divides by zero, or takes log(0), on its way. The engine's errors pass.
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
