// Lobes side by side, in shares.
#pragma once

#include <vug/render/lobes/eon.h>
#include <vug/render/lobes/clear_coat.h>
#include <vug/render/lobes/fuzz.h>
#include <vug/render/lobes/dielectric.h>
#include <vug/render/lobes/metal.h>
#include <vug/render/lobes/thin_dielectric.h>
#include <vug/render/lobes/thin_sheet.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <variant>

namespace vug::render {

using Lobe = std::variant<EonLobe, FilmLobe, MetalLobe, FuzzLobe, GlassLobe, PaneLobe, SheetLobe>;

/// Weights add up to 1 at most. A direction is taken from one lobe, by weight and albedo.
class LobeMixture final : public Bsdf {
 public:
  LobeMixture() {}  // NOLINT: leaves raw_ as it is
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

}  // namespace vug::render
