# SPDX-License-Identifier: GPL-3.0-or-later
# Debian 12 packages, found by name; scripts/packages_*.txt list them and scripts/install_packages.sh
# installs them.
find_package(PkgConfig REQUIRED)
pkg_check_modules(cln REQUIRED IMPORTED_TARGET cln)
pkg_check_modules(gmp REQUIRED IMPORTED_TARGET gmpxx)
pkg_check_modules(ginac REQUIRED IMPORTED_TARGET ginac)
find_package(fmt REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Boost REQUIRED)
find_library(RESONFORM_FLINT flint REQUIRED) # neither has a pkg-config file in Debian 12
find_library(RESONFORM_ARB flint-arb REQUIRED)
# SUNDIALS' own package asks for OpenMP and MPI, which none of these parts uses and clang lacks on a bare machine.
foreach(part cvode arkode nvecserial sunmatrixdense sunlinsoldense)
    find_library(RESONFORM_SUNDIALS_${part} sundials_${part} REQUIRED)
    list(APPEND RESONFORM_SUNDIALS ${RESONFORM_SUNDIALS_${part}})
endforeach()
find_package(MPI QUIET COMPONENTS CXX) # of resonform_mpi, which is left out without it
# For F.h5 of sweeps: the headers; the library is loaded by its soname when it is needed. Left out without them.
find_path(RESONFORM_HDF5_HEADERS hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(RESONFORM_HDF5_LIBRARY NAMES hdf5_serial hdf5)
if(RESONFORM_HDF5_HEADERS AND RESONFORM_HDF5_LIBRARY)
    file(REAL_PATH ${RESONFORM_HDF5_LIBRARY} library)
    string(REGEX REPLACE "(\\.so\\.[0-9]+).*" "\\1" RESONFORM_HDF5 ${library})
endif()
find_library(RESONFORM_QD qd REQUIRED) # its pkg-config file of Debian 12 is broken: -I.../$fortran

# libquadmath belongs to GCC: clang has neither its header's folder nor its library on its paths.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    find_program(RESONFORM_GCC g++ REQUIRED)
    execute_process(COMMAND ${RESONFORM_GCC} -print-file-name=include
        OUTPUT_VARIABLE gcc_include OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    add_compile_options(-idirafter ${gcc_include})
endif()
