// SPDX-License-Identifier: GPL-3.0-or-later
// How a scene is verified.
#pragma once

#include "emit/program/program.hpp"
#include "verify/estimate/error_estimate.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/judging/guarantee.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace resonform {

struct VerifyOptions {
    // Integrations and compiled evaluators, by content hash; empty: no integration is kept.
    std::filesystem::path cache;
    std::function<void(const std::string&)> progress;
    // The guaranteed orders of a scene; empty: the count of weights alone, which derives nothing.
    std::function<Guarantees(const Scene&, const Solution&, const Claims&)> guarantee;
    // Estimated errors at these eps; empty: none.
    std::function<ErrorEstimates(const Scene&, const Solution&, const std::vector<Rational>&)> estimate;
    std::size_t emitted_starts = 50; // of emitted = symbolic, with 20 times each
    bool compiled = true;            // false: programs are interpreted, and no compiler is waited for
    bool liars = false;              // try them, too (verify/judging/lies.hpp)
};

// The emitted code of a scene, compiled (for these types, as emit_library has them) or interpreted.
std::shared_ptr<const EvaluatorLibrary> library_of(std::shared_ptr<const Program> program,
                                                   const VerifyOptions& options, std::string_view types);

} // namespace resonform
