// SPDX-License-Identifier: Apache-2.0
// General surface material: a mixture of lobes with weights that may vary, in the spirit of OpenPBR
// (Andersson et al. 2024, openpbr2024). Unlike there, lobes are mixed in fractions rather than
// layered wherever that keeps the material reciprocal and energy conserving. Only the layers that
// matter for rock are modelled: an interface over a coloured body, and water over it.
#include <vug/base/maths.h>
#include <vug/exchange/look.h>
#include <vug/render/geometry/instance_transform.h>
#include <vug/render/kind.h>
#include <vug/render/lighting/light_output.h>
#include <vug/render/lobes/mixture.h>
#include <vug/render/lobes/subsurface_exit.h>
#include <vug/render/materials/material_input.h>

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
  s.doc("Rock, water, ice, crystal, metal, moss: a mixture of lobes in fractions that may vary.")
      .cite("openpbr2024")
      .param(
          "color", &P::color,
          share("Reflected fraction of the body, linear Rec.709; the vertex colour multiplies it."))
      .param("matte", &P::matte,
             share("Roughness of the diffuse reflection: 0 Lambertian, 1 dust and sandstone."))
      .param("specular", &P::specular,
             share("Fraction of the rock with a clear interface; the rest is matte."))
      .param(
          "roughness", &P::roughness,
          roughness(
              "Roughness of interfaces, metal and transmission: 0 a mirror, 0.7 to 0.95 dry rock."))
      .param("ior", &P::ior,
             {.doc = "Index of refraction: quartz 1.55, calcite 1.6, ice 1.31.",
              .min = 1.01,
              .max = 3})
      .param("metal", &P::metal, share("Fraction that is metal of that colour."))
      .param("coat", &P::coat, share("Fraction covered by a film of water: wetness."))
      .param("coat_roughness", &P::coat_roughness, roughness("Roughness of the film."))
      .param("coat_ior", &P::coat_ior,
             {.doc = "Index of refraction of the film.", .min = 1.01, .max = 3})
      .param("fuzz", &P::fuzz, share("Fraction of the rock covered by fibres: moss, dust."))
      .param("fuzz_color", &P::fuzz_color, share("Colour of the fibres."))
      .param("fuzz_roughness", &P::fuzz_roughness,
             roughness("Roughness of the fibres; low: a narrow rim of light."))
      .param("subsurface", &P::subsurface,
             share("Fraction with subsurface scattering: calcite, ice."))
      .param("mean_free_path", &P::mean_free_path,
             positive_length("Mean distance between two collisions in that body."))
      .param("transmission", &P::transmission, share("Fraction that is clear: water, crystal."))
      .param("tint", &P::tint,
             {.doc = "Colour of white light after `tint_depth` in the clear body.",
              .min = 0,
              .max = 1,
              .above_min = true})
      .param("tint_depth", &P::tint_depth,
             positive_length("Distance at which light has the colour `tint`."))
      .param("thin", &P::thin,
             {.doc = "A sheet without a body, the same from both sides: leaves, curtains, panes. "
                     "Light that enters leaves at once, in front or behind."})
      .param("through", &P::through,
             share("Of a thin sheet's subsurface fraction: the part that leaves behind."))
      .param("through_color", &P::through_color,
             share("Colour of light transmitted by a thin sheet."))
      .param(
          "opacity", &P::opacity,
          share("Coverage: 0 where the mesh has holes, which let light and shadow rays through."))
      .param("emission_radiance", &P::emission_radiance,
             {.doc = "Radiance (W/sr/m^2) emitted by the outside where emission and emission_mask "
                     "are 1: such objects are lights.",
              .min = 0,
              .max = kMaxRadiance})
      .param("emission", &P::emission, share("Colour of the emission."))
      .param("emission_mask", &P::emission_mask, share("Factor of the emission: cracks of lava."))
      .param("bump", &P::bump, share("Height of small detail, as a fraction of bump_height."))
      .param("bump_height", &P::bump_height, any_length("Height of the bump where it is 1."));
}

/// Differences longer than this multiple of the smallest detail do not resolve it.
constexpr float kCoarse = 1.5f;

/// Albedo of single collisions for which a deep body reflects `color`: the inverse of van de
/// Hulst's fit 1980 (cite vandehulst1980), exact for white and black.
float single_scattering_albedo(float color) {
  const float b = 1.139f + 1.17f * color;
  const float s = 2 * (1 - color) / (b + std::sqrt(b * b - 0.556f * (1 - color)));
  return std::max(0.0f, 1 - s * s);
}

class SurfaceMaterial final : public Material {
 public:
  explicit SurfaceMaterial(const SurfaceParams& p)
      : p_(p),
        face_(&InterfaceTable::of(static_cast<float>(p.ior))),
        coat_(&InterfaceTable::of(static_cast<float>(p.coat_ior))) {
    const bool clear = p.transmission.varying || p.transmission.constant > 0;
    if (clear && p.thin) thin_mean_ = mean_thin_dielectric_reflectance(face_->ior());
    if (clear && !p.thin) glass_ = &DielectricTable::of(face_->ior());
    for (int c = 0; c < 3; ++c)
      absorption_[c] = static_cast<float>(-maths::log(p.tint[c]) / p.tint_depth);
  }

  const Bsdf& at(const Surface& surface, const Vec3f& out, BsdfMemory& memory) const override;
  size_t memory_bytes() const override { return BsdfMemory::bytes<LobeMixture>(); }
  bool bump(Surface& surface) const override;
  bool thin() const override { return p_.thin; }
  bool cut_out() const override { return p_.opacity.varying || p_.opacity.constant < 1; }
  float opacity(const Surface& surface) const override {
    return p_.opacity.at(SurfacePoint(surface).eval_point());
  }
  bool is_emissive() const override {
    return p_.emission_radiance > 0 &&
           (p_.emission_mask.varying || p_.emission_mask.constant > 0) &&
           (p_.emission.varying || p_.emission.constant != Vec3d(0));
  }
  Rgb emission(const Surface& surface) const override {
    const SurfacePoint place(surface);
    const float part = p_.emission_mask.at(place.eval_point());
    if (!(part > 0)) return Rgb(0.0f);
    return p_.emission.at(place.eval_point()) * (part * static_cast<float>(p_.emission_radiance));
  }
  const Bsdf* subsurface_exit(const Surface& surface, BsdfMemory& memory) const override {
    const SurfacePoint place(surface);
    return &memory.make<SubsurfaceExitBsdf>(face_roughness(place.eval_point()), *face_);
  }
  float wetness(const Surface& surface) const override {
    return p_.coat.at(SurfacePoint(surface).eval_point());
  }
  exchange::Look look(const Surface& surface) const override;
  bool refers_to_scene() const override {
    const auto any = [](const auto&... inputs) { return (inputs.refers_to_scene() || ...); };
    return any(p_.color, p_.matte, p_.specular, p_.roughness, p_.metal, p_.coat, p_.coat_roughness,
               p_.fuzz, p_.fuzz_color, p_.fuzz_roughness, p_.subsurface, p_.transmission,
               p_.through, p_.through_color, p_.opacity, p_.emission, p_.emission_mask, p_.bump);
  }
  MaterialPtr in_space(const image::ColourMatrix& from_rec709) const override {
    SurfaceParams p = p_;
    p.color.from_rec709 = p.fuzz_color.from_rec709 = p.emission.from_rec709 =
        p.through_color.from_rec709 = from_rec709;
    p.tint = from_rec709(p.tint);
    return std::make_shared<SurfaceMaterial>(p);
  }

 private:
  float face_roughness(const paint::EvalPoint& point) const {
    return std::max(p_.roughness.at(point), kMinRoughness);
  }

  SurfaceParams p_;
  const InterfaceTable *face_, *coat_;
  const DielectricTable* glass_ = nullptr;
  float thin_mean_ = 0;
  Rgb absorption_;
};

/// Other programs describe fibres in different ways, so fibres contribute only their colour.
exchange::Look SurfaceMaterial::look(const Surface& surface) const {
  const SurfacePoint place(surface);
  const paint::EvalPoint& point = place.eval_point();
  const auto number = [&](const NumberInput& input) {
    return static_cast<double>(input.at(point));
  };
  const float furry = p_.fuzz.at(point) * (1 - p_.subsurface.at(point));
  exchange::Look look;
  look.base_color =
      Vec3d(p_.color.at(point, surface.color) * (1 - furry) + p_.fuzz_color.at(point) * furry);
  look.roughness = number(p_.roughness);
  look.specular = number(p_.specular);
  look.ior = p_.ior;
  look.metallic = number(p_.metal);
  look.transmission = number(p_.transmission);
  look.subsurface = number(p_.subsurface);
  look.wetness = number(p_.coat);
  look.coat_roughness = number(p_.coat_roughness);
  look.thin = p_.thin;
  if (p_.thin) {  // light that leaves behind is not reflected
    const double behind = number(p_.subsurface) * number(p_.through);
    look.through = look.base_color * Vec3d(p_.through_color.at(point)) * behind;
    look.base_color *= 1 - behind;
  }
  return look;
}

const Bsdf& SurfaceMaterial::at(const Surface& surface, const Vec3f& out,
                                BsdfMemory& memory) const {
  const SurfacePoint place(surface);
  const paint::EvalPoint& point = place.eval_point();
  LobeMixture& bsdf = memory.make<LobeMixture>();
  const Rgb color = p_.color.at(point, surface.color);
  const auto seen = [&](float own) {
    return std::max(filtered_roughness(std::max(own, kMinRoughness), surface.slope_variance),
                    surface.blur);
  };
  const float roughness = seen(p_.roughness.at(point));
  const float metal = p_.metal.at(point), clear = p_.transmission.at(point) * (1 - metal);
  const float body = 1 - metal - clear, wet = body * p_.coat.at(point), dry = body - wet;
  const float cloudy = p_.subsurface.at(point), furry = p_.fuzz.at(point);
  const float rock = dry * (1 - cloudy), bare = rock * (1 - furry);
  const float faces = bare * p_.specular.at(point);

  if (bare > faces) bsdf.add(bare - faces, EonLobe(color, p_.matte.at(point), out));
  if (faces > 0)
    bsdf.add(faces, ClearCoatLobe(color, ClearCoatLobe::Base::polished, roughness, *face_, out));
  if (rock * furry > 0)
    bsdf.add(rock * furry,
             FuzzLobe(p_.fuzz_color.at(point), p_.fuzz_roughness.at(point), color, out));
  if (wet > 0) {
    bsdf.add(wet, ClearCoatLobe(color, ClearCoatLobe::Base::wet, seen(p_.coat_roughness.at(point)),
                                *coat_, out));
  }
  if (metal > 0) bsdf.add(metal, MetalLobe(color, roughness, out));
  if (p_.thin) {
    bsdf.set_thin();
    const Rgb passes = p_.through_color.at(point);
    if (clear > 0)
      bsdf.add(clear, ThinDielectricLobe(passes, roughness, face_->ior(), thin_mean_, out));
    if (const float part = dry * cloudy; part > 0) {
      const float behind = p_.through.at(point);
      if (behind < 1)
        bsdf.add(part * (1 - behind),
                 ClearCoatLobe(color, ClearCoatLobe::Base::polished, roughness, *face_, out));
      bsdf.add(part * behind, ThinSheetLobe(color * passes, roughness, *face_, out));
    }
    return bsdf;
  }
  if (clear > 0) {
    bsdf.add(clear, DielectricLobe(roughness, *face_, *glass_, surface.inside, out));
    bsdf.set_absorption(absorption_);
    // Lobes of smooth interfaces are narrower than most lights. From outside, light from a light
    // inside the body would have to be absorbed along the way, so it is not sampled.
    if (surface.inside && roughness > 0.1f) bsdf.set_lit_from_behind();
  }
  if (dry * cloudy > 0) {
    const ClearCoatLobe face(color, ClearCoatLobe::Base::open, roughness, *face_, out);
    bsdf.add_subsurface(dry * cloudy, face,
                        {static_cast<float>(p_.mean_free_path),
                         {single_scattering_albedo(color.x), single_scattering_albedo(color.y),
                          single_scattering_albedo(color.z)}},
                        color);
  }
  return bsdf;
}

/// Central differences of the height along the surface. Where the footprint is larger than the
/// detail, four shorter differences estimate the slopes that these do not resolve.
bool SurfaceMaterial::bump(Surface& surface) const {
  if (!p_.bump.varying) return false;
  // An instance scales the bumps with the mesh.
  const bool scaled = surface.instance && !surface.world_space_material;
  const float height =
      static_cast<float>(p_.bump_height) * (scaled ? surface.instance->mean_scale() : 1);
  const float detail = 0.25f * std::fabs(height);
  const float step = std::max(0.5f * surface.footprint, detail);
  SurfacePoint place(surface);
  const Vec3f n = surface.shading_normal * (surface.inside ? -1.0f : 1.0f);
  const Frame frame(n);
  const auto at = [&](const Vec3f& offset) {
    place.move_to(surface.position + offset);
    return p_.bump.at(place.eval_point());
  };
  const bool finer = step > kCoarse * detail && detail > 0;
  float squares = 0;  // of the slopes over `detail`
  const auto slope = [&](const Vec3f& along) {
    const float ahead = at(along * step), behind = at(along * -step);
    if (finer)
      for (const auto& [value, sign] : {std::pair(ahead, 1.0f), std::pair(behind, -1.0f)}) {
        const float fine = (at(along * (sign * (step + detail))) - value) * height / detail;
        squares += fine * fine;
      }
    return (ahead - behind) * height / (2 * step);
  };
  const float x = slope(frame.x), y = slope(frame.y);
  if (finer) surface.slope_variance = std::max(0.0f, 0.25f * squares - 0.5f * (x * x + y * y));
  const Vec3f bent = normalized(n - frame.x * x - frame.y * y);
  surface.shading_normal = bent * (surface.inside ? -1.0f : 1.0f);
  return true;
}

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(surface, material, MaterialPtr, SurfaceParams, SurfaceMaterial)
