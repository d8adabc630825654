# Plugins of a project that uses an installed Vug (docs/guides/plugins.md).
#
#   find_package(Vug REQUIRED)
#   vug_add_plugin(hello hello.cpp ...)
#
# makes hello.so. Nothing of it is seen but the two functions through which it is entered: its
# copies of the library and the program's do not meet.
function(vug_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX .so CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON CXX_EXTENSIONS OFF)
  target_link_libraries(${name} PRIVATE Vug::loading)
  target_link_options(${name} PRIVATE LINKER:--exclude-libs,ALL LINKER:--no-undefined)
endfunction()
