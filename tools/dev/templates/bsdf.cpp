//@ lib/vug/render/bsdfs
// STUB: the model and its source.
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct NewKind {
  Vec3d albedo{0.5, 0.5, 0.5};

  static void describe(Schema<NewKind>& s) {
    s.doc("STUB: what it looks like, in one sentence.")
        .param("albedo", &NewKind::albedo,
               {.doc = "STUB: share of the light that is reflected", .min = 0, .max = 1});
  }
};

/// Directions are local (z is the shading normal); see Bsdf for what each function promises.
class NewKindBsdf final : public Bsdf {
 public:
  explicit NewKindBsdf(const NewKind& p) : albedo_(to_float(p.albedo)) {}

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

VUG_RENDER_KIND(new_kind, bsdf, BsdfPtr, NewKind, NewKindBsdf)
