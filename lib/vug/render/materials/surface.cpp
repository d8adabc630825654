// The surface for everything: a mix of lobes by weights that may vary, in the spirit of OpenPBR
// (Andersson et al. 2024, openpbr2024). It differs in that lobes lie beside each other in shares
// rather than above each other wherever that keeps the whole reciprocal and without loss; only
// what matters for rock is layered: a face over a coloured body, and water over it.
#include <vug/base/maths.h>
#include <vug/exchange/look.h>
#include <vug/render/input.h>
#include <vug/render/kind.h>
#include <vug/render/lamp.h>
#include <vug/render/lobes/eon.h>
#include <vug/render/lobes/film.h>
#include <vug/render/lobes/fuzz.h>
#include <vug/render/lobes/glass.h>
#include <vug/render/lobes/metal.h>
#include <vug/render/lobes/pane.h>
#include <vug/render/lobes/sheet.h>
#include <vug/render/placing.h>

#include <array>
#include <variant>

namespace vug::render {
namespace {

struct SurfaceParams {
  ColorInput color = Vec3d(0.5);
  NumberInput matte = 0.5;
  NumberInput specular = 0.3;
  NumberInput roughness = 0.5;
  double ior = 1.5;
  NumberInput metal = 0;
  NumberInput coat = 0;
  NumberInput coat_roughness = 0.1;
  double coat_ior = 1.33;
  NumberInput fuzz = 0;
  ColorInput fuzz_color = Vec3d(1);
  NumberInput fuzz_roughness = 0.5;
  NumberInput subsurface = 0;
  double mean_free_path = 0.005;
  NumberInput transmission = 0;
  Vec3d tint{1, 1, 1};
  double tint_depth = 1;
  bool thin = false;
  NumberInput through = 0.5;
  ColorInput through_color = Vec3d(1);
  NumberInput opacity = 1;
  ColorInput emission = Vec3d(1);
  NumberInput emission_mask = 1;
  double emission_radiance = 0;
  NumberInput bump = 0;
  double bump_height = 0.002;

  static void describe(Schema<SurfaceParams>& s);
};

void SurfaceParams::describe(Schema<SurfaceParams>& s) {
  using P = SurfaceParams;
  const auto share = [](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .min = 0, .max = 1};
  };
  const auto roughness = [&](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .min = 0, .max = 1};
  };
  s.doc("Rock, water, ice, crystal, metal, moss: a mix of lobes by shares that may vary.")
      .cite("openpbr2024")
      .param("color", &P::color,
             share("What the body reflects, linear Rec.709; the vertex colour multiplies it."))
      .param("matte", &P::matte,
             share("Roughness of the diffuse reflection: 0 Lambert's, 1 dust and sandstone."))
      .param("specular", &P::specular,
             share("Share of the rock that has a clear face; the rest is matte."))
      .param("roughness", &P::roughness,
             roughness("Of faces, of metal and of what is seen through: 0 a mirror, 0.7 to 0.95 "
                       "dry rock."))
      .param("ior", &P::ior,
             {.doc = "Index of refraction: quartz 1.55, calcite 1.6, ice 1.31.",
              .min = 1.01,
              .max = 3})
      .param("metal", &P::metal, share("Share that is metal of that colour."))
      .param("coat", &P::coat, share("Share that a film of water covers: wetness."))
      .param("coat_roughness", &P::coat_roughness, roughness("Of the film's face."))
      .param("coat_ior", &P::coat_ior, {.doc = "Index of the film.", .min = 1.01, .max = 3})
      .param("fuzz", &P::fuzz, share("Share of the rock that fibres cover: moss, dust."))
      .param("fuzz_color", &P::fuzz_color, share("Colour of the fibres."))
      .param("fuzz_roughness", &P::fuzz_roughness, roughness("Low: a narrow rim of light."))
      .param("subsurface", &P::subsurface,
             share("Share in whose body light wanders before it comes out: calcite, ice."))
      .param("mean_free_path", &P::mean_free_path,
             positive_length("How far light flies in that body between two collisions."))
      .param("transmission", &P::transmission, share("Share that is clear: water, crystal."))
      .param("tint", &P::tint,
             {.doc = "Colour that white light has after `tint_depth` in the clear body.",
              .min = 0,
              .max = 1,
              .above_min = true})
      .param("tint_depth", &P::tint_depth, positive_length("See tint."))
      .param("thin", &P::thin,
             {.doc = "A sheet without a body, the same from both sides: leaves, curtains, panes. "
                     "Light that goes in comes out at once, in front or behind."})
      .param("through", &P::through,
             share("Of a thin sheet's subsurface share: the part that comes out behind."))
      .param("through_color", &P::through_color,
             share("What a thin sheet takes from light that goes through it."))
      .param("opacity", &P::opacity,
             share("Part that is there at all: 0 where the mesh has holes, which let light and "
                   "shadow rays through."))
      .param("emission_radiance", &P::emission_radiance,
             {.doc = "Radiance (W/sr/m^2) that the outside sends out where its colour and mask are "
                     "1: such objects are lamps.",
              .min = 0,
              .max = kMostRadiance})
      .param("emission", &P::emission, share("Colour of that light."))
      .param("emission_mask", &P::emission_mask, share("Part of that light: cracks of lava."))
      .param("bump", &P::bump, share("Height of small forms, as a part of bump_height."))
      .param("bump_height", &P::bump_height, any_length("Height of the bump where it is 1."));
}

using Lobe = std::variant<EonLobe, FilmLobe, MetalLobe, FuzzLobe, GlassLobe, PaneLobe, SheetLobe>;

/// The albedo of single collisions for which a deep body of that colour reflects it: the inverse
/// of van de Hulst's fit 1980 (cite vandehulst1980), exact for white and black.
float single_albedo(float color) {
  const float b = 1.139f + 1.17f * color;
  const float s = 2 * (1 - color) / (b + std::sqrt(b * b - 0.556f * (1 - color)));
  return std::max(0.0f, 1 - s * s);
}

class SurfaceBsdf final : public Bsdf {
 public:
  SurfaceBsdf() {}  // NOLINT: leaves raw_ as it is
  void add(float weight, const Lobe& lobe) {
    if (!(weight > 0)) return;
    const Rgb albedo = std::visit([](const auto& l) { return l.albedo(); }, lobe);
    const float odds = weight * std::max(largest(albedo), 0.05f);
    push(weight, lobe, odds);
    if (!std::holds_alternative<MetalLobe>(lobe) && !std::holds_alternative<GlassLobe>(lobe) &&
        !std::holds_alternative<PaneLobe>(lobe))
      broad_ += odds;
  }
  /// A face whose body is a cloud.
  void add_cloud(float weight, const FilmLobe& face, const Cloud& cloud, const Rgb& color) {
    if (!(weight > 0)) return;
    add(weight, face);
    beneath_ = cloud;
    into_ = weight * face.clear();
    cloud_color_ = color;
    into_odds_ = into_ * std::max(largest(color), 0.05f);
    total_ += into_odds_;
  }
  void set_thin() { thin_ = true; }
  void set_lit_from_behind() { behind_ = true; }
  void set_absorption(const Rgb& absorption) { absorption_ = absorption; }

  Scattering evaluate(const Vec3f& in) const override {
    Scattering sum;
    for (size_t i = 0; i < count_; ++i) {
      const Scattering s = std::visit([&](const auto& l) { return l.evaluate(in); }, part(i).lobe);
      sum.diffuse += s.diffuse * part(i).weight;
      sum.specular += s.specular * part(i).weight;
      sum.pdf += s.pdf * (part(i).odds / total_);
    }
    return sum;
  }
  BsdfSample sample(float lobe, const Vec2f& u) const override {
    float rest = lobe * total_;
    for (size_t i = 0; i < count_; ++i) {
      const float odds = part(i).odds;
      if (!(rest < odds) && (i + 1 < count_ || into_odds_ > 0)) {
        rest -= odds;
        continue;
      }
      const float within = std::min(rest / odds, 0x1.fffffep-1f);
      const Vec3f in = std::visit([&](const auto& l) { return l.sample(within, u); }, part(i).lobe);
      if (in.z == 0) return {};
      const Scattering s = evaluate(in);
      if (!(s.pdf > 0)) return {};
      return {in, s.total() * (1 / s.pdf), s.diffuse * (1 / s.pdf), s.pdf};
    }
    Vec3f in = sample_cosine_hemisphere(u);
    in.z = -in.z;
    const Rgb weight(into_ * total_ / into_odds_);
    return {in, weight, weight, -in.z / kPif * into_odds_ / total_, this, true};
  }
  Rgb albedo() const override {
    Rgb sum = cloud_color_ * into_;
    for (size_t i = 0; i < count_; ++i)
      sum += std::visit([](const auto& l) { return l.albedo(); }, part(i).lobe) * part(i).weight;
    return sum;
  }
  float guided() const override { return into_ > 0 ? 0 : 0.5f * broad_ / total_; }
  Rgb absorption() const override { return absorption_; }
  Cloud beneath() const override { return beneath_; }
  bool thin() const override { return thin_; }
  bool lit_from_behind() const override { return thin_ || behind_; }

 private:
  struct Part {
    Lobe lobe;
    float weight, odds;
  };
  static constexpr size_t kMost = 8;
  void push(float weight, const Lobe& lobe, float odds) {
    new (raw_ + sizeof(Part) * count_++) Part{lobe, weight, odds};
    total_ += odds;
  }

  Part& part(size_t i) { return *std::launder(reinterpret_cast<Part*>(raw_) + i); }
  const Part& part(size_t i) const {
    return *std::launder(reinterpret_cast<const Part*>(raw_) + i);
  }

  size_t count_ = 0;
  float total_ = 0, broad_ = 0;
  float into_ = 0, into_odds_ = 0;  ///< Light that goes beneath.
  bool thin_ = false, behind_ = false;
  Cloud beneath_;
  Rgb cloud_color_{0, 0, 0}, absorption_{0, 0, 0};
  alignas(Part) std::byte raw_[kMost * sizeof(Part)];  // parts are made when added
};

/// Light that comes out of a body through its face, as if it were even within.
class LeavingBsdf final : public Bsdf {
 public:
  LeavingBsdf(float roughness, const FaceTable& face) : face_(roughness, face, {0, 0, 1}) {}

  Scattering evaluate(const Vec3f& in) const override {
    if (!(in.z > 0)) return {};
    const float even = in.z / kPif;
    return {Rgb(face_.lets_in(in.z) / (1 - face_.mean) * even), Rgb(0.0f), even};
  }
  BsdfSample sample(float, const Vec2f& u) const override {
    const Vec3f in = sample_cosine_hemisphere(u);
    const Scattering s = evaluate(in);
    if (!(s.pdf > 0)) return {};
    return {in, s.diffuse * (1 / s.pdf), s.diffuse * (1 / s.pdf), s.pdf};
  }
  Rgb albedo() const override { return Rgb(1.0f); }

 private:
  FaceShare face_;
};

/// Of a pane, over even light.
float mean_reflectance(float ior) {
  constexpr int kSteps = 256;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = (i + 0.5) / kSteps;
    sum += 2 * cosine * static_cast<double>(pane_reflectance(static_cast<float>(cosine), ior));
  }
  return static_cast<float>(sum / kSteps);
}

class SurfaceMaterial final : public Material {
 public:
  explicit SurfaceMaterial(const SurfaceParams& p)
      : p_(p),
        face_(&FaceTable::of(static_cast<float>(p.ior))),
        film_(&FaceTable::of(static_cast<float>(p.coat_ior))) {
    const bool clear = p.transmission.varying || p.transmission.constant > 0;
    if (clear && p.thin) pane_mean_ = mean_reflectance(face_->ior());
    if (clear && !p.thin) glass_ = &GlassTable::of(face_->ior());
    for (int c = 0; c < 3; ++c)
      absorption_[c] = static_cast<float>(-maths::log(p.tint[c]) / p.tint_depth);
  }

  const Bsdf& at(const Surface& surface, const Vec3f& out, BsdfMemory& memory) const override;
  size_t memory_bytes() const override { return BsdfMemory::bytes<SurfaceBsdf>(); }
  bool bump(Surface& surface) const override;
  bool thin() const override { return p_.thin; }
  bool cut_out() const override { return p_.opacity.varying || p_.opacity.constant < 1; }
  float opacity(const Surface& surface) const override {
    return p_.opacity.at(SurfaceSpot(surface).spot());
  }
  bool shines() const override {
    return p_.emission_radiance > 0 &&
           (p_.emission_mask.varying || p_.emission_mask.constant > 0) &&
           (p_.emission.varying || p_.emission.constant != Vec3d(0));
  }
  Rgb emission(const Surface& surface) const override {
    const SurfaceSpot place(surface);
    const float part = p_.emission_mask.at(place.spot());
    if (!(part > 0)) return Rgb(0.0f);
    return p_.emission.at(place.spot()) * (part * static_cast<float>(p_.emission_radiance));
  }
  const Bsdf* leaving(const Surface& surface, BsdfMemory& memory) const override {
    const SurfaceSpot place(surface);
    return &memory.make<LeavingBsdf>(face_roughness(place.spot()), *face_);
  }
  float wetness(const Surface& surface) const override {
    return p_.coat.at(SurfaceSpot(surface).spot());
  }
  exchange::Look look(const Surface& surface) const override;
  MaterialPtr in_space(const image::ColourMatrix& way) const override {
    SurfaceParams p = p_;
    p.color.way = p.fuzz_color.way = p.emission.way = p.through_color.way = way;
    p.tint = way(p.tint);
    return std::make_shared<SurfaceMaterial>(p);
  }

 private:
  float face_roughness(const paint::Spot& spot) const {
    return std::max(p_.roughness.at(spot), kSmoothest);
  }

  SurfaceParams p_;
  const FaceTable *face_, *film_;
  const GlassTable* glass_ = nullptr;
  float pane_mean_ = 0;
  Rgb absorption_;
};

/// Fibres, which such programs have other words for, each its own, only lend their colour.
exchange::Look SurfaceMaterial::look(const Surface& surface) const {
  const SurfaceSpot place(surface);
  const paint::Spot& spot = place.spot();
  const auto number = [&](const NumberInput& input) { return static_cast<double>(input.at(spot)); };
  const float furry = p_.fuzz.at(spot) * (1 - p_.subsurface.at(spot));
  exchange::Look look;
  look.base_color =
      Vec3d(p_.color.at(spot, surface.color) * (1 - furry) + p_.fuzz_color.at(spot) * furry);
  look.roughness = number(p_.roughness);
  look.specular = number(p_.specular);
  look.ior = p_.ior;
  look.metallic = number(p_.metal);
  look.transmission = number(p_.transmission);
  look.subsurface = number(p_.subsurface);
  look.wetness = number(p_.coat);
  look.coat_roughness = number(p_.coat_roughness);
  look.thin = p_.thin;
  if (p_.thin) {  // what comes out behind is not reflected
    const double behind = number(p_.subsurface) * number(p_.through);
    look.through = look.base_color * Vec3d(p_.through_color.at(spot)) * behind;
    look.base_color *= 1 - behind;
  }
  return look;
}

const Bsdf& SurfaceMaterial::at(const Surface& surface, const Vec3f& out,
                                BsdfMemory& memory) const {
  const SurfaceSpot place(surface);
  const paint::Spot& spot = place.spot();
  SurfaceBsdf& bsdf = memory.make<SurfaceBsdf>();
  const Rgb color = p_.color.at(spot, surface.color);
  const float roughness = std::max(face_roughness(spot), surface.blur);
  const float metal = p_.metal.at(spot), clear = p_.transmission.at(spot) * (1 - metal);
  const float body = 1 - metal - clear, wet = body * p_.coat.at(spot), dry = body - wet;
  const float cloudy = p_.subsurface.at(spot), furry = p_.fuzz.at(spot);
  const float rock = dry * (1 - cloudy), bare = rock * (1 - furry);
  const float faces = bare * p_.specular.at(spot);

  if (bare > faces) bsdf.add(bare - faces, EonLobe(color, p_.matte.at(spot), out));
  if (faces > 0)
    bsdf.add(faces, FilmLobe(color, FilmLobe::Below::polished, roughness, *face_, out));
  if (rock * furry > 0)
    bsdf.add(rock * furry,
             FuzzLobe(p_.fuzz_color.at(spot), p_.fuzz_roughness.at(spot), color, out));
  if (wet > 0) {
    const float film = std::max(p_.coat_roughness.at(spot), std::max(kSmoothest, surface.blur));
    bsdf.add(wet, FilmLobe(color, FilmLobe::Below::wet, film, *film_, out));
  }
  if (metal > 0) bsdf.add(metal, MetalLobe(color, roughness, out));
  if (p_.thin) {
    bsdf.set_thin();
    const Rgb passes = p_.through_color.at(spot);
    if (clear > 0) bsdf.add(clear, PaneLobe(passes, roughness, face_->ior(), pane_mean_, out));
    if (const float part = dry * cloudy; part > 0) {
      const float behind = p_.through.at(spot);
      if (behind < 1)
        bsdf.add(part * (1 - behind),
                 FilmLobe(color, FilmLobe::Below::polished, roughness, *face_, out));
      bsdf.add(part * behind, SheetLobe(color * passes, roughness, *face_, out));
    }
    return bsdf;
  }
  if (clear > 0) {
    bsdf.add(clear, GlassLobe(roughness, *face_, *glass_, surface.inside, out));
    bsdf.set_absorption(absorption_);
    // Lobes of smooth faces are narrower than most lamps; and from outside the way to a lamp in the
    // body would swallow light.
    if (surface.inside && roughness > 0.1f) bsdf.set_lit_from_behind();
  }
  if (dry * cloudy > 0) {
    const FilmLobe face(color, FilmLobe::Below::open, roughness, *face_, out);
    bsdf.add_cloud(dry * cloudy, face,
                   {static_cast<float>(p_.mean_free_path),
                    {single_albedo(color.x), single_albedo(color.y), single_albedo(color.z)}},
                   color);
  }
  return bsdf;
}

/// Central differences of the height along the surface.
bool SurfaceMaterial::bump(Surface& surface) const {
  if (!p_.bump.varying) return false;
  // An instance is larger or smaller with all of its forms.
  const bool scaled = surface.placing && !surface.looks_by_place;
  const float height =
      static_cast<float>(p_.bump_height) * (scaled ? surface.placing->stretch() : 1);
  const float step = std::max(0.5f * surface.footprint, 0.25f * std::fabs(height));
  SurfaceSpot place(surface);
  const Vec3f n = surface.shading_normal * (surface.inside ? -1.0f : 1.0f);
  const Frame frame(n);
  const auto slope = [&](const Vec3f& along) {
    place.move_to(surface.position + along * step);
    const float ahead = p_.bump.at(place.spot());
    place.move_to(surface.position - along * step);
    return (ahead - p_.bump.at(place.spot())) * height / (2 * step);
  };
  const Vec3f bent = normalized(n - frame.x * slope(frame.x) - frame.y * slope(frame.y));
  surface.shading_normal = bent * (surface.inside ? -1.0f : 1.0f);
  return true;
}

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(surface, material, MaterialPtr, SurfaceParams, SurfaceMaterial)
