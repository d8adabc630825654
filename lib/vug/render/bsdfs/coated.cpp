// Diffuse rock under a clear film: wet stone, varnish, or with a rough face plain dry rock.
// The film's face is a GGX microfacet dielectric (Walter et al. 2007, "Microfacet models for
// refraction through rough surfaces", walter2007ggx) with height-correlated masking (Heitz 2014)
// and sampled by visible normals (Dupuy and Benyoub 2023, "Sampling visible GGX normals with
// spherical caps", dupuy2023caps). Light that enters is reflected by the rock again and again
// below the face, which darkens it as water does: Jensen, Legakis, Dorsey 1999, "Rendering of
// wet materials" (jensen1999wet), in closed form for a smooth face. Energy that a rough face
// loses between its facets is not given back.
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct Coated {
  Vec3d albedo{0.5, 0.5, 0.5};
  double roughness = 0.3;
  double ior = 1.33;

  static void describe(Schema<Coated>& s) {
    s.doc("Diffuse rock under a clear film, such as water.")
        .cite("walter2007ggx")
        .param("albedo", &Coated::albedo,
               {.doc = "Share of the light that the dry rock reflects; the vertex colour "
                       "multiplies it.",
                .min = 0,
                .max = 1})
        .param("roughness", &Coated::roughness,
               {.doc = "Of the film's face: 0.05 to 0.2 wet, 0.7 to 0.95 dry; its square is the "
                       "width of the microfacet slopes.",
                .min = 0.03,
                .max = 1})
        .param("ior", &Coated::ior,
               {.doc = "Index of refraction: water 1.33, calcite 1.6.", .min = 1.01, .max = 3});
  }
};

/// Reflectance of an unpolarised dielectric for light from outside at a cosine.
float fresnel(float cosine, float ior) {
  const float c = std::clamp(cosine, 0.0f, 1.0f);
  const float g = std::sqrt(ior * ior - 1 + c * c);
  const float a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5f * a * a * (1 + b * b);
}

class CoatedBsdf final : public Bsdf {
 public:
  explicit CoatedBsdf(const Coated& p)
      : albedo_(p.albedo),
        width_(static_cast<float>(p.roughness * p.roughness)),
        ior_(static_cast<float>(p.ior)) {
    constexpr int kSteps = 256;
    float outside = 0;  // mean reflectance for even light from outside
    for (int i = 0; i < kSteps; ++i) {
      const float c = (static_cast<float>(i) + 0.5f) / kSteps;
      outside += 2 * c * fresnel(c, ior_) / kSteps;
    }
    inside_ = 1 - (1 - outside) / (ior_ * ior_);
  }

  Rgb evaluate(const Surface& surface, const Vec3f& out, const Vec3f& in) const override {
    if (!(in.z > 0 && out.z > 0)) return Rgb(0.0f);
    const Vec3f h = normalized(out + in);
    const float face =
        fresnel(dot(out, h), ior_) * slopes(h) / (2 * (in.z * root(out) + out.z * root(in)));
    return (base(surface) * ((1 - fresnel(out.z, ior_)) * (1 - fresnel(in.z, ior_)) / kPif) +
            Rgb(face)) *
           in.z;
  }
  float pdf(const Surface& surface, const Vec3f& out, const Vec3f& in) const override {
    if (!(in.z > 0 && out.z > 0)) return 0;
    const Vec3f h = normalized(out + in);
    const float face = slopes(h) / (2 * (out.z + root(out)));
    const float odds = face_odds(surface, out);
    return odds * face + (1 - odds) * in.z / kPif;
  }
  BsdfSample sample(const Surface& surface, const Vec3f& out, float lobe,
                    const Vec2f& u) const override {
    Vec3f in;
    if (lobe < face_odds(surface, out)) {
      const Vec3f stretched = normalized(Vec3f(width_ * out.x, width_ * out.y, out.z));
      const Vec3f cap = direction_at((1 - u.x) * (1 + stretched.z) - stretched.z, u.y) + stretched;
      const Vec3f h = normalized(Vec3f(width_ * cap.x, width_ * cap.y, std::max(cap.z, 1e-9f)));
      in = normalized(h * (2 * dot(out, h)) - out);
    } else {
      in = sample_cosine_hemisphere(u);
    }
    const float density = pdf(surface, out, in);
    if (!(density > 0)) return {};
    return {in, evaluate(surface, out, in) * (1 / density), density};
  }
  Rgb albedo(const Surface& surface) const override {
    return base(surface) * ((1 - inside_) * ior_ * ior_);
  }

 private:
  /// The rock as seen through the face: entering squeezes light by ior^2, and what the face
  /// sends back is reflected again.
  Rgb base(const Surface& surface) const {
    const Rgb rho = albedo_ * surface.color;
    const auto through = [&](float r) { return r / (ior_ * ior_ * (1 - r * inside_)); };
    return {through(rho.x), through(rho.y), through(rho.z)};
  }
  /// Density of facet normals (GGX).
  float slopes(const Vec3f& h) const {
    const float a2 = width_ * width_;
    const float d = (h.x * h.x + h.y * h.y) / a2 + h.z * h.z;
    return 1 / (kPif * a2 * d * d);
  }
  float root(const Vec3f& v) const {
    const float a2 = width_ * width_;
    return std::sqrt(a2 * (v.x * v.x + v.y * v.y) + v.z * v.z);
  }
  float face_odds(const Surface& surface, const Vec3f& out) const {
    const float face = fresnel(out.z, ior_), rock = (1 - face) * largest(base(surface));
    return std::clamp(face / (face + rock), 0.1f, 0.9f);
  }

  Rgb albedo_;
  float width_, ior_, inside_ = 0;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(coated, bsdf, BsdfPtr, Coated, CoatedBsdf)
