// SPDX-License-Identifier: Apache-2.0
// The constants of OpenUSD's binary format (crate files), version 0.8.0, as
// defined by pxr/usd/usd/crateFile.h and crateDataTypes.h of OpenUSD.
//
// A file begins with a header of 88 bytes. Values follow, then the sections TOKENS, STRINGS,
// FIELDS, FIELDSETS, PATHS and SPECS, then the table of contents, whose offset is in the header. A
// spec has a path, a type and a set of fields; a field has a name and a value. Values refer to
// strings by the index of a token.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace vug::exchange {

inline constexpr char kCrateMagic[] = "PXR-USDC";
/// Files of 0.8.0 are the oldest with lists of payloads. OpenUSD 19.03 and later read them.
inline constexpr unsigned char kCrateVersion[] = {0, 8, 0};
inline constexpr size_t kCrateHeader = 88;
inline constexpr size_t kCrateSectionName = 16;
/// Shorter arrays of integers are not compressed.
inline constexpr size_t kCrateLeastCompressed = 16;

enum class CrateType : uint64_t {
  boolean = 1,
  int32 = 3,
  float32 = 8,
  float64 = 9,
  string = 10,
  token = 11,
  asset = 12,
  matrix4d = 15,
  quatf = 17,
  quath = 18,
  vec2f = 20,
  vec3f = 24,
  vec4f = 28,
  dictionary = 31,
  token_list = 32,
  string_list = 33,
  path_list = 34,
  reference_list = 35,
  token_vector = 41,
  specifier = 42,
  variability = 44,
  variant_selections = 45,
  payload_list = 55,
};

enum class CrateSpec : int32_t {
  attribute = 1,
  prim = 6,
  pseudo_root = 7,
  relationship = 8,
  variant = 10,
  variant_set = 11,
};

/// A value in 64 bits: its type in bits 48 to 55, and below it the value itself if it is inlined,
/// else its offset in the file.
using CrateRep = uint64_t;
inline constexpr CrateRep kCrateArray = CrateRep{1} << 63;
inline constexpr CrateRep kCrateInlined = CrateRep{1} << 62;
inline constexpr CrateRep kCrateCompressed = CrateRep{1} << 61;
inline constexpr CrateRep kCratePayload = (CrateRep{1} << 48) - 1;

constexpr CrateRep crate_rep(CrateType type, uint64_t payload, CrateRep flags = 0) {
  return flags | static_cast<uint64_t>(type) << 48 | (payload & kCratePayload);
}
constexpr CrateType crate_type(CrateRep rep) { return static_cast<CrateType>(rep >> 48 & 0xff); }

/// The first byte of a list of edits; lists of explicit or of prepended items follow it.
inline constexpr uint8_t kCrateExplicitList = 1 | 2;
inline constexpr uint8_t kCratePrependedList = 32;

/// The bytes of a number, as they are in memory: little-endian on every supported machine.
template <class T>
std::string crate_bytes(const T& value) {
  std::string out(sizeof(T), '\0');
  std::memcpy(out.data(), &value, sizeof(T));
  return out;
}

}  // namespace vug::exchange
