// Ideal diffuse reflection, the same on both sides.
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct Lambert {
  Vec3d albedo{0.5, 0.5, 0.5};

  static void describe(Schema<Lambert>& s) {
    s.doc("Ideal diffuse reflection, the same on both sides of the surface.")
        .param("albedo", &Lambert::albedo,
               {.doc = "Share of the light that is reflected, linear Rec.709; the vertex colour "
                       "multiplies it.",
                .min = 0,
                .max = 1});
  }
};

class LambertBsdf final : public Bsdf {
 public:
  explicit LambertBsdf(const Lambert& p) : albedo_(to_float(p.albedo)) {}

  Rgb evaluate(const Surface& surface, const Vec3f&, const Vec3f& in) const override {
    return in.z > 0 ? albedo(surface) * (in.z / kPif) : Rgb(0.0f);
  }
  float pdf(const Surface&, const Vec3f&, const Vec3f& in) const override {
    return in.z > 0 ? in.z / kPif : 0;
  }
  BsdfSample sample(const Surface& surface, const Vec3f&, float, const Vec2f& u) const override {
    const Vec3f in = sample_cosine_hemisphere(u);
    return {in, albedo(surface), in.z / kPif};
  }
  Rgb albedo(const Surface& surface) const override { return albedo_ * surface.color; }

 private:
  Rgb albedo_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(lambert, bsdf, BsdfPtr, Lambert, LambertBsdf)
