// Where samples are gathered into layers.
#pragma once

#include <vug/image/image.h>
#include <vug/render/camera.h>
#include <vug/render/integrator.h>

namespace vug::render {

/// Names of the layers in the order of `render`.
const std::vector<std::string>& layer_names();

/// The sum of one pixel's samples. Each sample counts for its pixel alone and for all of it (box
/// filter), so pixels are independent and their order of work does not matter.
class PixelSum {
 public:
  void add(const PathResult& sample, const Camera& camera);
  /// Writes the means into a pixel of an image with the channels of layer_names().
  void store(image::Image& image, int x, int y) const;

 private:
  Vec3d radiance_{0, 0, 0}, normal_{0, 0, 0}, position_{0, 0, 0}, albedo_{0, 0, 0};
  double alpha_ = 0, depth_ = 0;
  int samples_ = 0, hits_ = 0;
};

}  // namespace vug::render
