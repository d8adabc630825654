// SPDX-License-Identifier: Apache-2.0
// Motion from one frame to the next, for the AOV `motion`.
#pragma once

#include <vug/render/camera.h>
#include <vug/render/geometry/instance_transform.h>

#include <map>
#include <utility>

namespace vug::render {

/// The cameras and moving objects of a scene at its frame and at the next one. It ignores the
/// moments of the shutter.
struct MotionStep {
  CameraPtr now, next;
  std::map<uint32_t, std::pair<Affine, Affine>>
      transforms;  ///< By object index; moving objects only.

  /// Motion of a point on the film, in picture widths (to the right) and heights (upwards); zero
  /// unless the point is in front of both cameras. `instance`: the transform of its object, which
  /// was hit at `time`; may be null.
  Vec2f motion(const Vec3f& point, uint32_t object, const InstanceTransform* instance, float time,
               float aspect) const;
};
using MotionStepPtr = std::shared_ptr<const MotionStep>;

}  // namespace vug::render
