// SPDX-License-Identifier: Apache-2.0
// Peak memory of the current process.
#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

namespace vug {

/// Bytes so far (VmHWM); 0 if the system does not report it.
inline double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return 1024 * std::strtod(line.c_str() + 6, nullptr);
  return 0;
}

}  // namespace vug
