# SPDX-License-Identifier: Apache-2.0
# Build options and the compile flags shared by all targets.
option(VUG_TESTS "Build the tests" ON)
option(VUG_BENCH "Build the benchmarks" OFF)
option(VUG_FUZZ "Build the libFuzzer targets (needs clang)" OFF)
option(VUG_STUDIO "Build vug-studio, the desktop program, if Qt 6 is installed" ON)
option(VUG_WERROR "Treat warnings as errors; all presets set it" OFF)
option(VUG_TIDY "Run clang-tidy 14 on every source while building" OFF)
set(VUG_SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined")
set(VUG_SLICE "" CACHE STRING "Compile only these modules; the others are archives of VUG_SLICE_BASE (tools/dev/slice)")
set(VUG_SLICE_BASE "" CACHE PATH "The build that provides the archives of the other modules")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
# The presets except dev and tidy set CMAKE_UNITY_BUILD: units of 12 sources compile in a third of the time of single
# sources (docs/explanation/decisions/0032-unity-builds.md).
if(NOT CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 12)
endif()
find_program(VUG_CCACHE ccache)
if(VUG_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # ccache supports precompiled headers only with the first two settings; with the third, a build in one folder finds
  # what was compiled in another.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_PCH_EXTSUM=1
    CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${VUG_CCACHE})
endif()

# Shared libraries that are loaded on first use, and the run path by which programs of the build find them.
include(GNUInstallDirs)
set(VUG_LIBRARY_FOLDER ${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/vug)
set(CMAKE_BUILD_RPATH ${VUG_LIBRARY_FOLDER})
if(VUG_SLICE_BASE)
  list(APPEND CMAKE_BUILD_RPATH ${VUG_SLICE_BASE}/${CMAKE_INSTALL_LIBDIR}/vug)
endif()
# vug_install_rpath(TARGET FOLDER): the run path of a target that is installed in FOLDER, below the prefix.
function(vug_install_rpath target folder)
  cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX})
  file(RELATIVE_PATH libraries ${folder} ${CMAKE_INSTALL_FULL_LIBDIR}/vug)
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries};$ORIGIN")
endfunction()

add_library(vug_contract INTERFACE)
target_compile_features(vug_contract INTERFACE cxx_std_20)
# The baseline is x86-64-v3 (AVX2, processors since 2013). Contraction into FMA is disabled so that all
# machines compute identical results (docs/explanation/decisions/0002-deterministic-arithmetic.md).
target_compile_options(vug_contract INTERFACE -march=x86-64-v3 -ffp-contract=off)
target_include_directories(vug_contract INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/lib> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/lib>
  $<INSTALL_INTERFACE:include>)

# Warnings for our own code, not for consumers: linked PRIVATE by all targets of this project.
add_library(vug_strict INTERFACE)
target_compile_options(vug_strict INTERFACE -Wall -Wextra -Wshadow -Wconversion
  $<$<BOOL:${VUG_WERROR}>:-Werror>)
target_compile_options(vug_strict INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)  # for ccache
# g++ 12 emits false warnings about std::string where it inlines less, or more: at -O1 and in unity builds.
target_compile_options(vug_strict INTERFACE
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-restrict>")
# For code that calls the libraries and need not be fast itself: reduces its compile time by one third.
add_library(vug_light INTERFACE)
target_compile_options(vug_light INTERFACE $<$<CONFIG:Release>:-O1>)
# Our sources are instrumented, system libraries are not; false reports due to the latter are suppressed
# in tests/sanitizers.
if(VUG_SANITIZE)
  target_compile_options(vug_strict INTERFACE -fsanitize=${VUG_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  target_link_options(vug_contract INTERFACE -fsanitize=${VUG_SANITIZE})
endif()
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(VUG_FUZZ)
  # Coverage counters that guide the fuzzer.
  target_compile_options(vug_strict INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(VUG_TIDY)
  find_program(VUG_CLANG_TIDY NAMES clang-tidy-14 REQUIRED)
  set(CMAKE_CXX_CLANG_TIDY ${VUG_CLANG_TIDY} --quiet --warnings-as-errors=*)
endif()
