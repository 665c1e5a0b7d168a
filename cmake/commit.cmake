# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the source of cli/origin.hpp's source_commit(): the commit that the sources are of, asked at every build.
# cmake -D SOURCE=... -D OUTPUT=... -P commit.cmake; without git, or out of a clone, it is "unknown".
set(commit "")
find_program(git git)
if(git)
    execute_process(COMMAND ${git} describe --always --dirty --abbrev=40 --exclude * WORKING_DIRECTORY ${SOURCE}
        OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT commit MATCHES "^[0-9a-f]+(-dirty)?$")
    set(commit "unknown")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[#include "cli/origin.hpp"

namespace resonform {

const char* source_commit() {
    return "@commit@";
}

} // namespace resonform
]] @ONLY)
