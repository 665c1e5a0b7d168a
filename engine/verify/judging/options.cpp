// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/options.hpp"

#include <utility>

namespace resonform {

std::shared_ptr<const EvaluatorLibrary> library_of(std::shared_ptr<const Program> program,
                                                   const VerifyOptions& options, std::string_view types) {
    if (!options.compiled) return EvaluatorLibrary::interpreted(std::move(program));
    return EvaluatorLibrary::build(*program, options.cache, options.progress, types);
}

} // namespace resonform
