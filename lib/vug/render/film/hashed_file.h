// SPDX-License-Identifier: Apache-2.0
// Binary files that end with a hash of their content, so that a file that was cut short or changed
// is refused.
#pragma once

#include <vug/base/hash.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

namespace vug::render {

/// Reading and writing share the functions that list the values, so that they cannot differ.
/// Numbers are stored in the byte order of the processor, which is little-endian.
class HashedWriter {
 public:
  static constexpr bool kReads = false;
  explicit HashedWriter(const std::filesystem::path& path) : out_(path, std::ios::binary) {}

  void bytes(const void* data, size_t count);
  template <class T>
  void number(const T& value) {
    bytes(&value, sizeof value);
  }
  /// Writes the hash. False if the file could not be written.
  bool finish();

 private:
  void flush();

  std::vector<char> buffer_;
  std::ofstream out_;
  Hasher hash_;
};

/// All functions throw Error(bad_input), with the file and the fault.
class HashedReader {
 public:
  static constexpr bool kReads = true;
  /// `what` names the expected kind of file.
  HashedReader(const std::filesystem::path& path, std::string what);

  [[noreturn]] void refuse(const std::string& why) const;
  void bytes(void* data, size_t count);
  /// The bytes before the hash that are not read yet.
  uint64_t left() const;
  /// Skips to the hash at the end.
  void skip();
  /// Call this before allocating memory for this many bytes.
  void need(uint64_t count) const;
  template <class T>
  void number(T& value) {
    bytes(&value, sizeof value);
  }
  /// Compares the hash.
  void finish();

 private:
  /// Reads the next bytes, up to the hash, or the hash itself.
  void refill();

  std::vector<char> buffer_;
  size_t at_ = 0;
  std::filesystem::path path_;
  std::string what_;
  std::ifstream in_;
  uint64_t left_;
  Hasher hash_;
};

template <class File, class Items, class Each>
void list(File& file, Items& items, size_t least_bytes, const Each& each) {
  auto count = static_cast<uint32_t>(items.size());
  file.number(count);
  if constexpr (File::kReads) {
    file.need(uint64_t{count} * least_bytes);
    items.resize(count);
  }
  for (auto& item : items) each(item);
}

template <class File, class Text>
void text(File& file, Text& value) {
  auto count = static_cast<uint32_t>(value.size());
  file.number(count);
  if constexpr (File::kReads) {
    file.need(count);
    value.resize(count);
  }
  if (count > 0) file.bytes(value.data(), count);
}

/// A value without pointers, a vector of such values, or an object whose `visit` lists its members.
template <class File, class T>
void value_of(File& file, T& value) {
  if constexpr (requires { value.visit(value, [](auto&) {}); }) {
    value.visit(value, [&](auto& member) { value_of(file, member); });
  } else if constexpr (requires { value.capacity(); }) {
    constexpr size_t kBytes = sizeof(typename T::value_type);
    static_assert(std::is_trivially_destructible_v<typename T::value_type>);
    uint64_t count = value.size();
    file.number(count);
    if constexpr (File::kReads) {
      if (count > file.left() / kBytes) file.refuse("it is cut short");
      value.resize(count);
    }
    if (count > 0) file.bytes(value.data(), count * kBytes);
  } else {
    static_assert(std::is_trivially_destructible_v<T>);
    file.number(value);
  }
}

}  // namespace vug::render
