# Writes the source of emit/cpp/embedded_text.hpp: what emitted code is made of, as strings.
#
#   runtime  the headers of runtime/ in the order of their includes (each header's own includes come before
#            it). Each keeps its include guard, so that a file with these texts and one that includes the
#            headers go together in one program, in any order.
#   frames   each file of emit/cpp/frames by its name
function(add_embedded_text target)
    set(runtime "")
    foreach(header status float128 math lanes twice in_range digits scaled walk rows pieces panels table flow interval bounds layer phase decay gauss flow_panel final_sums final_point report points
            kernel/view kernel/scene kernel/chebyshev_powers kernel/chebyshev kernel/amplitude_rows kernel/phase_rows
            kernel/parts kernel/atoms kernel/tables kernel/lanes kernel/block spline callable pack_lanes pack pack_pair ensemble kernel/batch kernel/grid batch tabulated)
        set(file ${CMAKE_SOURCE_DIR}/engine/runtime/${header}.hpp)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} text)
        string(REGEX REPLACE "// SPDX[^\n]*\n" "" text "${text}")
        string(REGEX REPLACE "#include \"runtime/[^\n]*\n" "" text "${text}")
        string(APPEND runtime "        R\"resonform_text(${text})resonform_text\",\n")
    endforeach()
    set(frames "")
    file(GLOB files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/engine/emit/cpp/frames/*.txt)
    foreach(file ${files})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        get_filename_component(name ${file} NAME_WE)
        file(READ ${file} text)
        string(APPEND frames "const std::string_view ${name} = R\"resonform_text(${text})resonform_text\";\n")
    endforeach()
    set(source ${CMAKE_BINARY_DIR}/embedded_text.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT [[#include "emit/cpp/embedded_text.hpp"

namespace resonform {

const std::vector<std::string_view>& runtime_texts() {
    static const std::vector<std::string_view> texts{
@runtime@    };
    return texts;
}

namespace frames {
@frames@} // namespace frames

} // namespace resonform
]] @ONLY)
    target_sources(${target} PRIVATE ${source})
endfunction()
