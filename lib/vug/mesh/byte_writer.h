// SPDX-License-Identifier: Apache-2.0
// A buffered writer for the bytes of a mesh file, which passes them to the sink in large chunks.
#pragma once

#include <vug/mesh/format.h>

#include <charconv>
#include <cstring>

namespace vug::mesh {

class ByteWriter {
 public:
  explicit ByteWriter(const ByteSink& sink) : sink_(sink) { buffer_.reserve(kChunk + kRoom); }
  ~ByteWriter() = default;
  ByteWriter(const ByteWriter&) = delete;
  ByteWriter& operator=(const ByteWriter&) = delete;

  ByteWriter& text(std::string_view s) {
    buffer_.append(s);
    return flush_if_full();
  }
  /// Writes the shortest decimal that reads back as the same value.
  template <class T>
  ByteWriter& number(T value) {
    char digits[kRoom];
    const auto result = std::to_chars(digits, digits + kRoom, value);
    return text({digits, static_cast<size_t>(result.ptr - digits)});
  }
  /// Writes the bytes as they lie in memory: little-endian on every supported machine.
  template <class T>
  ByteWriter& binary(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    return text({bytes, sizeof(T)});
  }
  /// Flushes the buffer. Call once at the end.
  void finish() {
    sink_(buffer_);
    buffer_.clear();
  }

 private:
  static constexpr size_t kChunk = size_t{1} << 20;
  static constexpr size_t kRoom = 64;

  ByteWriter& flush_if_full() {
    if (buffer_.size() >= kChunk) finish();
    return *this;
  }

  const ByteSink& sink_;
  std::string buffer_;
};

}  // namespace vug::mesh
