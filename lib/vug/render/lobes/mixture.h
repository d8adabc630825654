// SPDX-License-Identifier: Apache-2.0
// Weighted mixture of lobes.
#pragma once

#include <vug/render/lobes/clear_coat.h>
#include <vug/render/lobes/dielectric.h>
#include <vug/render/lobes/eon.h>
#include <vug/render/lobes/fuzz.h>
#include <vug/render/lobes/metal.h>
#include <vug/render/lobes/thin_dielectric.h>
#include <vug/render/lobes/thin_sheet.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <variant>

namespace vug::render {

using Lobe = std::variant<EonLobe, ClearCoatLobe, MetalLobe, FuzzLobe, DielectricLobe,
                          ThinDielectricLobe, ThinSheetLobe>;

/// The weights sum to at most 1. A direction is sampled from one lobe, chosen by weight and albedo.
class LobeMixture final : public Bsdf {
 public:
  LobeMixture() {}  // NOLINT: leaves raw_ as it is
  void add(float weight, const Lobe& lobe) {
    if (!(weight > 0)) return;
    const Rgb albedo = std::visit([](const auto& l) { return l.albedo(); }, lobe);
    const float sampling_weight = weight * std::max(largest(albedo), 0.05f);
    push(weight, lobe, sampling_weight);
    if (!std::holds_alternative<MetalLobe>(lobe) && !std::holds_alternative<DielectricLobe>(lobe) &&
        !std::holds_alternative<ThinDielectricLobe>(lobe))
      broad_ += sampling_weight;
    glossy_ |= std::visit([](const auto& l) { return is_glossy(l); }, lobe);
  }
  /// Adds an interface over a scattering body.
  void add_subsurface(float weight, const ClearCoatLobe& face, const SubsurfaceMedium& medium,
                      const Rgb& color) {
    if (!(weight > 0)) return;
    add(weight, face);
    subsurface_ = medium;
    subsurface_weight_ = weight * face.transmitted();
    subsurface_color_ = color;
    subsurface_sampling_weight_ = subsurface_weight_ * std::max(largest(color), 0.05f);
    total_ += subsurface_sampling_weight_;
  }
  void set_thin() { thin_ = true; }
  void set_lit_from_behind() { behind_ = true; }
  void set_absorption(const Rgb& absorption) { absorption_ = absorption; }

  Scattering evaluate(const Vec3f& in) const override {
    Scattering sum;
    for (size_t i = 0; i < count_; ++i) {
      const Scattering s =
          std::visit([&](const auto& l) { return l.evaluate(in); }, lobe_at(i).lobe);
      sum.diffuse += s.diffuse * lobe_at(i).weight;
      sum.specular += s.specular * lobe_at(i).weight;
      sum.pdf += s.pdf * (lobe_at(i).sampling_weight / total_);
    }
    return sum;
  }
  BsdfSample sample(float lobe, const Vec2f& u) const override {
    float rest = lobe * total_;
    for (size_t i = 0; i < count_; ++i) {
      const float sampling_weight = lobe_at(i).sampling_weight;
      if (!(rest < sampling_weight) && (i + 1 < count_ || subsurface_sampling_weight_ > 0)) {
        rest -= sampling_weight;
        continue;
      }
      const float within = std::min(rest / sampling_weight, 0x1.fffffep-1f);
      const Vec3f in =
          std::visit([&](const auto& l) { return l.sample(within, u); }, lobe_at(i).lobe);
      if (in.z == 0) return {};
      const Scattering s = evaluate(in);
      if (!(s.pdf > 0)) return {};
      return {in, s.total() * (1 / s.pdf), s.diffuse * (1 / s.pdf), s.pdf};
    }
    Vec3f in = sample_cosine_hemisphere(u);
    in.z = -in.z;
    const Rgb weight(subsurface_weight_ * total_ / subsurface_sampling_weight_);
    return {in, weight, weight, -in.z / kPif * subsurface_sampling_weight_ / total_, this, true};
  }
  Rgb albedo() const override {
    Rgb sum = subsurface_color_ * subsurface_weight_;
    for (size_t i = 0; i < count_; ++i)
      sum +=
          std::visit([](const auto& l) { return l.albedo(); }, lobe_at(i).lobe) * lobe_at(i).weight;
    return sum;
  }
  float guided_fraction() const override { return 0.5f * broad_ / total_; }
  float subsurface_fraction() const override { return subsurface_sampling_weight_ / total_; }
  bool glossy() const override { return glossy_; }
  Rgb absorption() const override { return absorption_; }
  SubsurfaceMedium subsurface() const override { return subsurface_; }
  bool thin() const override { return thin_; }
  bool lit_from_behind() const override { return thin_ || behind_; }

 private:
  struct WeightedLobe {
    Lobe lobe;
    float weight, sampling_weight;
  };
  static constexpr size_t kMax = 8;
  void push(float weight, const Lobe& lobe, float sampling_weight) {
    new (raw_ + sizeof(WeightedLobe) * count_++) WeightedLobe{lobe, weight, sampling_weight};
    total_ += sampling_weight;
  }

  WeightedLobe& lobe_at(size_t i) {
    return *std::launder(reinterpret_cast<WeightedLobe*>(raw_) + i);
  }
  const WeightedLobe& lobe_at(size_t i) const {
    return *std::launder(reinterpret_cast<const WeightedLobe*>(raw_) + i);
  }

  size_t count_ = 0;
  float total_ = 0, broad_ = 0;
  float subsurface_weight_ = 0, subsurface_sampling_weight_ = 0;  ///< Light that enters the body.
  bool thin_ = false, behind_ = false, glossy_ = false;
  SubsurfaceMedium subsurface_;
  Rgb subsurface_color_{0, 0, 0}, absorption_{0, 0, 0};
  alignas(WeightedLobe) std::byte raw_[kMax * sizeof(WeightedLobe)];  // constructed by add()
};

}  // namespace vug::render
