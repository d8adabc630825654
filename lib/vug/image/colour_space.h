// The spaces that light can be computed in, and the way of a colour from one to another.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vug::image {

/// Places of red, green, blue and white in the CIE 1931 diagram: x and y of each, in EXR's order.
using Chromaticities = std::array<double, 8>;

/// A space whose numbers are proportional to light.
enum class WorkingSpace { rec709, acescg };

struct WorkingSpaceInfo {
  WorkingSpace space;
  std::string name;         ///< In scenes and options: "rec709".
  std::string public_name;  ///< Among programs of others (colorInteropID): "lin_rec709_scene".
  std::vector<std::string> aliases;  ///< As OpenColorIO configurations call it.
  Chromaticities chromaticities;
};

/// Rec.709: ITU-R BT.709, item 1. ACEScg: AP1 of the Academy, S-2014-004 (aces2014s004).
const std::vector<WorkingSpaceInfo>& working_spaces();
const WorkingSpaceInfo& info(WorkingSpace space);
/// The one of these primaries, if there is one.
std::optional<WorkingSpace> find_space(const Chromaticities& chromaticities);

/// A linear map of colours; leaves them as they are unless made otherwise.
class ColourMatrix {
 public:
  ColourMatrix() = default;
  /// From the light's primaries to others. Whites go to whites, by Bradford's adaptation as in
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
