# Writes the source of emit/cpp/runtime_text.hpp: the headers of runtime/ as strings, in the order of their
# includes (each header's own includes come before it). Each keeps its include guard, so that a file with
# these texts and one that includes the headers go together in one program, in any order.
function(add_runtime_text target)
    set(literals "")
    foreach(header status float128 math scaled twice panels table flow interval layer phase)
        set(file ${CMAKE_SOURCE_DIR}/engine/runtime/${header}.hpp)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} text)
        string(REGEX REPLACE "// SPDX[^\n]*\n" "" text "${text}")
        string(REGEX REPLACE "#include \"runtime/[^\n]*\n" "" text "${text}")
        string(APPEND literals "        R\"resonform_text(${text})resonform_text\",\n")
    endforeach()
    set(source ${CMAKE_BINARY_DIR}/runtime_text.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT [[#include "emit/cpp/runtime_text.hpp"

namespace resonform {

const std::vector<std::string_view>& runtime_texts() {
    static const std::vector<std::string_view> texts{
@literals@    };
    return texts;
}

} // namespace resonform
]] @ONLY)
    target_sources(${target} PRIVATE ${source})
endfunction()
