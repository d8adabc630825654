// SPDX-License-Identifier: Apache-2.0
// A reader for the little-endian numbers and texts of binary survey files, which reports faults
// with the offset of the byte.
#pragma once

#include <vug/base/error.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace vug::survey {

class ByteReader {
 public:
  /// `start` is the offset in the file of the first of `bytes`.
  ByteReader(std::string_view bytes, std::string file, size_t start = 0)
      : bytes_(bytes), file_(std::move(file)), start_(start) {}

  /// The offset in the file of the next byte.
  size_t offset() const { return start_ + at_; }
  size_t left() const { return bytes_.size() - at_; }
  const std::string& file() const { return file_; }

  /// The next number. Throws Error(bad_input) if the file ends first or if a floating-point number
  /// is not finite.
  template <class T>
  T number() {
    const size_t start = offset();
    T value;
    std::memcpy(&value, text(sizeof(T)).data(), sizeof(T));
    if constexpr (std::is_floating_point_v<T>)
      if (!std::isfinite(value)) fail_at(start, "a number is not finite");
    return value;
  }
  std::string_view text(size_t length) {
    if (length > left()) fail("the file ends too early");
    at_ += length;
    return bytes_.substr(at_ - length, length);
  }
  /// The bytes before the next line feed, which is skipped.
  std::string_view line() {
    const size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) fail("the file ends inside its header");
    const std::string_view result = text(end - at_);
    ++at_;
    return result;
  }
  [[noreturn]] void fail(const std::string& message) const { fail_at(offset(), message); }
  [[noreturn]] void fail_at(size_t offset, const std::string& message,
                            std::string hint = "the file may be cut off or damaged") const {
    throw Error(ErrorCode::bad_input, message + " (byte " + std::to_string(offset) + ")",
                {file_, 0, 0}, std::move(hint));
  }

 private:
  std::string_view bytes_;
  std::string file_;
  size_t start_;
  size_t at_ = 0;
};

/// Appends a number as little-endian bytes.
template <class T>
void append_bytes(std::string& bytes, const T& value) {
  static_assert(std::is_arithmetic_v<T>);
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace vug::survey
