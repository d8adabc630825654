// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/exchange/crate_coding.h>
#include <vug/exchange/crate_format.h>
#include <vug/exchange/crate_reader.h>

#include <algorithm>
#include <map>
#include <optional>

namespace vug::exchange {
namespace {

/// Reads numbers and checks that they are in the file.
class CrateBytes {
 public:
  CrateBytes(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  void seek(uint64_t at) {
    if (at > bytes_.size()) fail();
    at_ = static_cast<size_t>(at);
  }
  uint64_t position() const { return at_; }
  std::string_view take(uint64_t count) {
    if (count > bytes_.size() - at_) fail();
    const std::string_view out = bytes_.substr(at_, static_cast<size_t>(count));
    at_ += static_cast<size_t>(count);
    return out;
  }
  template <class T>
  T number() {
    T out;
    std::memcpy(&out, take(sizeof(T)).data(), sizeof(T));
    return out;
  }
  /// A number of entries. LZ4 compresses at most to 1/255, and four integers have at least a byte.
  size_t count() {
    const auto out = number<uint64_t>();
    if (out / 1024 > bytes_.size()) fail();
    return static_cast<size_t>(out);
  }
  /// Data of at most `most` bytes behind their compressed size. The limit protects the memory.
  std::string decompress(size_t most) {
    constexpr size_t kLimit = size_t{1} << 30;
    std::optional<std::string> out =
        crate_decompress(take(number<uint64_t>()), std::min(most, kLimit));
    if (!out) fail();
    return std::move(*out);
  }
  [[noreturn]] void fail() const {
    throw Error(ErrorCode::bad_input, "the binary USD file is truncated or damaged", {file_, 0, 0},
                "export it again");
  }

 private:
  std::string_view bytes_;
  const std::string& file_;
  size_t at_ = 0;
};

/// Reads the dictionary `customLayerData`.
class CrateMetadata {
 public:
  CrateMetadata(std::string_view bytes, const std::string& file) : in_(bytes, file) {}

  std::vector<std::pair<std::string, std::string>> read() {
    in_.seek(sizeof kCrateMagic - 1);
    const auto major = in_.number<uint8_t>(), minor = in_.number<uint8_t>();
    constexpr uint8_t kFirstCompressed = 4;
    if (major == 0 && minor < kFirstCompressed) return {};
    in_.seek(16);
    in_.seek(in_.number<uint64_t>());
    const size_t count = in_.count();
    for (size_t i = 0; i < count; ++i) {
      const std::string_view name = in_.take(kCrateSectionName);
      sections_[std::string(name.substr(0, name.find('\0')))] = in_.number<uint64_t>();
      in_.number<uint64_t>();  // the size
    }
    read_tokens();
    section("STRINGS");
    const size_t strings = in_.count();
    for (size_t i = 0; i < strings; ++i) strings_.push_back(in_.number<uint32_t>());
    const CrateRep rep = find_field("customLayerData");
    if (crate_type(rep) != CrateType::dictionary || (rep & kCrateInlined) != 0) return {};
    in_.seek(rep & kCratePayload);
    return read_dictionary();
  }

 private:
  void section(const char* name) {
    const auto found = sections_.find(name);
    if (found == sections_.end()) in_.fail();
    in_.seek(found->second);
  }

  void read_tokens() {
    section("TOKENS");
    const size_t count = in_.count(), bytes = in_.count();
    const std::string all = in_.decompress(bytes);
    for (size_t at = 0; at < all.size(); at += tokens_.back().size() + 1)
      tokens_.push_back(all.substr(at, all.find('\0', at) - at));
    if (tokens_.size() != count) in_.fail();
  }

  /// The value of the first field of that name; 0 without one.
  CrateRep find_field(const std::string& name) {
    const auto token = std::find(tokens_.begin(), tokens_.end(), name) - tokens_.begin();
    section("FIELDS");
    const size_t count = in_.count();
    const auto names = crate_decode_integers(in_.decompress(crate_encoded_size(count)), count);
    const std::string values = in_.decompress(count * sizeof(CrateRep));
    if (!names || values.size() != count * sizeof(CrateRep)) in_.fail();
    const auto field = std::find(names->begin(), names->end(), token) - names->begin();
    CrateRep rep = 0;
    if (static_cast<size_t>(field) < count)
      std::memcpy(&rep, values.data() + static_cast<size_t>(field) * sizeof rep, sizeof rep);
    return rep;
  }

  const std::string& string(uint64_t index) const {
    if (index >= strings_.size() || strings_[index] >= tokens_.size()) in_.fail();
    return tokens_[strings_[index]];
  }

  std::vector<std::pair<std::string, std::string>> read_dictionary() {
    std::vector<std::pair<std::string, std::string>> texts;
    const size_t count = in_.count();
    for (size_t i = 0; i < count; ++i) {
      const std::string& name = string(in_.number<uint32_t>());
      const uint64_t begin = in_.position();
      const auto distance = in_.number<uint64_t>();
      if (distance > kCratePayload) in_.fail();
      in_.seek(begin + distance);
      const auto value = in_.number<CrateRep>();
      if (name.rfind("vug:", 0) == 0 && crate_type(value) == CrateType::string)
        texts.emplace_back(name, string(value & 0xffffffff));
    }
    return texts;
  }

  CrateBytes in_;
  std::map<std::string, uint64_t> sections_;
  std::vector<std::string> tokens_;
  std::vector<uint32_t> strings_;
};

}  // namespace

std::vector<std::pair<std::string, std::string>> read_crate_metadata(std::string_view bytes,
                                                                     const std::string& file) {
  if (bytes.substr(0, sizeof kCrateMagic - 1) != kCrateMagic)
    throw Error(ErrorCode::bad_input, "the file is not a binary USD file", {file, 0, 0},
                "text has the extension .usda");
  return CrateMetadata(bytes, file).read();
}

}  // namespace vug::exchange
