// SPDX-License-Identifier: Apache-2.0
// Maintenance of a store: its size, trimming and verification.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace vug::store {

struct KindStatistics {
  uint64_t products = 0;
  uint64_t bytes = 0;  ///< Products with the same content share a file.
  double seconds = 0;  ///< Time that the products took to make.
};
struct StoreStatistics {
  uint64_t files = 0;
  uint64_t bytes = 0;  ///< Size of the files.
  std::map<std::string, KindStatistics> kinds;
};
StoreStatistics statistics(const std::filesystem::path& folder);

struct TrimReport {
  uint64_t files = 0;  ///< The number of removed files with products.
  uint64_t bytes = 0;
};
/// Removes the least recently used products until at most `max_bytes` remain, entries without a
/// product, and files that a killed process left more than a day ago.
TrimReport trim(const std::filesystem::path& folder, uint64_t max_bytes);

struct VerifyReport {
  uint64_t intact = 0;
  uint64_t damaged = 0;  ///< Removed.
};
/// Reads all files and removes those whose content does not have the digest in their names.
VerifyReport verify(const std::filesystem::path& folder);

}  // namespace vug::store
