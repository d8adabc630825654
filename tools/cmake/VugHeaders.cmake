# SPDX-License-Identifier: Apache-2.0
# Precompiled headers that most sources include, which saves half of the compile time of a small file.
# Sources still include everything they need; the presets clang and tidy disable precompiled headers
# (CMAKE_DISABLE_PRECOMPILE_HEADERS) and thus detect missing includes.
set(VUG_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
  <optional> <set> <span> <string> <string_view> <utility> <variant> <vector> <fmt/format.h> <fmt/ranges.h>)

# vug_precompile(TARGET GROUP headers...)
# The first target of a group precompiles the headers above and those given, for all other targets of
# the group, which must be compiled with the same flags.
function(vug_precompile target group)
  get_property(first GLOBAL PROPERTY VUG_HEADERS_OF_${group})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${VUG_COMMON_HEADERS} ${ARGN})
    set_property(GLOBAL PROPERTY VUG_HEADERS_OF_${group} ${target})
    # The precompiled file depends on the build folder. This checksum file makes ccache identify it by its
    # inputs instead, so that builds share cached objects.
    set(source "${CMAKE_CXX_COMPILER_VERSION} ${VUG_COMMON_HEADERS} ${ARGN}\n")
    get_property(packages GLOBAL PROPERTY PACKAGES_FOUND)
    foreach(package ${packages})
      string(APPEND source "${package} ${${package}_VERSION}\n")
    endforeach()
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/cmake_pch.hxx.gch.sum
      CONTENT "${source}" @ONLY)
  endif()
endfunction()
