// SPDX-License-Identifier: Apache-2.0
#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/thin_dielectric.h>

namespace vug::render {

float mean_thin_dielectric_reflectance(float ior) {
  constexpr int kSteps = 256;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = (i + 0.5) / kSteps;
    sum += 2 * cosine *
           static_cast<double>(thin_dielectric_reflectance(static_cast<float>(cosine), ior));
  }
  return static_cast<float>(sum / kSteps);
}

ThinDielectricLobe::ThinDielectricLobe(const Rgb& color, float roughness, float ior, float mean,
                                       const Vec3f& out)
    : color_(color), ggx_(roughness), out_(out), roughness_(roughness), ior_(ior), mean_(mean) {
  missing_ = std::max(1 - facet_albedo().mean(roughness), 1e-6f);
  missing_out_ = 1 - facet_albedo().at(out.z, roughness);
}

Scattering ThinDielectricLobe::evaluate(const Vec3f& in) const {
  if (in.z == 0) return {};
  const bool through = in.z < 0;
  const Vec3f above(in.x, in.y, std::fabs(in.z));
  const Vec3f h = normalized(out_ + above);
  const float density = ggx_.density(h), root = ggx_.root(out_);
  const float back = thin_dielectric_reflectance(dot(out_, h), ior_);
  const float part = through ? 1 - back : back, even_part = through ? 1 - mean_ : mean_;
  const float single = density / (2 * (above.z * root + out_.z * ggx_.root(above)));
  const float multiple =
      missing_out_ * (1 - facet_albedo().at(above.z, roughness_)) / (kPif * missing_);
  const Rgb color = through ? color_ : Rgb(1.0f);
  return {Rgb(0.0f), color * ((single * part + multiple * even_part) * above.z),
          (1 - missing_out_) * part * density / (2 * (out_.z + root)) +
              missing_out_ * even_part * ggx_.pdf_multiple(above.z)};
}

Vec3f ThinDielectricLobe::sample(float lobe, const Vec2f& u) const {
  Vec3f in;
  float part = 0;
  if (lobe < missing_out_) {
    in = ggx_.sample_multiple(u);
    lobe /= missing_out_, part = mean_;
  } else {
    const Vec3f h = ggx_.sample(out_, u);
    in = normalized(h * (2 * dot(out_, h)) - out_);
    if (!(in.z > 0)) return Vec3f(0.0f);
    lobe = (lobe - missing_out_) / (1 - missing_out_),
    part = thin_dielectric_reflectance(dot(out_, h), ior_);
  }
  if (!(lobe < part)) in.z = -in.z;
  return in;
}

}  // namespace vug::render
