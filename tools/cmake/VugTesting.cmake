# SPDX-License-Identifier: Apache-2.0
# Functions that define tests: vug_test, vug_fuzz and vug_bench.
include(GoogleTest)

# vug_test(NAME SOURCES... LINK modules... [LABEL labels...] [SLOW patterns...])
# Adds an executable of unit tests, mirroring lib/. All its tests get the labels, `unit` by default, except
# those that match one of the SLOW patterns of googletest (Suite.Name, with *), which get the label `slow`.
# `ctest -L unit` must finish within a minute on two cores: give slower tests the label `slow`.
function(vug_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;LABEL;SLOW" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  list(TRANSFORM ARG_LINK PREPEND vug_)
  target_link_libraries(test_${name} PRIVATE vug_strict vug_light ${ARG_LINK} GTest::gtest_main)
  target_compile_definitions(test_${name} PRIVATE
    VUG_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data" VUG_DATA="${PROJECT_SOURCE_DIR}/data")
  # Sharing precompiled headers builds the program that owns them; a slice shares them within a folder only.
  set(group tests)
  if(VUG_SLICE)
    cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME folder)
    string(APPEND group _${folder})
  endif()
  vug_precompile(test_${name} ${group} <gtest/gtest.h>)
  if(NOT ARG_LABEL)
    set(ARG_LABEL unit)
  endif()
  # Several labels cannot be passed to gtest_discover_tests, therefore a script sets them in ctest.
  list(JOIN ARG_SLOW ":" slow)
  set(filter "")
  set(script "")
  if(slow)
    set(filter TEST_FILTER -${slow})
    gtest_discover_tests(test_${name} DISCOVERY_TIMEOUT 60 TEST_FILTER ${slow} TEST_LIST slow_${name})
    string(APPEND script "if(slow_${name})\n  set_tests_properties(\${slow_${name}} PROPERTIES LABELS slow)\nendif()\n")
  endif()
  gtest_discover_tests(test_${name} DISCOVERY_TIMEOUT 60 ${filter} TEST_LIST tests_${name})
  string(APPEND script
    "if(tests_${name})\n  set_tests_properties(\${tests_${name}} PROPERTIES LABELS \"${ARG_LABEL}\")\nendif()\n")
  set(labels ${CMAKE_CURRENT_BINARY_DIR}/test_${name}_labels.cmake)
  file(CONFIGURE OUTPUT ${labels} CONTENT "${script}" @ONLY)
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${labels})
endfunction()

# vug_fuzz(NAME SOURCES... LINK modules...): a fuzz target, i.e. sources with VUG_FUZZ_TARGET(NAME). With VUG_FUZZ it is
# linked with libFuzzer (clang). With VUG_TESTS the program `replay`, which contains all targets, runs it over
# tests/fuzz/corpus/NAME as a test, with any compiler and sanitizer.
function(vug_fuzz name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  list(TRANSFORM ARG_LINK PREPEND vug_)
  if(VUG_FUZZ)
    add_executable(fuzz_${name} ${ARG_SOURCES} ${PROJECT_SOURCE_DIR}/tests/fuzz/libfuzzer.cpp)
    target_link_libraries(fuzz_${name} PRIVATE vug_strict ${ARG_LINK})
    target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    set_target_properties(fuzz_${name} PROPERTIES
      RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  endif()
  if(VUG_TESTS)
    if(NOT TARGET replay)
      add_executable(replay ${PROJECT_SOURCE_DIR}/tests/fuzz/replay.cpp)
      target_link_libraries(replay PRIVATE vug_strict vug_light)
    endif()
    target_sources(replay PRIVATE ${ARG_SOURCES})
    target_link_libraries(replay PRIVATE ${ARG_LINK})
    add_test(NAME fuzz_corpus.${name}
      COMMAND replay ${name} ${PROJECT_SOURCE_DIR}/tests/fuzz/corpus/${name})
    set_tests_properties(fuzz_corpus.${name} PROPERTIES LABELS fuzz)
  endif()
endfunction()

# vug_bench(NAME SOURCES... LINK modules...): a program with Google Benchmark; times are not asserted.
function(vug_bench name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  list(TRANSFORM ARG_LINK PREPEND vug_)
  add_executable(bench_${name} ${ARG_SOURCES})
  target_link_libraries(bench_${name} PRIVATE vug_strict ${ARG_LINK} benchmark::benchmark_main)
  set_target_properties(bench_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
endfunction()
