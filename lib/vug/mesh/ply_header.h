// SPDX-License-Identifier: Apache-2.0
// The header of a PLY file: its elements, their properties and the encoding.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vug::mesh {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr size_t size_of(PlyType type) {
  constexpr size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<size_t>(type)];
}
constexpr bool is_whole(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< For lists only.
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;
  int line = 0;
};

struct PlyHeader {
  enum class Encoding { ascii, little_endian, big_endian };
  Encoding encoding = Encoding::ascii;
  std::vector<PlyElement> elements;
  size_t body = 0;    ///< Byte offset of the data after the header.
  int body_line = 1;  ///< Line number of the data after the header.
};

/// Throws Error(bad_input) with the line for anything that is not a PLY header, and for elements
/// that are larger than the bytes after the header.
PlyHeader read_ply_header(std::string_view bytes, const std::string& file);

}  // namespace vug::mesh
