// What paths tell of the surfaces they come by.
#pragma once

#include <vug/render/vectors.h>

namespace vug::render {

/// A surface that a path came to, and how bright the path found it: an estimate of the luminance
/// that it sends back, as noisy as one path is.
struct Sighting {
  Vec3f point;
  Vec3f normal;  ///< Geometric, unit, on the path's side.
  float luminance = 0;
};

}  // namespace vug::render
