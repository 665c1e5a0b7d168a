# SPDX-License-Identifier: GPL-3.0-or-later
# One static library per room, a folder of engine/; every .cpp in it, at any depth, belongs to it.
set(RESONFORM_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # False alarms of g++ 12 at -O2: overlaps in "a" + std::string (GCC bug 105651), unset members in
    # moves of std::variant (bug 105562). clang and the sanitizers look for the real ones.
    list(APPEND RESONFORM_WARNINGS -Wno-restrict -Wno-maybe-uninitialized)
endif()

if(CMAKE_UNITY_BUILD)
    # Several files in one: a local name may hide one of another file, and what a file keeps in its anonymous
    # namespace looks to g++ as if a header did. The debug build, file by file, warns.
    list(APPEND RESONFORM_WARNINGS -Wno-shadow)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        list(APPEND RESONFORM_WARNINGS -Wno-subobject-linkage)
    endif()
endif()

option(RESONFORM_TESTS "build the tests" ON)
set(RESONFORM_SANITIZE "" CACHE STRING "sanitizers for everything, e.g. address,undefined")
if(RESONFORM_SANITIZE)
    add_compile_options(-fsanitize=${RESONFORM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${RESONFORM_SANITIZE})
endif()

function(add_room name)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/engine/${name}/*.cpp)
    add_library(${name} STATIC ${sources})
    target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR}/engine)
    target_link_libraries(${name} ${ARGN})
    target_compile_options(${name} PRIVATE ${RESONFORM_WARNINGS})
endfunction()

# resonform, and resonform_mpi where MPI is found: the same commands with another main.
function(add_commands)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/engine/cli/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/cli/main\\.cpp$")
    set(commit ${CMAKE_BINARY_DIR}/source_commit.cpp)
    add_custom_target(source_commit BYPRODUCTS ${commit} COMMENT "" COMMAND ${CMAKE_COMMAND}
        -D SOURCE=${CMAKE_SOURCE_DIR} -D OUTPUT=${commit} -P ${CMAKE_SOURCE_DIR}/cmake/commit.cmake)
    add_library(command OBJECT ${sources} ${commit})
    set_source_files_properties(${commit} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    add_dependencies(command source_commit)
    target_link_libraries(command PUBLIC verify CLI11::CLI11 nlohmann_json::nlohmann_json)
    target_compile_options(command PRIVATE ${RESONFORM_WARNINGS})
    add_executable(resonform engine/cli/main.cpp)
    target_compile_options(resonform PRIVATE ${RESONFORM_WARNINGS})
    target_link_libraries(resonform PRIVATE command)
    if(MPI_CXX_FOUND)
        add_executable(resonform_mpi engine/mpi/main.cpp)
        target_compile_options(resonform_mpi PRIVATE ${RESONFORM_WARNINGS})
        target_link_libraries(resonform_mpi PRIVATE command MPI::MPI_CXX)
    endif()
endfunction()
