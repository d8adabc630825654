// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the header and grid offsets of a .vdb file, read with all lengths checked.
// OpenVDB trusts these numbers, so they are validated before it opens a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vug::volume {

struct VdbHeader {
  uint32_t format_version = 0;
  std::string identifier;          ///< 36 characters, starting at byte kIdentifierAt.
  std::vector<std::string> grids;  ///< Names in file order.

  /// Whether the identifier has the form of a hash; a random one has it once in 10^8 files.
  bool has_content_hash() const;

  static constexpr uint64_t kIdentifierAt = 21;
  static constexpr size_t kIdentifierSize = 36;
};

/// Throws Error(bad_input) for a file that is not a .vdb file, is truncated, or places grids
/// outside itself.
VdbHeader read_vdb_header(const std::filesystem::path& source);

/// The hash of the file without its identifier, in the form of an identifier (RFC 9562, v8).
std::string content_identifier(const std::filesystem::path& source);

}  // namespace vug::volume
