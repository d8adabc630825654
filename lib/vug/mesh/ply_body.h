// SPDX-License-Identifier: Apache-2.0
// Readers for the numbers that follow the header of a PLY file, in any of the three encodings.
#pragma once

#include <vug/mesh/ply_header.h>
#include <vug/mesh/text_scanner.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>

namespace vug::mesh {

/// Treatment of NaN and infinities: meshes refuse them, files of scanners contain them.
enum class NotFinite { refused, kept };

/// Numbers as words of text.
class PlyTextBody {
 public:
  PlyTextBody(std::string_view bytes, const std::string& file, const PlyHeader& header,
              NotFinite not_finite = NotFinite::refused)
      : scan_(bytes, file, header.body, header.body_line), not_finite_(not_finite) {}

  double number(PlyType) {
    const std::string_view word = scan_.word();
    double value = 0;
    if (not_finite_ == NotFinite::kept &&
        std::from_chars(word.data(), word.data() + word.size(), value).ptr ==
            word.data() + word.size() &&
        !std::isfinite(value))
      return value;
    return scan_.number(word);
  }
  /// Throws unless at least `count` more numbers of this type can follow.
  void require(uint64_t count, PlyType) const {
    if (count > (scan_.left() + 1) / 2) fail("the file ends inside a list");
  }
  [[noreturn]] void fail(const std::string& message) const {
    scan_.fail(message, "the file may be cut off");
  }

 private:
  TextScanner scan_;
  NotFinite not_finite_;
};

/// Numbers as bytes, in either byte order.
class PlyBinaryBody {
 public:
  PlyBinaryBody(std::string_view bytes, std::string file, const PlyHeader& header,
                NotFinite not_finite = NotFinite::refused)
      : bytes_(bytes),
        file_(std::move(file)),
        at_(header.body),
        swapped_(header.encoding == PlyHeader::Encoding::big_endian),
        not_finite_(not_finite) {}

  double number(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return load<int8_t>();
      case PlyType::uint8:
        return load<uint8_t>();
      case PlyType::int16:
        return load<int16_t>();
      case PlyType::uint16:
        return load<uint16_t>();
      case PlyType::int32:
        return load<int32_t>();
      case PlyType::uint32:
        return load<uint32_t>();
      case PlyType::float32:
        return finite(static_cast<double>(load<float>()));
      case PlyType::float64:
        return finite(load<double>());
    }
    return 0;
  }
  void require(uint64_t count, PlyType type) const {
    if (count > (bytes_.size() - at_) / size_of(type)) fail("the file ends inside a list");
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ErrorCode::bad_input, fmt::format("{} (byte {})", message, at_), {file_, 0, 0},
                "the file may be cut off or damaged");
  }

 private:
  template <class T>
  T load() {
    if (bytes_.size() - at_ < sizeof(T)) fail("the file ends too early");
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at_, sizeof(T));
    if (swapped_)
      for (size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }
  double finite(double value) const {
    if (not_finite_ == NotFinite::refused && !std::isfinite(value)) fail("a number is not finite");
    return value;
  }

  std::string_view bytes_;
  std::string file_;
  size_t at_;
  bool swapped_;
  NotFinite not_finite_;
};

}  // namespace vug::mesh
