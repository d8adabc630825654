// SPDX-License-Identifier: Apache-2.0
// Layout as written by OpenVDB since format 222: magic (8 bytes), format version (4), library major
// and minor (4 + 4), offsets flag (1), identifier (36), metadata, number of grids (4), and for each
// grid its name, type, parent name and three offsets: start, voxel data, end.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/volume/vdb_header.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <vector>

namespace vug::volume {
namespace {

constexpr uint64_t kMagic = 0x56444220;
constexpr char kNumberMark = '\x1e';  // OpenVDB appends it and a number to duplicate grid names.
constexpr uint32_t kOldestChecked = 222, kNewest = 224;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& source) : source_(source) {
    if (const std::string why = unreadable_reason(source); !why.empty()) fail(why);
    in_.open(source, std::ios::binary);
    if (!in_) fail(std::strerror(errno));
    size_ = std::filesystem::file_size(source);
  }

  template <class T>
  T number() {
    T value{};
    bytes(&value, sizeof value);
    return value;
  }
  std::string text(uint64_t length) {
    if (length > size_ - at_) fail("it is truncated or damaged");
    std::string out(length, '\0');
    bytes(out.data(), length);
    return out;
  }
  std::string text() { return text(number<uint32_t>()); }
  void seek(uint64_t to) {
    in_.seekg(static_cast<std::streamoff>(to));
    at_ = to;
  }
  uint64_t at() const { return at_; }
  uint64_t size() const { return size_; }

  [[noreturn]] void fail(const std::string& why) const {
    throw Error(ErrorCode::bad_input, fmt::format("cannot read '{}': {}", source_.string(), why));
  }

 private:
  void bytes(void* to, uint64_t count) {
    if (count > size_ - at_ || !in_.read(static_cast<char*>(to), static_cast<int64_t>(count)))
      fail("it is truncated or damaged");
    at_ += count;
  }

  std::filesystem::path source_;
  std::ifstream in_;
  uint64_t size_ = 0, at_ = 0;
};

void skip_metadata(Reader& in) {
  const auto count = in.number<uint32_t>();
  for (uint32_t i = 0; i < count; ++i)
    for (int part = 0; part < 3; ++part) in.text();  // Name, type, value.
}

std::vector<std::string> read_grid_places(Reader& in) {
  std::vector<std::string> names;
  const auto count = in.number<int32_t>();
  if (count < 0) in.fail("it is damaged");
  for (int32_t i = 0; i < count; ++i) {
    const std::string name = in.text();
    names.push_back(name.substr(0, name.find(kNumberMark)));
    in.text();  // Type.
    const bool instance = !in.text().empty();
    const auto start = in.number<uint64_t>(), voxels = in.number<uint64_t>();
    const auto end = in.number<uint64_t>();
    const bool ordered =
        start >= in.at() && end >= start && (instance || (voxels >= start && voxels <= end));
    if (!ordered || end > in.size()) in.fail("it is truncated or damaged");
    in.seek(end);
  }
  return names;
}

}  // namespace

bool VdbHeader::has_content_hash() const {
  return identifier.size() == kIdentifierSize && identifier[14] == '8' && identifier[19] == '8' &&
         identifier.find_first_not_of("0123456789abcdef-") == std::string::npos;
}

VdbHeader read_vdb_header(const std::filesystem::path& source) {
  Reader in(source);
  if (in.size() < 57 || in.number<uint64_t>() != kMagic) in.fail("it is not a .vdb file");
  VdbHeader out;
  out.format_version = in.number<uint32_t>();
  if (out.format_version > kNewest)
    in.fail(fmt::format("its format {} is newer than {}", out.format_version, kNewest));
  if (out.format_version < kOldestChecked) return out;
  in.number<uint64_t>();  // Library version.
  const bool offsets = in.number<char>() != 0;
  out.identifier = in.text(VdbHeader::kIdentifierSize);
  skip_metadata(in);
  if (!offsets) in.fail("it is a stream without offsets");
  out.grids = read_grid_places(in);
  return out;
}

std::string content_identifier(const std::filesystem::path& source) {
  std::ifstream in(source, std::ios::binary);
  std::vector<char> buffer(size_t{1} << 20);
  Hasher hasher;
  bool first = true;
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0) {
    const auto count = static_cast<size_t>(in.gcount());
    if (first && count >= VdbHeader::kIdentifierAt + VdbHeader::kIdentifierSize)
      std::memset(buffer.data() + VdbHeader::kIdentifierAt, 0, VdbHeader::kIdentifierSize);
    first = false;
    hasher.add(buffer.data(), count);
  }
  std::string hex = hasher.finish().hex();
  hex[12] = '8';  // Version: custom.
  hex[16] = '8';  // Variant.
  return hex.substr(0, 8) + "-" + hex.substr(8, 4) + "-" + hex.substr(12, 4) + "-" +
         hex.substr(16, 4) + "-" + hex.substr(20);
}

}  // namespace vug::volume
