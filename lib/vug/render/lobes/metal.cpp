// SPDX-License-Identifier: Apache-2.0
#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/metal.h>

namespace vug::render {

MetalLobe::MetalLobe(const Rgb& color, float roughness, const Vec3f& out)
    : color_(color), ggx_(roughness), out_(out), roughness_(roughness) {
  const float facets = facet_albedo().mean(roughness);
  missing_ = std::max(1 - facets, 1e-6f);
  missing_out_ = 1 - facet_albedo().at(out.z, roughness);
  // Cosine-weighted mean of Schlick's approximation: (20 F0 + 1) / 21.
  const auto multiple = [&](float f) { return rescattered((20 * f + 1) / 21, facets); };
  multiple_ = {multiple(color.x), multiple(color.y), multiple(color.z)};
}

Rgb MetalLobe::at(float cosine) const {
  const float m = 1 - std::clamp(cosine, 0.0f, 1.0f);
  const float rise = m * m * m * m * m;
  return color_ * (1 - rise) + Rgb(rise);
}

Scattering MetalLobe::evaluate(const Vec3f& in) const {
  if (!(in.z > 0)) return {};
  const Vec3f h = normalized(out_ + in);
  const float density = ggx_.density(h), root = ggx_.root(out_);
  const float single = density / (2 * (in.z * root + out_.z * ggx_.root(in)));
  const float multiple =
      missing_out_ * (1 - facet_albedo().at(in.z, roughness_)) / (kPif * missing_);
  const float probability = missing_out_;
  return {
      Rgb(0.0f), (at(dot(out_, h)) * single + multiple_ * multiple) * in.z,
      (1 - probability) * density / (2 * (out_.z + root)) + probability * ggx_.pdf_multiple(in.z)};
}

Vec3f MetalLobe::sample(float lobe, const Vec2f& u) const {
  if (lobe < missing_out_) return ggx_.sample_multiple(u);
  const Vec3f h = ggx_.sample(out_, u);
  const Vec3f in = normalized(h * (2 * dot(out_, h)) - out_);
  return in.z > 0 ? in : Vec3f(0.0f);
}

Rgb MetalLobe::albedo() const { return at(out_.z) * (1 - missing_out_) + multiple_ * missing_out_; }

}  // namespace vug::render
