// How much memory work may take, said before it starts.
#pragma once

#include <cstdint>
#include <string>

namespace vug {

/// "8G", "512MiB", "1.5g", "1000000": bytes; binary multiples. Error(bad_input) otherwise.
uint64_t parse_bytes(const std::string& text);

/// "1.5 GiB"; huge values keep three digits and their unit ("2.1e+09 GiB").
std::string bytes_text(double bytes);

/// Memory the machine could give now, in bytes (MemAvailable).
uint64_t available_memory();

/// Memory that this process holds now, in bytes (VmRSS).
uint64_t resident_memory();

/// Throws Error(too_large) when `estimate` (bytes) exceeds `limit`, naming both and `what`; the
/// hint is `remedy` or else a higher limit.
void require_memory(double estimate, uint64_t limit, const std::string& what,
                    const std::string& remedy = "use a larger voxel, a smaller region");

}  // namespace vug
