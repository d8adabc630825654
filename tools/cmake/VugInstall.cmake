# SPDX-License-Identifier: Apache-2.0
# Installation and the CMake package: targets Vug::field etc. for single modules, Vug::Vug for all.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY VUG_MODULES)
add_library(vug_all INTERFACE)
add_library(Vug::Vug ALIAS vug_all)
set_target_properties(vug_all PROPERTIES EXPORT_NAME Vug)
target_link_libraries(vug_all INTERFACE ${modules})

install(TARGETS vug_contract vug_all ${modules} EXPORT VugTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILE_SET inline DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# The generated lists of kinds.
install(DIRECTORY ${PROJECT_BINARY_DIR}/lib/vug DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.inc" PATTERN CMakeFiles EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/vug OPTIONAL)
if(TARGET vug)
  vug_install_rpath(vug ${CMAKE_INSTALL_BINDIR})
  install(TARGETS vug RUNTIME)
endif()

if(TARGET vug-studio)
  vug_install_rpath(vug-studio ${CMAKE_INSTALL_BINDIR})
  install(TARGETS vug-studio RUNTIME)
endif()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Vug)
list(TRANSFORM modules REPLACE "^vug_" "" OUTPUT_VARIABLE VUG_COMPONENTS)
configure_package_config_file(${PROJECT_SOURCE_DIR}/tools/cmake/VugConfig.cmake.in
  ${PROJECT_BINARY_DIR}/VugConfig.cmake INSTALL_DESTINATION ${package_folder}
  PATH_VARS CMAKE_INSTALL_DATADIR CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/VugConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/VugConfig.cmake ${PROJECT_BINARY_DIR}/VugConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/tools/cmake/VugDependencies.cmake
  ${PROJECT_SOURCE_DIR}/tools/cmake/VugImageTest.cmake
  ${PROJECT_SOURCE_DIR}/tools/cmake/VugPlugin.cmake DESTINATION ${package_folder})
install(EXPORT VugTargets NAMESPACE Vug:: DESTINATION ${package_folder})
