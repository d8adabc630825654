# SPDX-License-Identifier: Apache-2.0
# Image tests for a project that uses an installed Vug: pictures are compared with references.
#
#   find_package(Vug REQUIRED)
#   enable_testing()
#   vug_add_image_test(looks FOLDER tests/looks)
#   vug_add_image_test(hall SCENE hall.vug REFERENCE hall.exr RENDER --size 64x36 --spp 64)
#
# vug_add_image_test(NAME FOLDER folder [OUTPUT folder] [ARGS options of `vug test`...])
#   Adds one test that runs all cases of the folder. A case is a folder with a case.json.
# vug_add_image_test(NAME SCENE file REFERENCE file [RENDER options of `vug render`...]
#                    [LIMITS measure=value...] [LAYERS names...] [MASK file] [ALARM rate]
#                    [OUTPUT folder] [ARGS ...])
#   Adds one case without a case folder.
#
# The reports of failed cases, index.html and junit.xml are written to OUTPUT, by default
# image_tests/NAME in the build folder. The target update_NAME replaces the references by the current
# pictures, with the reason given in the environment: VUG_REASON="..." cmake --build build --target
# update_NAME. The program is Vug_EXECUTABLE.

function(vug_add_image_test name)
  cmake_parse_arguments(ARG "" "FOLDER;SCENE;REFERENCE;MASK;ALARM;OUTPUT" "RENDER;LIMITS;LAYERS;ARGS"
    ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS OR ARG_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "vug_add_image_test(${name}): invalid arguments "
      "'${ARG_UNPARSED_ARGUMENTS}${ARG_KEYWORDS_MISSING_VALUES}'")
  endif()
  if(NOT ARG_OUTPUT)
    set(ARG_OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/image_tests/${name})
  endif()
  if(ARG_SCENE AND ARG_REFERENCE AND NOT ARG_FOLDER)
    vug_write_image_case(${CMAKE_CURRENT_BINARY_DIR}/image_cases/${name})
    set(ARG_FOLDER ${CMAKE_CURRENT_BINARY_DIR}/image_cases/${name})
  elseif(NOT ARG_FOLDER OR ARG_SCENE OR ARG_REFERENCE)
    message(FATAL_ERROR "vug_add_image_test(${name}): pass either FOLDER, or SCENE and REFERENCE")
  endif()
  cmake_path(ABSOLUTE_PATH ARG_FOLDER BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  set(command ${Vug_EXECUTABLE} test ${ARG_FOLDER} ${ARG_ARGS})
  add_test(NAME ${name} COMMAND ${command} --output ${ARG_OUTPUT} --junit ${ARG_OUTPUT}/junit.xml)
  add_custom_target(update_${name} COMMAND ${command} --update VERBATIM USES_TERMINAL)
endfunction()

# Writes the case.json for vug_add_image_test(SCENE ...), from the variables ARG_*.
function(vug_write_image_case folder)
  foreach(file SCENE REFERENCE MASK)
    if(ARG_${file})
      cmake_path(ABSOLUTE_PATH ARG_${file} BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    endif()
  endforeach()
  set(json "{}")
  string(JSON json SET "${json}" reference "\"${ARG_REFERENCE}\"")
  string(JSON json SET "${json}" scene "\"${ARG_SCENE}\"")
  if(ARG_RENDER)
    list(JOIN ARG_RENDER "\", \"" words)
    string(JSON json SET "${json}" render "[\"${words}\"]")
  endif()
  if(ARG_MASK)
    string(JSON json SET "${json}" mask "\"${ARG_MASK}\"")
  endif()
  if(ARG_ALARM)
    string(JSON json SET "${json}" alarm ${ARG_ALARM})
  endif()
  if(ARG_LAYERS)
    list(JOIN ARG_LAYERS "\", \"" layers)
    string(JSON json SET "${json}" layers "[\"${layers}\"]")
  endif()
  if(ARG_LIMITS)
    string(JSON json SET "${json}" limits "{}")
    foreach(limit ${ARG_LIMITS})
      string(REPLACE "=" ";" limit ${limit})
      list(GET limit 0 measure)
      list(GET limit 1 value)
      string(JSON json SET "${json}" limits ${measure} ${value})
    endforeach()
  endif()
  file(CONFIGURE OUTPUT ${folder}/case.json CONTENT "${json}\n" @ONLY)
endfunction()
