# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install, and what find_package(resonform) reads: the command with its systems, resonform::runtime (the
# headers that emitted code includes, and generated/), resonform::batch. engine/verify/run/installation.cpp knows
# these folders.
include(CMakePackageConfigHelpers)
set(install_headers include/resonform)
set(install_package lib/cmake/resonform)

add_library(runtime INTERFACE)
add_library(resonform::runtime ALIAS runtime)
target_compile_features(runtime INTERFACE cxx_std_20)
target_include_directories(runtime INTERFACE
    "$<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/engine;${CMAKE_SOURCE_DIR}>" $<INSTALL_INTERFACE:${install_headers}>)

install(TARGETS resonform RUNTIME DESTINATION bin)
if(TARGET resonform_mpi)
    install(TARGETS resonform_mpi RUNTIME DESTINATION bin)
endif()
install(TARGETS runtime batch EXPORT resonform ARCHIVE DESTINATION lib)
install(EXPORT resonform NAMESPACE resonform:: FILE resonformConfig.cmake DESTINATION ${install_package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/resonformConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/resonformConfigVersion.cmake DESTINATION ${install_package})
install(DIRECTORY engine/runtime generated DESTINATION ${install_headers} FILES_MATCHING PATTERN *.hpp PATTERN widths EXCLUDE)
install(DIRECTORY systems DESTINATION share/resonform)
install(FILES LICENSE LICENSES/MIT.txt LICENSES/README.md DESTINATION share/doc/resonform)
