# SPDX-License-Identifier: Apache-2.0
# Kinds and their families: vug_family declares a family, vug_kinds lists its kinds, and vug_registries generates the
# functions that return them. Nothing here needs a target, so tests also run it as a script.

# vug_module_sources(MODULE files...)
# Adds sources to a module if it is compiled here: it is not if it is outside VUG_SLICE, or in a script.
function(vug_module_sources module)
  if(TARGET vug_${module} AND (NOT VUG_SLICE OR module IN_LIST VUG_SLICE))
    target_sources(vug_${module} PRIVATE ${ARGN})
  endif()
endfunction()

# vug_family(MODULE FOLDER FUNCTION TYPE SUFFIX HEADER [SCENE] [VALUES] [NAMESPACE name])
# The kinds in lib/vug/MODULE/FOLDER. FUNCTION() returns a vector of pointers to them, with one `const TYPE*` for each
# NAME listed by vug_kinds, which NAME_SUFFIX() returns. HEADER in the module declares TYPE and FUNCTION; FUNCTION and
# TYPE are names in the namespace vug::MODULE, or vug::NAMESPACE. With SCENE, scenes can call the kinds. With VALUES, the
# vector contains the kinds themselves. A family without FOLDER (-) is computed by its FUNCTION.
function(vug_family module folder function type suffix header)
  cmake_parse_arguments(ARG "SCENE;VALUES" "NAMESPACE" "" ${ARGN})
  if(NOT ARG_NAMESPACE)
    set(ARG_NAMESPACE ${module})
  endif()
  set_property(GLOBAL APPEND PROPERTY VUG_FAMILIES ${module}/${function})
  set_property(GLOBAL PROPERTY VUG_FAMILY_${module}/${function}
    "${folder};${type};${suffix};vug/${module}/${header};${ARG_SCENE};${ARG_VALUES};${ARG_NAMESPACE}")
endfunction()

# vug_kinds(MODULE FOLDER names...)
# Compiles FOLDER/NAME.cpp for each kind and lists the names for vug_registries.
function(vug_kinds module folder)
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE sources)
  list(TRANSFORM sources APPEND .cpp)
  vug_module_sources(${module} ${sources})
  set_property(GLOBAL PROPERTY VUG_KINDS_${module}/${folder} ${ARGN})
endfunction()

# vug_example(INFO FILE HEADER)
# FILE contains the example and the synonyms of the kind whose KindInfo is the expression INFO, declared in HEADER.
# Kinds of vug_kinds do not need it: theirs is FOLDER/NAME.vug, if it exists.
function(vug_example info file header)
  file(READ ${file} text)
  if(NOT CMAKE_SCRIPT_MODE_FILE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endif()
  set_property(GLOBAL APPEND_STRING PROPERTY VUG_EXAMPLES "      {&${info}, R\"vug(${text})vug\"},\n")
  set_property(GLOBAL APPEND PROPERTY VUG_EXAMPLE_HEADERS "#include <${header}>\n")
endfunction()

# vug_registries(FOLDER)
# Writes FOLDER/loading/examples.cpp, which defines vug::loading::kind_texts(), FOLDER/MODULE/families.cpp, which defines the functions of the module's families, and
# FOLDER/loading/scene_families.cpp, which defines vug::loading::scene_families().
function(vug_registries out)
  get_property(families GLOBAL PROPERTY VUG_FAMILIES)
  set(modules "")
  foreach(family ${families})
    get_property(data GLOBAL PROPERTY VUG_FAMILY_${family})
    list(GET data 0 folder)
    list(GET data 1 type)
    list(GET data 2 suffix)
    list(GET data 3 header)
    list(GET data 4 scene)
    list(GET data 5 values)
    list(GET data 6 namespace)
    string(REGEX MATCH "[^/]+" module ${family})
    string(REGEX MATCH "[^/]+$" function ${family})
    set(namespace_${module} ${namespace})
    if(scene)
      list(APPEND scene_headers "#include <${header}>\n")
      string(APPEND scene_calls "  add_family(all, ${namespace}::${function}());\n")
    endif()
    if(NOT folder STREQUAL "-")
      set(returned "const ${type}&")
      set(element "const ${type}*")
      set(address "&")
      if(values)
        set(returned "${type}")
        set(element "${type}")
        set(address "")
      endif()
      set(declarations "")
      set(elements "")
      get_property(kinds GLOBAL PROPERTY VUG_KINDS_${module}/${folder})
      foreach(kind ${kinds})
        string(APPEND declarations "${returned} ${kind}_${suffix}();\n")
        string(APPEND elements "      ${address}${kind}_${suffix}(),\n")
        set(example ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../lib/vug/${module}/${folder}/${kind}.vug)
        if(EXISTS ${example})
          vug_example("::vug::${namespace}::${kind}_${suffix}().info" ${example} ${header})
          string(APPEND example_declarations "namespace vug::${namespace} {\n${returned} ${kind}_${suffix}();\n}\n")
        endif()
      endforeach()
      list(APPEND modules ${module})
      list(APPEND headers_${module} "#include <${header}>\n")
      string(APPEND definitions_${module} "\n${declarations}\nconst std::vector<${element}>& ${function}() {\n"
        "  static const std::vector<${element}> kinds = {\n${elements}  };\n  return kinds;\n}\n")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES modules)
  foreach(module ${modules})
    list(REMOVE_DUPLICATES headers_${module})
    string(CONCAT headers ${headers_${module}})
    file(CONFIGURE OUTPUT ${out}/${module}/families.cpp CONTENT
      "// Generated from lib/families.cmake and lib/vug/${module}/CMakeLists.txt.
${headers}
namespace vug::${namespace_${module}} {
${definitions_${module}}
}  // namespace vug::${namespace_${module}}
" @ONLY)
  endforeach()
  list(REMOVE_DUPLICATES scene_headers)
  string(CONCAT headers ${scene_headers})
  file(CONFIGURE OUTPUT ${out}/loading/scene_families.cpp CONTENT
    "// Generated from lib/families.cmake.
#include <vug/loading/scene_families.h>
${headers}
namespace vug::loading {

std::vector<KindRegistry> scene_families() {
  std::vector<KindRegistry> all;
${scene_calls}  return all;
}

}  // namespace vug::loading
" @ONLY)
  get_property(headers GLOBAL PROPERTY VUG_EXAMPLE_HEADERS)
  list(REMOVE_DUPLICATES headers)
  string(CONCAT headers ${headers})
  get_property(examples GLOBAL PROPERTY VUG_EXAMPLES)
  file(CONFIGURE OUTPUT ${out}/loading/examples.cpp CONTENT
    "// Generated from the examples next to the kinds, lib/vug/*/*/*.vug.
#include <vug/loading/example.h>
${headers}
${example_declarations}
namespace vug::loading {

const std::vector<KindText>& kind_texts() {
  static const std::vector<KindText> all = {
${examples}  };
  return all;
}

}  // namespace vug::loading
" @ONLY)
  foreach(module ${modules})
    vug_module_sources(${module} ${out}/${module}/families.cpp)
  endforeach()
  vug_module_sources(loading ${out}/loading/scene_families.cpp ${out}/loading/examples.cpp)
endfunction()
