// SPDX-License-Identifier: Apache-2.0
// Two materials mixed by a mask.
#include <vug/base/error.h>
#include <vug/exchange/look.h>
#include <vug/render/kind.h>
#include <vug/render/materials/material_input.h>

namespace vug::render {
namespace {

struct Mix {
  MaterialPtr a;
  MaterialPtr b;
  NumberInput mask = 0.5;

  std::string fault() const {
    if (!a || !b) return {};
    if (a->thin() != b->thin()) return "a thin sheet cannot be mixed with a body";
    return a->memory_bytes() + b->memory_bytes() + 512 > BsdfMemory::kBytes
               ? "the mixture has too many materials for one surface point"
               : "";
  }
  static void describe(Schema<Mix>& s) {
    s.doc("Two materials: the first where the mask is 0, the second where it is 1.")
        .param("a", &Mix::a, {.doc = "the first", .required = true})
        .param("b", &Mix::b, {.doc = "the second", .required = true})
        .param("mask", &Mix::mask, {.doc = "fraction of the second", .min = 0, .max = 1});
  }
};

class MixBsdf final : public Bsdf {
 public:
  MixBsdf(const Bsdf& a, const Bsdf& b, float share) : a_(&a), b_(&b), share_(share) {}

  Scattering evaluate(const Vec3f& in) const override {
    const Scattering a = a_->evaluate(in), b = b_->evaluate(in);
    return {a.diffuse * (1 - share_) + b.diffuse * share_,
            a.specular * (1 - share_) + b.specular * share_, a.pdf * (1 - share_) + b.pdf * share_};
  }
  BsdfSample sample(float lobe, const Vec2f& u) const override {
    // In the order of `lobe`: above the surface the second and the first, then the same below it.
    const float below_a = a_->subsurface_fraction(), below_b = b_->subsurface_fraction();
    const float above_a = (1 - share_) * (1 - below_a), above_b = share_ * (1 - below_b);
    const float above = above_a + above_b;
    bool second;
    float rest;
    if (lobe < above) {
      second = lobe < above_b;
      rest = second ? lobe / share_ : (lobe - above_b) / (1 - share_);
      rest = std::min(rest, 1 - (second ? below_b : below_a));
    } else {
      const float all_b = share_ * below_b;
      second = lobe - above < all_b;
      rest = second ? 1 - below_b + (lobe - above) / share_
                    : 1 - below_a + (lobe - above - all_b) / (1 - share_);
    }
    const Bsdf* one = second ? b_ : a_;
    BsdfSample s = one->sample(std::min(rest, 0x1.fffffep-1f), u);
    if (!(s.pdf > 0)) return {};
    if (!s.body) s.body = one;
    if (s.subsurface) {
      // The lobe's weight and its sampling probability have the same factor, so the sample's weight
      // is unchanged.
      s.pdf *= second ? share_ : 1 - share_;
      return s;
    }
    const Scattering both = evaluate(s.direction);
    if (!(both.pdf > 0)) return {};
    return {s.direction, both.total() * (1 / both.pdf), both.diffuse * (1 / both.pdf), both.pdf,
            s.body};
  }
  float guided_fraction() const override {
    return a_->guided_fraction() * (1 - share_) + b_->guided_fraction() * share_;
  }
  float subsurface_fraction() const override {
    return a_->subsurface_fraction() * (1 - share_) + b_->subsurface_fraction() * share_;
  }
  bool glossy() const override { return a_->glossy() || b_->glossy(); }
  Rgb absorption() const override {
    return is_black(a_->absorption()) ? b_->absorption() : a_->absorption();
  }
  bool thin() const override { return a_->thin() && b_->thin(); }
  bool lit_from_behind() const override { return a_->lit_from_behind() || b_->lit_from_behind(); }
  Rgb albedo() const override { return a_->albedo() * (1 - share_) + b_->albedo() * share_; }

 private:
  const Bsdf *a_, *b_;
  float share_;
};

class MixMaterial final : public Material {
 public:
  explicit MixMaterial(const Mix& p) : p_(p) {}

  const Bsdf& at(const Surface& surface, const Vec3f& out, BsdfMemory& memory) const override {
    const float share = share_at(surface);
    if (share <= 0) return p_.a->at(surface, out, memory);
    if (share >= 1) return p_.b->at(surface, out, memory);
    const Bsdf& a = p_.a->at(surface, out, memory);
    const Bsdf& b = p_.b->at(surface, out, memory);
    return memory.make<MixBsdf>(a, b, share);
  }
  size_t memory_bytes() const override {
    return p_.a->memory_bytes() + p_.b->memory_bytes() + BsdfMemory::bytes<MixBsdf>();
  }
  bool bump(Surface& surface) const override {
    return (share_at(surface) < 0.5f ? p_.a : p_.b)->bump(surface);
  }
  bool thin() const override { return p_.a->thin(); }
  bool cut_out() const override { return p_.a->cut_out() || p_.b->cut_out(); }
  float opacity(const Surface& surface) const override {
    const float share = share_at(surface);
    return p_.a->opacity(surface) * (1 - share) + p_.b->opacity(surface) * share;
  }
  bool is_emissive() const override { return p_.a->is_emissive() || p_.b->is_emissive(); }
  Rgb emission(const Surface& surface) const override {
    const float share = share_at(surface);
    return p_.a->emission(surface) * (1 - share) + p_.b->emission(surface) * share;
  }
  const Bsdf* subsurface_exit(const Surface& surface, BsdfMemory& memory) const override {
    if (const Bsdf* a = p_.a->subsurface_exit(surface, memory)) return a;
    return p_.b->subsurface_exit(surface, memory);
  }
  float wetness(const Surface& surface) const override {
    const float share = share_at(surface);
    return p_.a->wetness(surface) * (1 - share) + p_.b->wetness(surface) * share;
  }
  exchange::Look look(const Surface& surface) const override {
    return exchange::blend(p_.a->look(surface), p_.b->look(surface),
                           static_cast<double>(share_at(surface)));
  }
  bool refers_to_scene() const override {
    return p_.mask.refers_to_scene() || p_.a->refers_to_scene() || p_.b->refers_to_scene();
  }
  MaterialPtr in_space(const image::ColourMatrix& from_rec709) const override {
    Mix p = p_;
    p.a = p.a->in_space(from_rec709), p.b = p.b->in_space(from_rec709);
    return std::make_shared<MixMaterial>(p);
  }

 private:
  float share_at(const Surface& surface) const {
    return p_.mask.at(SurfacePoint(surface).eval_point());
  }

  Mix p_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(mix, material, MaterialPtr, Mix, MixMaterial)
