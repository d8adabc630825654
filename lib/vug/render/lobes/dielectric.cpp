// SPDX-License-Identifier: Apache-2.0
#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/dielectric.h>

namespace vug::render {

DielectricLobe::DielectricLobe(float roughness, const InterfaceTable& face,
                               const DielectricTable& glass, bool inside, const Vec3f& out)
    : ggx_(roughness),
      out_(out),
      near_(inside ? &glass.inside() : &glass.outside()),
      far_(inside ? &glass.outside() : &glass.inside()),
      roughness_(roughness),
      ior_(inside ? 1 / face.ior() : face.ior()) {
  loss_out_ = near_->at(out.z, roughness);
  missing_near_ = std::max(near_->mean(roughness), 1e-6f);
  missing_far_ = std::max(far_->mean(roughness), 1e-6f);
  // Light between facets leaves to the far side about as a smooth interface transmits it.
  // Reciprocity requires one relation between both sides' shares, which the larger of both losses
  // ensures. The two sides of a smooth interface are related by 1 - F(1/n) = (1 - F(n)) / n^2.
  float through = 1 - face.mean_fresnel();
  if (inside) through /= face.ior() * face.ior();
  back_ = 1 - through * missing_far_ / std::max(missing_near_, missing_far_);
}

Scattering DielectricLobe::evaluate(const Vec3f& in) const {
  Scattering s;
  if (in.z == 0) return s;
  const bool through = in.z < 0;
  const float even = std::fabs(in.z) / kPif;
  // Multiple scattering.
  const float lost = (through ? far_ : near_)->at(std::fabs(in.z), roughness_);
  const float part = through ? 1 - back_ : back_;
  const float multiple = loss_out_ * part * lost / (through ? missing_far_ : missing_near_) * even;
  s.pdf = loss_out_ * part * ggx_.pdf_multiple(std::fabs(in.z));

  const Vec3f bisector = through ? out_ + in * ior_ : out_ + in;
  const float size = length(bisector);
  float single = 0;
  if (size > 0) {
    Vec3f h = bisector * (1 / size);
    if (h.z < 0) h = -h;
    const float c = dot(out_, h), d = dot(in, h);
    if (c > 0 && (d < 0) == through) {
      const float f = fresnel(c, ior_);
      const float sum = c + ior_ * d;
      const float stretch = through ? ior_ * ior_ * -d / (sum * sum)
                                    : 1 / (4 * c);  // Jacobian from normals to directions
      single = (through ? 1 - f : f) * ggx_.visible_density(out_, h) * stretch;
    }
  }
  s.pdf += (1 - loss_out_) * single;
  s.specular = Rgb(single * ggx_.g2_over_g1(out_, in) + multiple);
  return s;
}

Vec3f DielectricLobe::sample(float lobe, const Vec2f& u) const {
  if (lobe < loss_out_) {
    Vec3f in = ggx_.sample_multiple(u);
    if (!(lobe < loss_out_ * back_)) in.z = -in.z;
    return in;
  }
  const float rest = (lobe - loss_out_) / (1 - loss_out_);
  const Vec3f h = ggx_.sample(out_, u);
  const float c = dot(out_, h), f = fresnel(c, ior_);
  Vec3f in;
  if (rest < f) {
    in = normalized(h * (2 * c) - out_);
    if (!(in.z > 0)) in.z = 0;
  } else {
    const float k = 1 - (1 - c * c) / (ior_ * ior_);
    in = normalized(h * (c / ior_ - std::sqrt(std::max(k, 0.0f))) - out_ * (1 / ior_));
    if (!(in.z < 0)) in.z = 0;
  }
  return in;
}

}  // namespace vug::render
