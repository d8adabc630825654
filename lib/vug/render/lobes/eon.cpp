// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/render/lobes/eon.h>

namespace vug::render {
namespace {

constexpr float kScale = 0.5f - 2 / (3 * kPif);
constexpr float kMean = 2.0f / 3 - 28 / (15 * kPif);

/// Exact directional albedo of single scattering from white rock.
float first_bounce_albedo(float cosine, float roughness, float scale) {
  const auto c = static_cast<double>(std::clamp(cosine, 1e-4f, 1.0f));
  const double s = std::sqrt(1 - c * c), angle = maths::acos(c);
  const double g = s * (angle - s * c) + 2 * (s / c * (1 - s * s * s) - s) / 3;
  return scale * (1 + roughness * static_cast<float>(g / kPi));
}

}  // namespace

EonLobe::EonLobe(const Rgb& color, float roughness, const Vec3f& out)
    : single_(color), roughness_(std::clamp(roughness, 0.0f, 1.0f)), out_(out) {
  scale_ = 1 / (1 + kScale * roughness_);
  const float mean = scale_ * (1 + kMean * roughness_);
  albedo_out_ = first_bounce_albedo(out.z, roughness_, scale_);
  missing_ = std::max(1 - mean, 1e-7f);
  const auto multiple = [&](float rho) { return rho * rho * mean / (1 - rho * missing_); };
  multiple_ = {multiple(color.x), multiple(color.y), multiple(color.z)};
}

Scattering EonLobe::evaluate(const Vec3f& in) const {
  if (!(in.z > 0)) return {};
  const float s = in.x * out_.x + in.y * out_.y;
  const float towards = s > 0 ? s / std::max(in.z, out_.z) : s;
  const float single = scale_ * (1 + roughness_ * towards);
  const float multiple =
      (1 - albedo_out_) * (1 - first_bounce_albedo(in.z, roughness_, scale_)) / missing_;
  const float even = in.z / kPif;
  return {(single_ * single + multiple_ * std::max(multiple, 0.0f)) * even, Rgb(0.0f), even};
}

}  // namespace vug::render
