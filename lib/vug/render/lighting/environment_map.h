// SPDX-License-Identifier: Apache-2.0
// Environment map in lat-long layout with importance sampling by luminance; the base of image and
// model skies. Marginal and conditional tables as in Pharr, Jakob, Humphreys 2023, "Physically
// based rendering", section 12.5.
#pragma once

#include <vug/render/light.h>

#include <vector>

namespace vug::render {

/// Up is y, the middle column points towards -z, and columns run to the right as seen from inside.
class EnvironmentMap : public Light {
 public:
  LightSample sample(const LightSampleContext& point, const Vec2f& u) const override;
  float pdf(const LightSampleContext& point, const Vec3f& direction) const override;
  float importance(const LightSampleContext&) const override { return importance_; }
  float importance_along(const Ray&, float begin, float end) const override {
    return importance_ * (end - begin);
  }
  bool is_infinite() const override { return true; }
  float mean_luminance() const override { return mean_luminance_; }
  /// Bilinear interpolation between texel centres.
  Rgb eval_environment(const Vec3f& direction) const override;
  bool as_data(exchange::Light& light) const override;

 protected:
  /// `texels` are in row order from straight up; `turn` (radians) rotates the map to the left.
  EnvironmentMap(LightLinking linking, size_t width, size_t height, std::vector<Rgb> texels,
                 double turn);

 private:
  struct Cell;
  static Cell find_cell(const float* table, size_t cells, float u);
  static size_t index_of(float place, size_t count);
  const Rgb& texel(long x, long y) const;
  Vec3f direction(float x, float v) const;
  Vec2f locate(const Vec3f& d) const;
  float density(float probability, float v) const;
  void build_tables();

  size_t width_, height_;
  float turn_, importance_ = 0, mean_luminance_ = 0;
  std::vector<Rgb> texels_;
  std::vector<float> rows_, columns_;
};

}  // namespace vug::render
