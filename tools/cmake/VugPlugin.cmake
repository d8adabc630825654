# SPDX-License-Identifier: Apache-2.0
# Plugins for projects that use an installed Vug (docs/guides/plugins.md).
#
#   find_package(Vug REQUIRED)
#   vug_add_plugin(hello hello.cpp ...)
#
# builds hello.so, which exports only its two entry functions: its copy of the library does not conflict
# with that of the program.
function(vug_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX .so CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON CXX_EXTENSIONS OFF)
  target_link_libraries(${name} PRIVATE Vug::loading)
  target_link_options(${name} PRIVATE LINKER:--exclude-libs,ALL LINKER:--no-undefined)
endfunction()
