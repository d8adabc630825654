// SPDX-License-Identifier: Apache-2.0
// A table of texts that a format rejects, with the line and a part of each message.
#pragma once

#include <vug/base/error.h>
#include <vug/mesh/format.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug::mesh {

struct FaultyText {
  std::string text;
  int line;
  const char* part;
};

inline void expect_faults(const std::string& extension, const std::vector<FaultyText>& cases) {
  const std::string file = "x." + extension;
  for (const FaultyText& c : cases) {
    SCOPED_TRACE(c.text);
    try {
      format_of(file).read(c.text, file);
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.where().line, c.line) << error.what();
      EXPECT_NE(std::string(error.what()).find(c.part), std::string::npos) << error.what();
    }
  }
}

}  // namespace vug::mesh
