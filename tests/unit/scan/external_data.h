// SPDX-License-Identifier: Apache-2.0
// Optional external test data.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

/// The folder named by the environment variable VUG_EXTERNAL_DATA, or shared/data next to the
/// sources; empty without one.
inline std::filesystem::path external_data() {
  const char* told = std::getenv("VUG_EXTERNAL_DATA");
  const std::filesystem::path folder = told && *told
                                           ? std::filesystem::path(told)
                                           : std::filesystem::path(VUG_DATA) / "../../shared/data";
  std::error_code missing;
  return std::filesystem::is_directory(folder, missing) ? folder : std::filesystem::path();
}
