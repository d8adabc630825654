#include <vug/render/film.h>

#include <algorithm>

namespace vug::render {

const std::vector<std::string>& layer_names() {
  static const std::vector<std::string> names = {"R",   "G",        "B",        "A",       "Z",
                                                 "N.X", "N.Y",      "N.Z",      "P.X",     "P.Y",
                                                 "P.Z", "albedo.R", "albedo.G", "albedo.B"};
  return names;
}

void PixelSum::add(const PathResult& sample, const Camera& camera) {
  ++samples_;
  radiance_ += Vec3d(sample.radiance);
  alpha_ += static_cast<double>(sample.alpha);
  if (!sample.first.hit) return;
  ++hits_;
  normal_ += Vec3d(sample.first.normal);
  position_ += Vec3d(sample.first.position);
  albedo_ += Vec3d(sample.first.albedo);
  depth_ += static_cast<double>(camera.depth(sample.first.position));
}

void PixelSum::store(image::Image& image, int x, int y) const {
  const double all = 1.0 / std::max(samples_, 1), hit = 1.0 / std::max(hits_, 1);
  float* out = &image.at(x, y);
  const auto put = [&](double v) { *out++ = static_cast<float>(v); };
  const auto put_vector = [&](const Vec3d& v) { put(v.x), put(v.y), put(v.z); };
  put_vector(radiance_ * all);
  put(alpha_ * all);
  put(hits_ > 0 ? depth_ * hit : 1e10);
  put_vector(normal_ * hit);
  put_vector(position_ * hit);
  put_vector(albedo_ * hit);
}

}  // namespace vug::render
