// SPDX-License-Identifier: Apache-2.0
// Diffuse rock under a clear film: wet stone, varnish, or with a rough interface plain dry rock.
// See ClearCoatLobe: the rock reflects entering light several times below the interface, which
// darkens it as water does.
#include <vug/exchange/look.h>
#include <vug/render/kind.h>
#include <vug/render/lobes/clear_coat.h>

namespace vug::render {
namespace {

struct Coated {
  Vec3d albedo{0.5, 0.5, 0.5};
  double roughness = 0.3;
  double ior = 1.33;

  static void describe(Schema<Coated>& s) {
    s.doc("Diffuse rock under a clear film, such as water.")
        .cite("jensen1999wet")
        .param("albedo", &Coated::albedo,
               {.doc = "Reflected fraction of the dry rock; the vertex colour multiplies it.",
                .min = 0,
                .max = 1})
        .param("roughness", &Coated::roughness,
               {.doc = "Roughness of the film: 0.05 to 0.2 wet, 0.7 to 0.95 dry; its square is the "
                       "width of the microfacet slopes.",
                .min = 0.03,
                .max = 1})
        .param("ior", &Coated::ior,
               {.doc = "Index of refraction: water 1.33, calcite 1.6.", .min = 1.01, .max = 3});
  }
};

using ClearCoatBsdf = LobeBsdf<ClearCoatLobe>;

class CoatedMaterial final : public Material {
 public:
  explicit CoatedMaterial(const Coated& p)
      : albedo_(p.albedo),
        roughness_(static_cast<float>(p.roughness)),
        face_(&InterfaceTable::of(static_cast<float>(p.ior))) {}

  const Bsdf& at(const Surface& surface, const Vec3f& out, BsdfMemory& memory) const override {
    return memory.make<ClearCoatBsdf>(ClearCoatLobe(
        from_rec709_(albedo_ * surface.color), ClearCoatLobe::Base::wet,
        std::max(filtered_roughness(roughness_, surface.slope_variance), surface.blur), *face_,
        out));
  }
  size_t memory_bytes() const override { return BsdfMemory::bytes<ClearCoatBsdf>(); }
  float wetness(const Surface&) const override { return 1; }
  exchange::Look look(const Surface& surface) const override {
    exchange::Look look;
    look.base_color = Vec3d(albedo_ * surface.color);
    look.wetness = 1;
    look.coat_roughness = static_cast<double>(roughness_);
    return look;
  }
  MaterialPtr in_space(const image::ColourMatrix& from_rec709) const override {
    auto copy = std::make_shared<CoatedMaterial>(*this);
    copy->from_rec709_ = from_rec709;
    return copy;
  }

 private:
  Rgb albedo_;
  image::ColourMatrix from_rec709_;
  float roughness_;
  const InterfaceTable* face_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(coated, material, MaterialPtr, Coated, CoatedMaterial)
