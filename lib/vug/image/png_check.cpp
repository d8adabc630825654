// SPDX-License-Identifier: Apache-2.0
// The layout follows the PNG specification (W3C, third edition): a signature, then chunks of
// length, type, data and a CRC-32 of type and data, IHDR first and IEND last.
#include <vug/image/png_check.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

namespace vug::image {
namespace {

constexpr char kSignature[] = "\x89PNG\r\n\x1a\n";
constexpr uint32_t kLongest = 0x7fffffff;

std::array<uint32_t, 256> crc_table() {
  std::array<uint32_t, 256> table{};
  for (uint32_t n = 0; n < 256; ++n) {
    uint32_t c = n;
    for (int bit = 0; bit < 8; ++bit) c = (c >> 1) ^ ((c & 1) ? 0xedb88320u : 0);
    table[n] = c;
  }
  return table;
}

class Chunks {
 public:
  explicit Chunks(const std::filesystem::path& path) : in_(path, std::ios::binary) {}

  std::string fault() {
    char signature[8] = {};
    in_.read(signature, sizeof signature);
    if (std::memcmp(signature, kSignature, sizeof signature) != 0) return "";
    bool pixels = false;
    for (bool first = true;; first = false) {
      uint32_t length = 0;
      char type[5] = {};
      if (!number(length)) return kCut;
      crc_ = ~0u;
      if (!bytes(type, 4)) return kCut;
      const std::string name = type;
      if (length > kLongest || first != (name == "IHDR")) return "its content is damaged";
      if (!skip(length)) return kCut;
      const uint32_t wanted = ~crc_;
      uint32_t stored = 0;
      if (!number(stored)) return kCut;
      if (stored != wanted) return "its content is damaged";
      pixels = pixels || name == "IDAT";
      if (name == "IEND") return pixels ? "" : "it contains no pixels";
    }
  }

 private:
  static constexpr const char* kCut = "it is truncated";

  bool bytes(char* to, size_t count) {
    static const std::array<uint32_t, 256> table = crc_table();
    if (!in_.read(to, static_cast<std::streamsize>(count))) return false;
    for (size_t i = 0; i < count; ++i)
      crc_ = table[(crc_ ^ static_cast<unsigned char>(to[i])) & 255] ^ (crc_ >> 8);
    return true;
  }
  bool skip(uint32_t count) {
    std::array<char, 65536> some{};
    for (; count > some.size(); count -= static_cast<uint32_t>(some.size()))
      if (!bytes(some.data(), some.size())) return false;
    return bytes(some.data(), count);
  }
  /// Four bytes, most significant first.
  bool number(uint32_t& value) {
    unsigned char b[4];
    if (!in_.read(reinterpret_cast<char*>(b), 4)) return false;
    value = uint32_t{b[0]} << 24 | uint32_t{b[1]} << 16 | uint32_t{b[2]} << 8 | b[3];
    return true;
  }

  std::ifstream in_;
  uint32_t crc_ = 0;
};

}  // namespace

std::string png_fault(const std::filesystem::path& path) { return Chunks(path).fault(); }

}  // namespace vug::image
