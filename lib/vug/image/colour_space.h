// SPDX-License-Identifier: Apache-2.0
// Linear working spaces and conversion between them.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vug::image {

/// CIE 1931 x and y of red, green, blue and white, in the order of EXR.
using Chromaticities = std::array<double, 8>;

/// A linear, scene-referred colour space.
enum class WorkingSpace { rec709, acescg };

struct WorkingSpaceInfo {
  WorkingSpace space;
  std::string name;                  ///< Name in scenes and options: "rec709".
  std::string public_name;           ///< Interchange name (colorInteropID): "lin_rec709_scene".
  std::vector<std::string> aliases;  ///< Names of the space in OpenColorIO configurations.
  Chromaticities chromaticities;
};

/// Rec.709: ITU-R BT.709, item 1. ACEScg: AP1 of the Academy, S-2014-004 (aces2014s004).
const std::vector<WorkingSpaceInfo>& working_spaces();
const WorkingSpaceInfo& info(WorkingSpace space);
/// Returns the working space with these primaries, if there is one.
std::optional<WorkingSpace> find_space(const Chromaticities& chromaticities);

/// A linear map of colours; the identity by default.
class ColourMatrix {
 public:
  ColourMatrix() = default;
  /// Converts between primaries. White maps to white by the Bradford adaptation as described in
  /// Lindbloom, "Chromatic adaptation" (cite lindbloom2017adaptation).
  ColourMatrix(const Chromaticities& from, const Chromaticities& to);
  ColourMatrix(WorkingSpace from, WorkingSpace to);

  bool is_identity() const { return is_identity_; }
  double at(size_t row, size_t column) const { return rows_[row][column]; }
  template <class T>
  Vec3<T> operator()(const Vec3<T>& c) const {
    if (is_identity_) return c;
    Vec3<T> out;
    for (size_t i = 0; i < 3; ++i)
      out[static_cast<int>(i)] = static_cast<T>(rows_[i][0]) * c.x +
                                 static_cast<T>(rows_[i][1]) * c.y +
                                 static_cast<T>(rows_[i][2]) * c.z;
    return out;
  }

 private:
  bool is_identity_ = true;
  std::array<std::array<double, 3>, 3> rows_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

}  // namespace vug::image
