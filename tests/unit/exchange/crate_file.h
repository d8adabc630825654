// SPDX-License-Identifier: Apache-2.0
// A reader of crate files for tests. It shares no code with the writer: it also has its own
// decompression of LZ4 blocks and of integers.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace vug::exchange {

class CrateFile {
 public:
  struct Spec {
    int32_t type = 0;
    std::map<std::string, uint64_t> fields;
  };

  explicit CrateFile(std::string bytes) : bytes_(std::move(bytes)) {
    at_ = get_at<uint64_t>(16);
    const auto count = get<uint64_t>();
    for (uint64_t i = 0; i < count; ++i) {
      const char* name = bytes_.data() + at_;
      const uint64_t start = get_at<uint64_t>(at_ + 16), size = get_at<uint64_t>(at_ + 24);
      sections[name] = {start, size};
      at_ += 32;
    }
    end = at_;
    read_tokens();
    read_fields();
    read_paths();
    read_specs();
  }

  std::map<std::string, std::pair<uint64_t, uint64_t>> sections;  ///< Offsets and sizes.
  std::vector<std::string> tokens;
  std::vector<uint32_t> strings;
  std::vector<std::string> paths;  ///< The empty path is empty.
  std::map<std::string, Spec> specs;
  uint64_t end = 0;  ///< The end of the table of contents.

  uint64_t rep(const std::string& path, const std::string& field) const {
    return specs.at(path).fields.at(field);
  }
  bool has(const std::string& path, const std::string& field) const {
    return specs.count(path) > 0 && specs.at(path).fields.count(field) > 0;
  }
  static int type(uint64_t rep) { return static_cast<int>(rep >> 48 & 0xff); }
  static uint64_t payload(uint64_t rep) { return rep & 0xffffffffffff; }
  std::string token(const std::string& path, const std::string& field) const {
    return tokens.at(payload(rep(path, field)));
  }
  std::string string(uint64_t index) const { return tokens.at(strings.at(index)); }

  template <class T>
  T get_at(uint64_t at) const {
    if (at + sizeof(T) > bytes_.size()) throw std::runtime_error("beyond the end");
    T out;
    std::memcpy(&out, bytes_.data() + at, sizeof(T));
    return out;
  }
  std::string bytes_at(uint64_t at, size_t count) const { return bytes_.substr(at, count); }

  /// The numbers of an array that is not compressed.
  template <class T>
  std::vector<T> array(uint64_t rep, size_t arity) const {
    const uint64_t at = payload(rep);
    std::vector<T> out;
    if (at == 0) return out;
    const auto count = get_at<uint64_t>(at) * arity;
    for (uint64_t i = 0; i < count; ++i) out.push_back(get_at<T>(at + 8 + i * sizeof(T)));
    return out;
  }
  std::vector<int32_t> integers(uint64_t rep) {
    if ((rep >> 61 & 1) == 0) return array<int32_t>(rep, 1);
    at_ = payload(rep);
    const auto count = get<uint64_t>();
    return packed_integers(count);
  }
  /// The texts of a vector of tokens.
  std::vector<std::string> token_vector(uint64_t rep) const {
    std::vector<std::string> out;
    for (const uint32_t each : array<uint32_t>(rep, 1)) out.push_back(tokens.at(each));
    return out;
  }
  /// The items of a list with one kind of edits, each of `size` bytes.
  std::vector<std::string> list(uint64_t rep, uint8_t header, size_t size) const {
    const uint64_t at = payload(rep);
    if (get_at<uint8_t>(at) != header) throw std::runtime_error("another kind of list");
    std::vector<std::string> out;
    for (uint64_t i = 0; i < get_at<uint64_t>(at + 1); ++i)
      out.push_back(bytes_at(at + 9 + i * size, size));
    return out;
  }

  /// LZ4's block format: a token with two lengths, literals, a distance, and so on.
  static std::string inflate_block(const std::string& in) {
    std::string out;
    size_t at = 0;
    const auto byte = [&] { return static_cast<unsigned char>(in.at(at++)); };
    const auto length = [&](size_t nibble) {
      size_t more = nibble;
      for (unsigned char next = 255; more >= 15 && next == 255;) more += next = byte();
      return more;
    };
    while (at < in.size()) {
      const unsigned char token = byte();
      const size_t literals = length(token >> 4);
      out += in.substr(at, literals);
      at += literals;
      if (at >= in.size()) break;
      size_t distance = byte();
      distance |= static_cast<size_t>(byte()) << 8;
      const size_t match = length(token & 15) + 4;
      for (size_t i = 0; i < match; ++i) out += out.at(out.size() - distance);
    }
    return out;
  }
  static std::vector<int32_t> decode(const std::string& in, size_t count) {
    std::vector<int32_t> out;
    if (count == 0) return out;
    int32_t common = 0;
    std::memcpy(&common, in.data(), 4);
    size_t at = 4 + (2 * count + 7) / 8;
    uint32_t sum = 0;
    for (size_t i = 0; i < count; ++i) {
      const int code = static_cast<unsigned char>(in.at(4 + i / 4)) >> (2 * (i % 4)) & 3;
      const size_t size = code == 3 ? 4 : static_cast<size_t>(code);
      uint32_t bits = 0;
      for (size_t k = 0; k < size; ++k)
        bits |= static_cast<uint32_t>(static_cast<unsigned char>(in.at(at + k))) << (8 * k);
      if (size == 1 && bits > 0x7f) bits |= 0xffffff00;
      if (size == 2 && bits > 0x7fff) bits |= 0xffff0000;
      at += size;
      sum += code == 0 ? static_cast<uint32_t>(common) : bits;
      out.push_back(static_cast<int32_t>(sum));
    }
    return out;
  }

 private:
  template <class T>
  T get() {
    const T out = get_at<T>(at_);
    at_ += sizeof(T);
    return out;
  }
  std::string packed() {
    const auto size = get<uint64_t>();
    const std::string in = bytes_.substr(at_, size);
    at_ += size;
    if (in.at(0) != 0) throw std::runtime_error("several blocks");
    return inflate_block(in.substr(1));
  }
  std::vector<int32_t> packed_integers(size_t count) { return decode(packed(), count); }

  void read_tokens() {
    at_ = sections.at("TOKENS").first;
    const auto count = get<uint64_t>(), size = get<uint64_t>();
    const std::string all = packed();
    if (all.size() != size) throw std::runtime_error("size of tokens");
    for (size_t begin = 0; begin < all.size(); begin = all.find('\0', begin) + 1)
      tokens.emplace_back(all.c_str() + begin);
    if (tokens.size() != count) throw std::runtime_error("number of tokens");
    at_ = sections.at("STRINGS").first;
    const auto texts = get<uint64_t>();
    for (uint64_t i = 0; i < texts; ++i) strings.push_back(get<uint32_t>());
  }
  void read_fields() {
    at_ = sections.at("FIELDS").first;
    const auto count = get<uint64_t>();
    const std::vector<int32_t> names = packed_integers(count);
    const std::string values = packed();
    for (size_t i = 0; i < count; ++i) {
      uint64_t value = 0;
      std::memcpy(&value, values.data() + 8 * i, 8);
      fields_.emplace_back(tokens.at(static_cast<size_t>(names[i])), value);
    }
    at_ = sections.at("FIELDSETS").first;
    const auto entries = get<uint64_t>();
    sets_ = packed_integers(entries);
  }
  void read_paths() {
    at_ = sections.at("PATHS").first;
    const auto total = get<uint64_t>(), count = get<uint64_t>();
    paths.resize(total);
    const std::vector<int32_t> indices = packed_integers(count), elements = packed_integers(count),
                               jumps = packed_integers(count);
    size_t read = 0;
    read_path(0, "", indices, elements, jumps, read);
    if (read != count) throw std::runtime_error("number of paths");
  }
  void read_path(size_t at, const std::string& parent, const std::vector<int32_t>& indices,
                 const std::vector<int32_t>& elements, const std::vector<int32_t>& jumps,
                 size_t& read) {
    for (;; ++read) {
      const std::string element = tokens.at(static_cast<size_t>(std::abs(elements.at(at))));
      const bool after_variant = !parent.empty() && parent.back() == '}';
      std::string path = parent;
      if (at == 0)
        path = "";
      else if (elements[at] < 0)
        path += "." + element;
      else
        path += (element[0] == '{' || after_variant ? "" : "/") + element;
      paths.at(static_cast<size_t>(indices.at(at))) = at == 0 ? "/" : path;
      const int32_t jump = jumps[at];
      if (jump == -1 || jump > 0) {
        ++read;
        read_path(at + 1, path, indices, elements, jumps, read);
        --read;
      }
      if (jump < 0) break;
      at += jump == 0 ? 1 : static_cast<size_t>(jump);
    }
    ++read;
  }
  void read_specs() {
    at_ = sections.at("SPECS").first;
    const auto count = get<uint64_t>();
    const std::vector<int32_t> where = packed_integers(count), sets = packed_integers(count),
                               types = packed_integers(count);
    for (size_t i = 0; i < count; ++i) {
      Spec spec{types[i], {}};
      for (auto at = static_cast<size_t>(sets[i]); sets_.at(at) >= 0; ++at)
        spec.fields.insert(fields_.at(static_cast<size_t>(sets_[at])));
      if (!specs.emplace(paths.at(static_cast<size_t>(where[i])), spec).second)
        throw std::runtime_error("two specs of one path");
    }
  }

  std::string bytes_;
  uint64_t at_ = 0;
  std::vector<std::pair<std::string, uint64_t>> fields_;
  std::vector<int32_t> sets_;
};

}  // namespace vug::exchange
