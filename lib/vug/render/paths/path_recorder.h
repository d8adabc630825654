// SPDX-License-Identifier: Apache-2.0
// Records the radiance samples of a training path.
#pragma once

#include <vug/render/guiding/radiance_sample.h>

#include <algorithm>
#include <array>
#include <vector>

namespace vug::render {

/// The surface vertices of one path: each reflected all light that the path gathers from there on.
class PathRecorder {
 public:
  explicit PathRecorder(std::vector<RadianceSample>& radiance_samples)
      : samples_(radiance_samples) {}

  /// Adds a vertex that the path reaches with `throughput` after gathering `so_far`.
  void add(const Vec3f& point, const Vec3f& normal, const Rgb& throughput, const Rgb& so_far) {
    full_ = count_ == vertices_.size();
    if (!full_) vertices_[count_++] = {point, normal, throughput, so_far, so_far};
  }
  /// Sets the light gathered after direct lighting at the last vertex.
  void add_direct(const Rgb& so_far) {
    if (count_ > 0 && !full_) vertices_[count_ - 1].lit = so_far;
  }
  /// Ends the path, which gathered `all` in total.
  void finish(const Rgb& all) const {
    for (size_t i = 0; i < count_; ++i) {
      const Vertex& vertex = vertices_[i];
      samples_.push_back({vertex.point, vertex.normal,
                          reflected_luminance(vertex, all, vertex.so_far), i == 0,
                          reflected_luminance(vertex, all, vertex.lit)});
    }
  }

 private:
  struct Vertex {
    Vec3f point, normal;
    Rgb throughput, so_far, lit;
  };
  static float reflected_luminance(const Vertex& vertex, const Rgb& all, const Rgb& before) {
    Rgb left(0.0f);
    for (int k = 0; k < 3; ++k)
      if (vertex.throughput[k] > 0)
        left[k] = std::max(0.0f, all[k] - before[k]) / vertex.throughput[k];
    return luminance(left);
  }
  std::vector<RadianceSample>& samples_;
  std::array<Vertex, 32> vertices_;
  size_t count_ = 0;
  bool full_ = false;
};

}  // namespace vug::render
