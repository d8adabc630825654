# SPDX-License-Identifier: Apache-2.0
# vug_module, which defines the library of a module from its folder.
include(VugKinds)

# vug_module(NAME [FOLDERS folders...] [DEPENDS modules...] [PUBLIC libs...] [PRIVATE libs...]
#            [OPTIONS of the compiler...] [DEFINITIONS...] [HEADERS to precompile...] [LIGHT])
# A module is the folder lib/vug/NAME. All .cpp files at its top level and in FOLDERS are compiled. Folders
# of kinds are added by vug_kinds, which contains the only list of kinds. With VUG_SLICE, a module that is not in
# the slice is the archive of the build VUG_SLICE_BASE (tools/dev/slice). LIGHT modules, which take no time at run
# time, are compiled with -O1, in 0.6 of the time.
function(vug_module name)
  cmake_parse_arguments(ARG "LIGHT" "" "FOLDERS;DEPENDS;PUBLIC;PRIVATE;OPTIONS;DEFINITIONS;HEADERS" ${ARGN})
  list(TRANSFORM ARG_DEPENDS PREPEND vug_)
  if(VUG_SLICE AND NOT name IN_LIST VUG_SLICE)
    add_library(vug_${name} STATIC IMPORTED GLOBAL)
    add_library(Vug::${name} ALIAS vug_${name})
    set_target_properties(vug_${name} PROPERTIES
      IMPORTED_LOCATION ${VUG_SLICE_BASE}/lib/vug/${name}/libvug_${name}.a)
    list(TRANSFORM ARG_PRIVATE REPLACE "(.+)" "$<LINK_ONLY:\\1>")
    target_link_libraries(vug_${name} INTERFACE vug_contract ${ARG_DEPENDS} ${ARG_PUBLIC} ${ARG_PRIVATE})
    return()
  endif()
  list(TRANSFORM ARG_FOLDERS APPEND /*.cpp)
  list(TRANSFORM ARG_FOLDERS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${ARG_FOLDERS})
  add_library(vug_${name} STATIC ${sources})
  add_library(Vug::${name} ALIAS vug_${name})
  set_target_properties(vug_${name} PROPERTIES EXPORT_NAME ${name})
  target_link_libraries(vug_${name} PUBLIC vug_contract ${ARG_DEPENDS} ${ARG_PUBLIC}
    PRIVATE $<BUILD_INTERFACE:vug_strict> $<BUILD_INTERFACE:$<$<BOOL:${ARG_LIGHT}>:vug_light>> ${ARG_PRIVATE})
  target_compile_options(vug_${name} PRIVATE ${ARG_OPTIONS})
  target_compile_definitions(vug_${name} PRIVATE ${ARG_DEFINITIONS})
  set(group modules)
  if(ARG_LIGHT)
    set(group light)
  endif()
  if(ARG_OPTIONS OR ARG_HEADERS)
    set(group ${name})
  endif()
  vug_precompile(vug_${name} ${group} ${ARG_HEADERS})
  vug_public_headers(vug_${name})
  set_property(GLOBAL APPEND PROPERTY VUG_MODULES vug_${name})
endfunction()

# The headers of a module that are installed: all but those whose first comment starts with "Internal to" or "Inside"
# a module (tools/dev/check layers verifies that public headers do not include them). The target
# TARGET_verify_interface_header_sets compiles each of them alone, except the definitions of templates in *_inl.h, which
# their headers include.
function(vug_public_headers target)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
  set(public "")
  set(inline "")
  foreach(header ${headers})
    file(STRINGS ${header} first LIMIT_COUNT 2)
    if(first MATCHES "(^|;)// (Internal|Inside) ")
      continue()
    elseif(header MATCHES "_inl\\.h$")
      list(APPEND inline ${header})
    else()
      list(APPEND public ${header})
    endif()
  endforeach()
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/lib FILES ${public})
  target_sources(${target} PUBLIC FILE_SET inline TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/lib FILES ${inline})
  set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON INTERFACE_HEADER_SETS_TO_VERIFY HEADERS)
endfunction()
