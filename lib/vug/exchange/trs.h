// Affine maps in the parts that files of other programs know.
#pragma once

#include <vug/base/transform.h>

#include <array>
#include <optional>

namespace vug::exchange {

/// Scales, then turns, then moves.
struct TrsTransform {
  Vec3d translation{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 0, 1};  ///< Unit quaternion x, y, z, w.
  Vec3d scale{1, 1, 1};                        ///< A mirrored one has a negative x.
};

/// Nothing for a map that shears, which no such parts make.
std::optional<TrsTransform> decompose_trs(const Transform& map);

bool is_identity(const Transform& map);

/// 16 numbers, column after column (glTF), which is row after row for points as rows (USD).
std::array<double, 16> matrix(const Transform& map);

}  // namespace vug::exchange
