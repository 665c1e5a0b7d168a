# SPDX-License-Identifier: GPL-3.0-or-later
# resonform::batch: the loops of engine/runtime/kernel for each width of the processor, chosen at run time.
set(widths ${CMAKE_SOURCE_DIR}/engine/runtime/widths)
add_library(batch STATIC ${widths}/choose.cpp ${widths}/baseline.cpp)
add_library(resonform::batch ALIAS batch)
target_include_directories(batch PRIVATE ${CMAKE_SOURCE_DIR}/engine)
target_link_libraries(batch PUBLIC runtime) # cmake/install.cmake
target_compile_definitions(batch INTERFACE RESONFORM_BATCH) # runtime/tabulated.hpp calls these loops
target_compile_options(batch PRIVATE ${RESONFORM_WARNINGS})
set_target_properties(batch PROPERTIES UNITY_BUILD OFF OUTPUT_NAME resonform_batch)
# No signal and no errno is asked for; NaN and infinity count as ever.
set(loops -O3 -fno-math-errno -fno-trapping-math -fno-exceptions)
set_source_files_properties(${widths}/baseline.cpp PROPERTIES COMPILE_OPTIONS "${loops}")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_sources(batch PRIVATE ${widths}/avx2.cpp ${widths}/avx512.cpp)
    target_compile_definitions(batch PRIVATE RESONFORM_X86_WIDTHS)
    set_source_files_properties(${widths}/avx2.cpp PROPERTIES COMPILE_OPTIONS "${loops};-mavx2;-mfma")
    set_source_files_properties(${widths}/avx512.cpp PROPERTIES
        COMPILE_OPTIONS "${loops};-mavx512f;-mavx512dq;-mavx512vl;-mfma;-mprefer-vector-width=512")
endif()
