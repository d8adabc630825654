// SPDX-License-Identifier: Apache-2.0
// Everything that a render learns about the light of its scene before the first sample: a product
// that all parts of a picture can share.
#pragma once

#include <vug/render/lighting/rectangle_shape.h>
#include <vug/render/paths/training.h>

#include <memory>
#include <vector>

namespace vug::render {

struct LearnedLight {
  std::vector<RectangleParams> portals;        ///< Openings to the sky.
  std::shared_ptr<const GuidingData> guiding;  ///< Null if the integrator learns nothing.
};
using LearnedLightPtr = std::shared_ptr<const LearnedLight>;

}  // namespace vug::render
