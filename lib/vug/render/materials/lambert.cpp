// SPDX-License-Identifier: Apache-2.0
// Lambertian reflection, the same on both sides.
#include <vug/exchange/look.h>
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct Lambert {
  Vec3d albedo{0.5, 0.5, 0.5};

  static void describe(Schema<Lambert>& s) {
    s.doc("Lambertian reflection, the same on both sides of the surface.")
        .param("albedo", &Lambert::albedo,
               {.doc = "Reflected fraction of the light, linear Rec.709; the vertex colour "
                       "multiplies it.",
                .min = 0,
                .max = 1});
  }
};

class LambertBsdf final : public Bsdf {
 public:
  explicit LambertBsdf(const Rgb& albedo) : albedo_(albedo) {}

  Scattering evaluate(const Vec3f& in) const override {
    if (!(in.z > 0)) return {};
    return {albedo_ * (in.z / kPif), Rgb(0.0f), in.z / kPif};
  }
  BsdfSample sample(float, const Vec2f& u) const override {
    const Vec3f in = sample_cosine_hemisphere(u);
    return {in, albedo_, albedo_, in.z / kPif};
  }
  Rgb albedo() const override { return albedo_; }

 private:
  Rgb albedo_;
};

class LambertMaterial final : public Material {
 public:
  explicit LambertMaterial(const Lambert& p) : albedo_(to_float(p.albedo)) {}

  const Bsdf& at(const Surface& surface, const Vec3f&, BsdfMemory& memory) const override {
    return memory.make<LambertBsdf>(from_rec709_(albedo_ * surface.color));
  }
  size_t memory_bytes() const override { return BsdfMemory::bytes<LambertBsdf>(); }
  exchange::Look look(const Surface& surface) const override {
    exchange::Look look;
    look.base_color = Vec3d(albedo_ * surface.color);
    return look;
  }
  MaterialPtr in_space(const image::ColourMatrix& from_rec709) const override {
    auto copy = std::make_shared<LambertMaterial>(*this);
    copy->from_rec709_ = from_rec709;
    return copy;
  }

 private:
  Rgb albedo_;
  image::ColourMatrix from_rec709_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(lambert, material, MaterialPtr, Lambert, LambertMaterial)
