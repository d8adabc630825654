// How things move from one frame to the next, for the layer `motion`.
#pragma once

#include <vug/render/camera.h>
#include <vug/render/geometry/instance_transform.h>

#include <map>
#include <utility>

namespace vug::render {

/// A scene at its frame and at the next one. Moments of the shutter play no part in it.
struct MotionStep {
  CameraPtr now, next;
  std::map<uint32_t, std::pair<Affine, Affine>> transforms;  ///< Of the objects that move.

  /// How far the picture of a point goes, in widths (to the right) and heights (upwards) of the
  /// film; nothing where it is not seen before and after. `instance`: of its object, which is met
  /// at `time`; may be null.
  Vec2f motion(const Vec3f& point, uint32_t object, const InstanceTransform* instance, float time,
               float aspect) const;
};
using MotionStepPtr = std::shared_ptr<const MotionStep>;

}  // namespace vug::render
