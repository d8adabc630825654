// SPDX-License-Identifier: Apache-2.0
// Programs of other projects (cavern, dump3d, therion) that judge files of surveys. Tests skip
// themselves if a program is not installed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace vug::survey {

inline bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// The output of a shell command that runs in `folder`; the test fails if the command does.
inline std::string run_in(const std::filesystem::path& folder, const std::string& command) {
  const std::string line = "cd '" + folder.string() + "' && LC_ALL=C.UTF-8 " + command + " 2>&1";
  std::FILE* pipe = popen(line.c_str(), "r");
  std::string output;
  char buffer[4096];
  for (size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) output.append(buffer, n);
  EXPECT_EQ(pclose(pipe), 0) << command << "\n" << output;
  return output;
}

/// The files of tests/data/surveys with this extension, in order.
inline std::vector<std::filesystem::path> survey_texts(const std::string& extension) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(VUG_TEST_DATA) + "/surveys"))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  EXPECT_FALSE(files.empty()) << extension;
  return files;
}

}  // namespace vug::survey

#define VUG_REQUIRE_PROGRAM(name) \
  if (!vug::survey::has_program(name)) GTEST_SKIP() << "the program " name " is not installed"
