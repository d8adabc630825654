// SPDX-License-Identifier: Apache-2.0
// The assertion of fuzz targets, which aborts the process.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace vug {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

}  // namespace vug
