# SPDX-License-Identifier: Apache-2.0
# All dependencies, one per line. This file is used by this project, which requires all of them, and by
# the installed VugConfig.cmake, which requires only those of the libraries.
if(CMAKE_FIND_PACKAGE_NAME)
  include(CMakeFindDependencyMacro)
  macro(vug_needs)
    find_dependency(${ARGV})
  endmacro()
else()
  macro(vug_needs)
    find_package(${ARGV} REQUIRED)
  endmacro()
endif()

vug_needs(Threads)
vug_needs(Imath CONFIG)
vug_needs(OpenEXR CONFIG)
vug_needs(PNG)
vug_needs(TBB CONFIG)
vug_needs(fmt CONFIG)
vug_needs(Eigen3 CONFIG)
vug_needs(PROJ CONFIG)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
vug_needs(CGAL CONFIG)
vug_needs(nlohmann_json CONFIG)
vug_needs(TinyGLTF CONFIG)
vug_needs(meshoptimizer CONFIG)
vug_needs(embree 3 CONFIG)
vug_needs(boost_context CONFIG)
vug_needs(PkgConfig)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(cpp_httplib REQUIRED IMPORTED_TARGET cpp-httplib)
pkg_check_modules(log4cplus REQUIRED IMPORTED_TARGET log4cplus)
# Debian installs OpenVDB's find module next to its libraries.
list(APPEND CMAKE_MODULE_PATH /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB)
set(CMAKE_FIND_PACKAGE_QUIET_BOOST TRUE)
vug_needs(OpenVDB)

if(NOT CMAKE_FIND_PACKAGE_NAME)
  # Linked by the library that vug::image loads, not by those who link the modules.
  vug_needs(OpenImageIO CONFIG)
  # Debian's target contains include folders of OpenCV, which its headers do not need.
  set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES ${OpenImageIO_INCLUDE_DIR})
  # Debian's CMake package of OpenColorIO refers to missing folders.
  pkg_check_modules(OpenColorIO REQUIRED IMPORTED_TARGET OpenColorIO>=2.1)
  vug_needs(CLI11 CONFIG)
  if(VUG_TESTS)
    vug_needs(GTest CONFIG)
  endif()
  if(VUG_BENCH)
    vug_needs(benchmark CONFIG)
  endif()
endif()
