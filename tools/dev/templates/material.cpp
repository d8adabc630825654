//@ lib/vug/render/materials
// SPDX-License-Identifier: Apache-2.0
// STUB: the model and its source.
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct NewKind {
  Vec3d albedo{0.5, 0.5, 0.5};

  static void describe(Schema<NewKind>& s) {
    s.doc("STUB: its appearance, in one sentence.")
        .param("albedo", &NewKind::albedo,
               {.doc = "STUB: fraction of the light that is reflected", .min = 0, .max = 1});
  }
};

/// Directions are local (z is the shading normal); see Bsdf for the contract of each function.
class NewKindBsdf final : public Bsdf {
 public:
  explicit NewKindBsdf(const Rgb& albedo) : albedo_(albedo) {}

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

class NewKindMaterial final : public Material {
 public:
  explicit NewKindMaterial(const NewKind& p) : albedo_(to_float(p.albedo)) {}

  const Bsdf& at(const Surface& surface, const Vec3f&, BsdfMemory& memory) const override {
    return memory.make<NewKindBsdf>(from_rec709_(albedo_ * surface.color));
  }
  size_t memory_bytes() const override { return BsdfMemory::bytes<NewKindBsdf>(); }
  MaterialPtr in_space(const image::ColourMatrix& from_rec709) const override {
    auto copy = std::make_shared<NewKindMaterial>(*this);
    copy->from_rec709_ = from_rec709;
    return copy;
  }

 private:
  Rgb albedo_;
  image::ColourMatrix from_rec709_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(new_kind, material, MaterialPtr, NewKind, NewKindMaterial)
