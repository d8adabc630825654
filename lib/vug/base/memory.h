// SPDX-License-Identifier: Apache-2.0
// Memory sizes as text, the memory of the machine, and checks of memory estimates against a limit.
#pragma once

#include <cstdint>
#include <string>

namespace vug {

/// Parses "8G", "512MiB", "1.5g" or "1000000" into bytes (binary multiples). Throws
/// Error(bad_input) for any other text.
uint64_t parse_bytes(const std::string& text);

/// E.g. "1.5 GiB"; huge values keep three digits and their unit ("2.1e+09 GiB").
std::string bytes_text(double bytes);

/// Memory that is available on the machine now, in bytes (MemAvailable).
uint64_t available_memory();

/// Resident memory of this process now, in bytes (VmRSS).
uint64_t resident_memory();

/// Throws Error(too_large) if `estimate` exceeds `limit` (both in bytes). The message names `what`
/// and both amounts; the hint is `remedy` or a higher limit.
void require_memory(double estimate, uint64_t limit, const std::string& what,
                    const std::string& remedy = "use a larger voxel, a smaller region");

}  // namespace vug
