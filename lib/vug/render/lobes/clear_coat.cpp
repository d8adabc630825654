// SPDX-License-Identifier: Apache-2.0
#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/clear_coat.h>

namespace vug::render {

InterfaceLayer::InterfaceLayer(float rough, const InterfaceTable& face, const Vec3f& out)
    : table(&face), roughness(rough) {
  const float facets = facet_albedo().mean(rough);
  multiple = rescattered(face.mean_fresnel(), facets);
  missing = std::max(1 - facets, 1e-6f);
  missing_out = 1 - facet_albedo().at(out.z, rough);
  mean = face.mean(rough) + multiple * missing;
  transmitted = transmittance(out.z);
}

float InterfaceLayer::transmittance(float cosine) const {
  return std::max(0.0f, 1 - table->albedo(cosine, roughness) -
                            multiple * (1 - facet_albedo().at(cosine, roughness)));
}

ClearCoatLobe::ClearCoatLobe(const Rgb& color, Base below, float roughness,
                             const InterfaceTable& table, const Vec3f& out)
    : face_(roughness, table, out), ggx_(roughness), below_(color), out_(out) {
  if (below == Base::open) below_ = Rgb(0.0f);
  if (below == Base::wet) {
    // Fraction of the light from below that the interface reflects back; follows from the
    // reciprocity of its two sides.
    const float back = 1 - (1 - face_.mean) / (table.ior() * table.ior());
    const auto seen = [&](float rho) { return rho * (1 - back) / (1 - rho * back); };
    below_ = {seen(color.x), seen(color.y), seen(color.z)};
  }
  const float face = 1 - face_.transmitted, even = face_.transmitted * largest(below_);
  specular_probability_ = std::clamp(face / (face + even), 0.1f, 0.9f);
}

Scattering ClearCoatLobe::evaluate(const Vec3f& in) const {
  if (!(in.z > 0)) return {};
  const Vec3f h = normalized(out_ + in);
  const float density = ggx_.density(h), root = ggx_.root(out_);
  const float single = fresnel(dot(out_, h), face_.table->ior()) * density /
                       (2 * (in.z * root + out_.z * ggx_.root(in)));
  const float lost = 1 - facet_albedo().at(in.z, face_.roughness);
  const float multiple = face_.multiple * face_.missing_out * lost / (kPif * face_.missing);
  const float entering =
      std::max(0.0f, 1 - face_.table->albedo(in.z, face_.roughness) - face_.multiple * lost);
  const float even = in.z / kPif;
  return {
      below_ * (face_.transmitted * entering / (1 - face_.mean) * even),
      Rgb((single + multiple) * in.z),
      specular_probability_ * density / (2 * (out_.z + root)) + (1 - specular_probability_) * even};
}

Vec3f ClearCoatLobe::sample(float lobe, const Vec2f& u) const {
  if (!(lobe < specular_probability_)) return sample_cosine_hemisphere(u);
  const Vec3f h = ggx_.sample(out_, u);
  const Vec3f in = normalized(h * (2 * dot(out_, h)) - out_);
  return in.z > 0 ? in : Vec3f(0.0f);
}

}  // namespace vug::render
