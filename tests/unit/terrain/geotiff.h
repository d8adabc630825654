// SPDX-License-Identifier: Apache-2.0
// Small GeoTIFF files for tests: uncompressed, 32-bit floats.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vug::terrain {

struct GeoTiff {
  int columns = 2, rows = 2, bands = 1;
  int epsg = 0;  ///< 0: none is stated.
  bool geographic = false;
  /// See GeoTransform; nothing: the file has no place.
  std::optional<std::array<double, 6>> transform = std::array<double, 6>{0, 1, 0, 0, 0, -1};
  std::string missing{};  ///< The stored value of cells without data.
  std::function<float(int column, int row)> height = [](int, int) { return 0.0f; };

  std::string bytes() const;
  void write(const std::filesystem::path& file) const {
    std::ofstream(file, std::ios::binary) << bytes();
  }
};

inline std::string GeoTiff::bytes() const {
  std::string data(8, '\0');  // Values that do not fit into an entry follow the header.
  std::string entries;
  uint16_t count = 0;
  const auto raw = [](const auto& value) {
    std::string out(sizeof(value), '\0');
    std::memcpy(out.data(), &value, sizeof(value));
    return out;
  };
  const auto list = [&](const auto& values) {
    std::string out;
    for (const auto& value : values) out += raw(value);
    return out;
  };
  const auto entry = [&](uint16_t tag, uint16_t type, size_t values, std::string content) {
    entries += raw(tag) + raw(type) + raw(static_cast<uint32_t>(values));
    if (content.size() > 4) {
      entries += raw(static_cast<uint32_t>(data.size()));
      data += content;
    } else {
      content.resize(4);
      entries += content;
    }
    ++count;
  };
  std::string pixels;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      for (int band = 0; band < bands; ++band)
        pixels += raw(height(column, row) + 1000.0f * static_cast<float>(band));
  const auto pixels_at = static_cast<uint32_t>(data.size());
  data += pixels;
  constexpr uint16_t kShort = 3, kLong = 4, kAscii = 2, kDouble = 12;
  const auto samples = static_cast<size_t>(bands);
  entry(256, kLong, 1, raw(static_cast<uint32_t>(columns)));
  entry(257, kLong, 1, raw(static_cast<uint32_t>(rows)));
  entry(258, kShort, samples, list(std::vector<uint16_t>(samples, 32)));
  entry(259, kShort, 1, raw(uint16_t{1}));
  entry(262, kShort, 1, raw(uint16_t{1}));
  entry(273, kLong, 1, raw(pixels_at));
  entry(277, kShort, 1, raw(static_cast<uint16_t>(bands)));
  entry(278, kLong, 1, raw(static_cast<uint32_t>(rows)));
  entry(279, kLong, 1, raw(static_cast<uint32_t>(pixels.size())));
  entry(339, kShort, samples, list(std::vector<uint16_t>(samples, 3)));
  if (transform) {
    const std::array<double, 6>& c = *transform;
    entry(34264, kDouble, 16,
          list(std::array<double, 16>{c[1], c[2], 0, c[0], c[4], c[5], 0, c[3], 0, 0, 0, 0, 0, 0, 0,
                                      1}));
  }
  if (epsg != 0) {
    const auto code = static_cast<uint16_t>(epsg);
    const uint16_t model = geographic ? 2 : 1, key = geographic ? 2048 : 3072;
    entry(34735, kShort, 16,
          list(std::array<uint16_t, 16>{1, 1, 0, 3, 1024, 0, 1, model, 1025, 0, 1, 1, key, 0, 1,
                                        code}));
  }
  if (!missing.empty()) entry(42113, kAscii, missing.size() + 1, missing + '\0');
  const std::string head = "II" + raw(uint16_t{42}) + raw(static_cast<uint32_t>(data.size()));
  data.replace(0, 8, head);
  return data + raw(count) + entries + raw(uint32_t{0});
}

}  // namespace vug::terrain
