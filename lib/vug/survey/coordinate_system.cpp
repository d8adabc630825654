// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/coordinate_system.h>

#include <algorithm>
#include <map>

namespace vug::survey {
namespace {

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return text;
}

const std::map<std::string, std::string>& named_systems() {
  static const std::map<std::string, std::string> all = {
      {"EUR79Z30", "+proj=utm +zone=30 +ellps=intl +towgs84=-86,-98,-119,0,0,0,0 +no_defs"},
      {"IJTSK", "EPSG:5514"},
      {"IJTSK03", "EPSG:8353"},
      {"JTSK", "EPSG:5513"},
      {"JTSK03", "EPSG:8352"},
      {"LAT-LONG", "EPSG:4326"},
      {"LOCAL", ""},
      {"LONG-LAT", "EPSG:4326"},
      {"S-MERC", "EPSG:3857"},
  };
  return all;
}

/// The position of a letter in a square of 5 by 5 letters without I: column and row from the top.
std::optional<std::pair<int, int>> square_of(char letter) {
  if (letter < 'A' || letter > 'Z' || letter == 'I') return std::nullopt;
  const int index = letter - 'A' - (letter > 'I' ? 1 : 0);
  return std::pair(index % 5, index / 5);
}

/// The south-west corner of a square of 100 km of the British grid, e.g. "SD". The origin of the
/// grid is the south-west corner of the square "SV".
std::optional<Vec3d> british_square(const std::string& letters) {
  if (letters.size() != 2) return std::nullopt;
  const auto large = square_of(letters[0]), small = square_of(letters[1]);
  if (!large || !small) return std::nullopt;
  return Vec3d(5e5 * (large->first - 2) + 1e5 * small->first,
               5e5 * (3 - large->second) + 1e5 * (4 - small->second), 0);
}

/// "UTM30N" or "UTM30": zones from 1 to 60 of WGS 84.
std::optional<std::string> utm_zone(const std::string& name) {
  if (!name.starts_with("UTM") || name.size() < 4) return std::nullopt;
  std::string digits = name.substr(3);
  const bool south = digits.back() == 'S';
  if (south || digits.back() == 'N') digits.pop_back();
  if (digits.empty() || digits.size() > 2 ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  const int zone = std::stoi(digits);
  if (zone < 1 || zone > 60) return std::nullopt;
  return "EPSG:" + std::to_string((south ? 32700 : 32600) + zone);
}

/// E.g. PROJCRS["ETRS89 / UTM zone 30N", ...].
bool is_well_known_text(const std::string& name) {
  const size_t letters =
      std::min(name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_"), name.size());
  return letters > 3 && name.substr(letters).starts_with("[\"") && name.back() == ']';
}

}  // namespace

std::optional<CoordinateSystem> coordinate_system(const std::string& name) {
  if (name.starts_with("+")) return CoordinateSystem{name, Vec3d(0)};
  if (is_well_known_text(name)) return CoordinateSystem{name, Vec3d(0)};
  const std::string upper = capitals(name);
  if (const auto found = named_systems().find(upper); found != named_systems().end())
    return CoordinateSystem{found->second, Vec3d(0)};
  if (const auto zone = utm_zone(upper)) return CoordinateSystem{*zone, Vec3d(0)};
  if (upper.starts_with("OSGB:")) {
    const auto corner = british_square(upper.substr(5));
    return corner ? std::optional(CoordinateSystem{"EPSG:27700", *corner}) : std::nullopt;
  }
  for (const char* authority : {"EPSG:", "ESRI:"})
    if (upper.starts_with(authority) && upper.size() > 5 && upper.size() < 14 &&
        upper.find_first_not_of("0123456789", 5) == std::string::npos)
      return CoordinateSystem{upper, Vec3d(0)};
  return std::nullopt;
}

}  // namespace vug::survey
