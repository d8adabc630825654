# SPDX-License-Identifier: Apache-2.0
# cmake -DBUILD=... -DSOURCE=... -DCOMPILER=... -DTYPE=... -P run.cmake: installs BUILD into a
# temporary prefix, then configures, builds, runs and tests the consumer project against it.
set(place ${BUILD}/tests/consumer)
file(REMOVE_RECURSE ${place}/prefix ${place}/build)

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${place}/prefix)
# The headers that are installed headers include are installed, too.
set(include ${place}/prefix/include)
file(GLOB_RECURSE headers RELATIVE ${include} ${include}/vug/*.h)
foreach(header ${headers})
  file(STRINGS ${include}/${header} lines REGEX "^ *# *include <vug/")
  foreach(line ${lines})
    string(REGEX REPLACE ".*<(.*)>.*" "\\1" other "${line}")
    if(NOT EXISTS ${include}/${other})
      message(FATAL_ERROR "${header} includes ${other}, which is not installed")
    endif()
  endforeach()
endforeach()
if(EXISTS ${include}/vug/volume/octree.h)
  message(FATAL_ERROR "internal headers are installed")
endif()
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${place}/build -G Ninja -DCMAKE_PREFIX_PATH=${place}/prefix
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${TYPE})
run(${CMAKE_COMMAND} --build ${place}/build)
run(${place}/build/consumer)
run(${CMAKE_CTEST_COMMAND} --test-dir ${place}/build --output-on-failure)
