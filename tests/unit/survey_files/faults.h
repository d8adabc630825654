// SPDX-License-Identifier: Apache-2.0
// Tables of files that a survey format rejects, and damaged files.
#pragma once

#include <vug/survey_files/format.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug::survey {

inline Contents read_bytes(const std::string& extension, std::string_view bytes) {
  Diagnostics warnings;
  const std::string file = "x." + extension;
  return format_of(file).read(bytes, file, {}, warnings);
}

struct Fault {
  std::string bytes;
  int line;  ///< 0 for binary files, whose messages contain the byte offset.
  std::string message;
};

/// Every file is rejected with exactly this message at this line.
inline void expect_faults(const std::string& extension, const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    SCOPED_TRACE(testing::PrintToString(fault.bytes));
    try {
      read_bytes(extension, fault.bytes);
      ADD_FAILURE() << "was read, expected: " << fault.message;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_input);
      EXPECT_EQ(error.what(), fault.message);
      EXPECT_EQ(error.where().line, fault.line) << fault.message;
      EXPECT_EQ(error.where().file, "x." + extension);
      EXPECT_FALSE(error.hint().empty()) << fault.message;
    }
  }
}

/// Reading each beginning of the bytes, and the bytes with each byte replaced, either succeeds or
/// throws Error(bad_input). Returns the number of beginnings that were read.
inline size_t read_damaged(const std::string& extension, const std::string& bytes) {
  size_t read = 0;
  const auto attempt = [&](std::string_view damaged) {
    try {
      read_bytes(extension, damaged);
      return true;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_input) << error.what();
      return false;
    }
  };
  for (size_t length = 0; length < bytes.size(); ++length)
    read += attempt(std::string_view(bytes).substr(0, length)) ? 1 : 0;
  for (size_t at = 0; at < bytes.size(); ++at)
    for (const char replacement : {'\x00', '\x7f', '\x80', '\xff'}) {
      std::string damaged = bytes;
      damaged[at] = replacement;
      attempt(damaged);
    }
  return read;
}

}  // namespace vug::survey
