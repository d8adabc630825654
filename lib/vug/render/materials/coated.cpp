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

/// What is the same everywhere: the film's face and what it sends back from within.
struct Film {
  float width, ior, inside;

  /// Density of facet normals (GGX).
  float slopes(const Vec3f& h) const {
    const float a2 = width * width;
    const float d = (h.x * h.x + h.y * h.y) / a2 + h.z * h.z;
    return 1 / (kPif * a2 * d * d);
  }
  float root(const Vec3f& v) const {
    const float a2 = width * width;
    return std::sqrt(a2 * (v.x * v.x + v.y * v.y) + v.z * v.z);
  }
  /// The rock as seen through the face: entering squeezes light by ior^2, and what the face
  /// sends back is reflected again.
  Rgb through(const Rgb& rho) const {
    const auto one = [&](float r) { return r / (ior * ior * (1 - r * inside)); };
    return {one(rho.x), one(rho.y), one(rho.z)};
  }
};

class CoatedBsdf final : public Bsdf {
 public:
  CoatedBsdf(const Film& film, const Rgb& rock, const Vec3f& out)
      : film_(film), base_(film.through(rock)), out_(out), clear_(1 - fresnel(out.z, film.ior)) {
    const float face = 1 - clear_;
    face_odds_ = std::clamp(face / (face + clear_ * largest(base_)), 0.1f, 0.9f);
  }

  Scattering evaluate(const Vec3f& in) const override {
    if (!(in.z > 0)) return {};
    const Vec3f h = normalized(out_ + in);
    const float slopes = film_.slopes(h), root = film_.root(out_);
    const float face =
        fresnel(dot(out_, h), film_.ior) * slopes / (2 * (in.z * root + out_.z * film_.root(in)));
    const float face_pdf = slopes / (2 * (out_.z + root));
    return {base_ * (clear_ * (1 - fresnel(in.z, film_.ior)) * in.z / kPif), Rgb(face * in.z),
            face_odds_ * face_pdf + (1 - face_odds_) * in.z / kPif};
  }
  BsdfSample sample(float lobe, const Vec2f& u) const override {
    Vec3f in;
    if (lobe < face_odds_) {
      const float width = film_.width;
      const Vec3f stretched = normalized(Vec3f(width * out_.x, width * out_.y, out_.z));
      const Vec3f cap = direction_at((1 - u.x) * (1 + stretched.z) - stretched.z, u.y) + stretched;
      const Vec3f h = normalized(Vec3f(width * cap.x, width * cap.y, std::max(cap.z, 1e-9f)));
      in = normalized(h * (2 * dot(out_, h)) - out_);
    } else {
      in = sample_cosine_hemisphere(u);
    }
    const Scattering s = evaluate(in);
    if (!(s.pdf > 0)) return {};
    return {in, s.total() * (1 / s.pdf), s.diffuse * (1 / s.pdf), s.pdf};
  }
  Rgb albedo() const override { return base_ * ((1 - film_.inside) * film_.ior * film_.ior); }

 private:
  Film film_;
  Rgb base_;
  Vec3f out_;
  float clear_, face_odds_;
};

class CoatedMaterial final : public Material {
 public:
  explicit CoatedMaterial(const Coated& p)
      : albedo_(p.albedo),
        film_{static_cast<float>(p.roughness * p.roughness), static_cast<float>(p.ior), 0} {
    constexpr int kSteps = 256;
    float outside = 0;  // mean reflectance for even light from outside
    for (int i = 0; i < kSteps; ++i) {
      const float c = (static_cast<float>(i) + 0.5f) / kSteps;
      outside += 2 * c * fresnel(c, film_.ior) / kSteps;
    }
    film_.inside = 1 - (1 - outside) / (film_.ior * film_.ior);
  }

  const Bsdf& at(const Surface& surface, const Vec3f& out, BsdfMemory& memory) const override {
    return memory.make<CoatedBsdf>(film_, albedo_ * surface.color, out);
  }
  size_t memory_bytes() const override { return BsdfMemory::bytes<CoatedBsdf>(); }

 private:
  Rgb albedo_;
  Film film_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(coated, material, MaterialPtr, Coated, CoatedMaterial)
