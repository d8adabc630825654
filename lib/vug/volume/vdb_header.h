// Inside volume/ only: the parts of a .vdb file that say where everything is, read with every
// length checked. OpenVDB trusts these numbers, so they are looked at before it opens a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vug::volume {

struct VdbHeader {
  uint32_t format_version = 0;
  std::string identifier;          ///< 36 characters, from byte kIdentifierAt on.
  std::vector<std::string> grids;  ///< Names in the file's order.

  /// The identifier has the form of a hash; a random one looks so once in 10^8 files.
  bool has_content_hash() const;

  static constexpr uint64_t kIdentifierAt = 21;
  static constexpr size_t kIdentifierSize = 36;
};

/// Error(bad_input) for what is no .vdb file, is cut off, or places grids outside itself.
VdbHeader read_vdb_header(const std::filesystem::path& source);

/// The file's hash with its identifier left out, in the form of an identifier (RFC 9562, v8).
std::string content_identifier(const std::filesystem::path& source);

}  // namespace vug::volume
