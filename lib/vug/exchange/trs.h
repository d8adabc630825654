// SPDX-License-Identifier: Apache-2.0
// Decomposition of affine maps into translation, rotation and scale, as required by other programs.
#pragma once

#include <vug/base/transform.h>

#include <array>
#include <optional>

namespace vug::exchange {

/// Scale, then rotation, then translation.
struct TrsTransform {
  Vec3d translation{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 0, 1};  ///< Unit quaternion x, y, z, w.
  Vec3d scale{1, 1, 1};  ///< The x component is negative for mirrored transforms.
};

/// Returns nothing for a map with shear, which cannot be decomposed.
std::optional<TrsTransform> decompose_trs(const Transform& map);

bool is_identity(const Transform& map);

/// 16 numbers in column-major order for column vectors (glTF), which is row-major for row vectors
/// (USD).
std::array<double, 16> matrix(const Transform& map);

}  // namespace vug::exchange
