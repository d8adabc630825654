// SPDX-License-Identifier: Apache-2.0
// The layout follows "OpenEXR file layout" (openexr.com): magic number, version, then for each part
// a list of attributes (name, type, size, value) terminated by an empty name.
#include <vug/image/exr_check.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <vector>

namespace vug::image {
namespace {

constexpr int32_t kMagic = 20000630;
constexpr uint32_t kManyParts = 0x1000;
constexpr int kLongestName = 255;
constexpr int kMostParts = 10000;

/// Whether values of this type have this size. OpenEXR reads as many bytes as the type has,
/// whatever the stated size, and would take the rest for the next attribute.
bool is_size_of(const std::string& type, int32_t bytes) {
  static const std::map<std::string, int32_t> sizes = {
      {"box2f", 16},      {"box2i", 16},   {"chromaticities", 32},
      {"compression", 1}, {"double", 8},   {"envmap", 1},
      {"float", 4},       {"int", 4},      {"keycode", 28},
      {"lineOrder", 1},   {"m33d", 72},    {"m33f", 36},
      {"m44d", 128},      {"m44f", 64},    {"rational", 8},
      {"tiledesc", 9},    {"timecode", 8}, {"v2d", 16},
      {"v2f", 8},         {"v2i", 8},      {"v3d", 24},
      {"v3f", 12},        {"v3i", 12}};
  const auto found = sizes.find(type);
  return found == sizes.end() || found->second == bytes;
}

/// Numbers in the file are little-endian, as in memory.
class Headers {
 public:
  explicit Headers(const std::filesystem::path& path)
      : in_(path, std::ios::binary), size_(std::filesystem::file_size(path)) {}

  bool is_exr() {
    int32_t magic = 0;
    return number(magic) && magic == kMagic;
  }
  std::string fault() {
    uint32_t version = 0;
    if (!number(version)) return "it is truncated";
    for (int part = 0; part < kMostParts; ++part) {
      bool any = false;
      if (std::string fault = part_fault(any); !fault.empty()) return fault;
      // An empty part follows the last of several parts.
      if (!(version & kManyParts) || !any) return any ? "" : part == 0 ? "it has no header" : "";
    }
    return "its parts have no end";
  }

 private:
  template <class T>
  bool number(T& value) {
    return static_cast<bool>(in_.read(reinterpret_cast<char*>(&value), sizeof value));
  }
  bool name(std::string& out) {
    out.clear();
    for (int c = in_.get(); in_; c = in_.get()) {
      if (c == 0) return true;
      out.push_back(static_cast<char>(c));
      if (out.size() > kLongestName) return false;
    }
    return false;
  }
  std::string part_fault(bool& any) {
    any = false;
    for (std::string attribute, type;;) {
      if (!name(attribute)) return "its header is damaged";
      if (attribute.empty()) return "";
      any = true;
      int32_t bytes = 0;
      if (!name(type) || !number(bytes) || bytes < 0 || !is_size_of(type, bytes))
        return "its header is damaged";
      const auto begin = static_cast<uint64_t>(in_.tellg());
      const uint64_t end = begin + static_cast<uint64_t>(bytes);
      if (end > size_) return "it is truncated";
      if (attribute == "channels")
        if (std::string fault = channels_fault(end); !fault.empty()) return fault;
      if (attribute == "dataWindow" || attribute == "displayWindow") {
        int32_t box[4];
        if (type != "box2i" || bytes != sizeof box || !number(box) || box[0] > box[2] ||
            box[1] > box[3])
          return "its header contains no window";
      }
      in_.seekg(static_cast<std::streamoff>(end));
    }
  }
  std::string channels_fault(uint64_t end) {
    for (std::string channel; name(channel) && !channel.empty();) {
      int32_t type = 0, flags = 0, step_x = 0, step_y = 0;
      if (!number(type) || !number(flags) || !number(step_x) || !number(step_y)) break;
      if (static_cast<uint64_t>(in_.tellg()) > end) break;
      if (type < 0 || type > 2) return "one of its channels has an unknown number type";
      if (step_x < 1 || step_y < 1) return "one of its channels has no pixels";
    }
    if (!in_ || static_cast<uint64_t>(in_.tellg()) != end) return "its list of channels is damaged";
    return "";
  }

  std::ifstream in_;
  uint64_t size_;
};

}  // namespace

std::string exr_fault(const std::filesystem::path& path) {
  Headers headers(path);
  return headers.is_exr() ? headers.fault() : "";
}

}  // namespace vug::image
