# Headers that most sources include, read by the compiler once: half of the time of a small file.
# Every source names what it needs all the same; the presets clang and tidy do without, so that they
# tell when one does not (CMAKE_DISABLE_PRECOMPILE_HEADERS).
set(VUG_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
  <optional> <set> <span> <string> <string_view> <utility> <variant> <vector> <fmt/format.h> <fmt/ranges.h>)

# vug_precompile(TARGET GROUP headers...)
# The first of a group makes the headers, those above and these, for all others of it, which must be
# compiled with the same flags.
function(vug_precompile target group)
  get_property(first GLOBAL PROPERTY VUG_HEADERS_OF_${group})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${VUG_COMMON_HEADERS} ${ARGN})
    set_property(GLOBAL PROPERTY VUG_HEADERS_OF_${group} ${target})
    # What the compiler makes of them hangs on the folder of the build. For ccache they are what
    # they are made from, so that one build finds what another has compiled.
    set(source "${CMAKE_CXX_COMPILER_VERSION} ${VUG_COMMON_HEADERS} ${ARGN}\n")
    get_property(packages GLOBAL PROPERTY PACKAGES_FOUND)
    foreach(package ${packages})
      string(APPEND source "${package} ${${package}_VERSION}\n")
    endforeach()
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/cmake_pch.hxx.gch.sum
      CONTENT "${source}" @ONLY)
  endif()
endfunction()
