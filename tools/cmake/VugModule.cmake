# vug_module(NAME [FOLDERS folders...] [DEPENDS modules...] [PUBLIC libs...] [PRIVATE libs...]
#            [OPTIONS of the compiler...] [HEADERS to precompile...])
# A module is the folder lib/vug/NAME. All .cpp files at its top level and in FOLDERS are compiled. Folders
# of kinds are added by vug_kinds, which contains the only list of kinds.
function(vug_module name)
  cmake_parse_arguments(ARG "" "" "FOLDERS;DEPENDS;PUBLIC;PRIVATE;OPTIONS;HEADERS" ${ARGN})
  list(TRANSFORM ARG_FOLDERS APPEND /*.cpp)
  list(TRANSFORM ARG_FOLDERS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${ARG_FOLDERS})
  add_library(vug_${name} STATIC ${sources})
  add_library(Vug::${name} ALIAS vug_${name})
  set_target_properties(vug_${name} PROPERTIES EXPORT_NAME ${name})
  list(TRANSFORM ARG_DEPENDS PREPEND vug_)
  target_link_libraries(vug_${name} PUBLIC vug_contract ${ARG_DEPENDS} ${ARG_PUBLIC}
    PRIVATE $<BUILD_INTERFACE:vug_strict> ${ARG_PRIVATE})
  target_compile_options(vug_${name} PRIVATE ${ARG_OPTIONS})
  set(group modules)
  if(ARG_OPTIONS OR ARG_HEADERS)
    set(group ${name})
  endif()
  vug_precompile(vug_${name} ${group} ${ARG_HEADERS})
  set_property(GLOBAL APPEND PROPERTY VUG_MODULES vug_${name})
endfunction()

# vug_kinds(MODULE FOLDER names...)
# Compiles FOLDER/NAME.cpp for each kind and writes <vug/MODULE/FOLDER_kinds.inc> with one line
# VUG_KIND(NAME) per kind, from which the module's registry is generated.
function(vug_kinds module folder)
  set(lines "")
  foreach(kind ${ARGN})
    target_sources(vug_${module} PRIVATE ${folder}/${kind}.cpp)
    string(APPEND lines "VUG_KIND(${kind})\n")
  endforeach()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/lib/vug/${module}/${folder}_kinds.inc
    CONTENT "${lines}" @ONLY)
endfunction()
