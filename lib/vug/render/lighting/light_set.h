// All lights of a scene that sampling can turn to, and the choice between them.
#pragma once

#include <vug/render/guiding/visibility_cache.h>
#include <vug/render/light.h>
#include <vug/render/lighting/emitters.h>
#include <vug/render/lighting/light_selection.h>
#include <vug/render/lighting/light_tree.h>
#include <vug/render/media/medium.h>

#include <vector>

namespace vug::render {

/// Ids: first the scene's lights in order, then triangles that shine. Skies and portals, and the
/// upper branches of a tree of lamps and of one of triangles, are weighed one by one; from a
/// branch the choice goes down its tree.
class LightSet {
 public:
  /// Error(bad_input) for a light that is linked to the name of no object.
  LightSet(std::vector<LightPtr> lights, const std::vector<Object>& objects);
  LightSet(const LightSet&) = delete;
  LightSet& operator=(const LightSet&) = delete;

  /// Lights that can be chosen.
  size_t size() const { return size_; }
  /// Parts of all lights, each weighed as one.
  size_t branches() const { return branches_.size(); }

  /// Chooses lights with one uniform number: `selection` tells how many and what is known, and is
  /// told the rest.
  LightChoices choose(const LightSampleContext& point, float u, LightSelection& selection) const;
  /// For a place that is yet to be chosen on a ray; `visibility`, which may be empty, in place of
  /// the odds' own.
  LightChoices choose_along(const Ray& ray, const Segment& segment, float u,
                            LightSelection selection, const VisibilityCache& visibility) const;
  /// A light of one branch; none where the branch cannot shine.
  LightChoice choose_in(size_t branch, const LightSampleContext& point, float u) const;
  /// Samples to expect for that light: its probability in `choose` at a point where that gave
  /// `selection`; 0 for a light that cannot shine there.
  float pmf(LightId light, const LightSampleContext& point, const LightSelection& selection) const;

  /// See Light.
  LightSample sample(LightId light, const LightSampleContext& point, const Vec2f& u) const {
    return light < lights_.size() ? lights_[light]->sample(point, u)
                                  : emitters_.sample(light - scene_light_count(), point, u);
  }
  /// For a direction in which the light is seen from there.
  float pdf(LightId light, const LightSampleContext& point, const Vec3f& direction) const {
    return light < lights_.size() ? lights_[light]->pdf(point, direction)
                                  : emitters_.pdf(light - scene_light_count(), point, direction);
  }
  Vec3f center(LightId light) const {
    return light < lights_.size() ? lights_[light]->center()
                                  : emitters_.center(light - scene_light_count());
  }
  /// Names of the groups of lights, and a light's place in that list; kNoGroup without one.
  const std::vector<std::string>& groups() const { return group_names_; }
  uint32_t group(LightId light) const {
    return light < lights_.size() ? light_groups_[light]
                                  : object_groups_[emitters_.object(light - scene_light_count())];
  }
  static constexpr uint32_t kNoGroup = ~0u;
  /// False for a light that is linked to other objects than that; all light media and the camera.
  bool reaches(LightId light, uint32_t object) const {
    return !linked_ || object == kNoObject || light >= lit_.size() || lit_[light].empty() ||
           lit_[light][object];
  }
  /// Some triangles shine by their material, which knows how much only at the place: see Emitters.
  bool emission_varies() const { return emitters_.emission_varies(); }
  Rgb emission(uint32_t object, uint32_t triangle, float u, float v, float footprint) const {
    return emitters_.radiance(emitters_.index_of(object, triangle), u, v, footprint);
  }
  /// False for a triangle that was found dark when the tree was made: no choice leads to it.
  bool can_choose(LightId emitter) const { return emitter_tree_.contains(emitter); }
  /// The id of a triangle that shines.
  LightId emitter(uint32_t object, uint32_t triangle) const {
    return scene_light_count() + emitters_.index_of(object, triangle);
  }

  /// Calls visit(id, lamp) for each lamp that the ray may meet before `end` and that lights the
  /// object the ray comes from.
  template <class Visit>
  void for_each_light_on(const Ray& ray, float end, uint32_t object, const Visit& visit) const {
    light_tree_.for_each_hit(ray, end, [&](LightId id) {
      if (reaches(id, object)) visit(id, *lights_[id]);
    });
  }

  bool has_sky() const { return !skies_.empty(); }
  /// No light knows where the sky shines: there are no portals, and but for suns no sky samples
  /// directions.
  bool sky_is_plain() const;
  const std::vector<LightId>& skies() const { return skies_; }
  /// Of all skies that light the object.
  Rgb sky_radiance(const Vec3f& direction, uint32_t object) const;
  /// Skies that can be chosen: portals and skies that these would hardly find, or where there are
  /// no portals all skies that sample directions.
  const std::vector<LightId>& sampled_skies() const { return sampled_skies_; }
  const Light& sky(LightId id) const { return *lights_[id]; }
  /// Density with which sampling lights by these odds turns to the sky in a direction; without one
  /// that the caller knows of.
  float sky_pdf(const LightSampleContext& point, const LightSelection& selection,
                const Vec3f& direction, LightId known = kNoLight) const;

 private:
  /// What is weighed one by one: a sky, or a branch of a tree.
  struct Branch {
    const LightTree* tree = nullptr;  ///< Null for a sky.
    uint32_t index = 0;               ///< In the tree.
    LightId single = kNoLight;        ///< The sky, or a lamp whose fork has lamps only,
    float scale = 1;                  ///< and what its importance stands against others' with.
    Vec3f center;                     ///< Meaningless for whole skies.
  };
  struct AtPoint;
  struct AlongRay;
  void link(const std::vector<Object>& objects);
  uint32_t group_of(const std::string& name);
  LightId scene_light_count() const { return static_cast<LightId>(lights_.size()); }
  LightChoices choose_evenly(float u, uint32_t object, LightSelection& selection) const;
  bool can_choose(LightId light, uint32_t object) const;
  template <class Weight>
  float weight_of(size_t branch, const Weight& weight) const;
  template <class Weight>
  void weigh(const Weight& weight, float* weights) const;
  template <class Weight>
  LightChoices choose_by(float u, const Weight& weight, LightSelection& selection) const;
  template <class Weight>
  LightChoice choose_in(const Branch& branch, double u, const Weight& weight) const;

  std::vector<LightPtr> lights_;
  Emitters emitters_;
  LightTree light_tree_, emitter_tree_;
  std::vector<Branch> branches_;
  std::vector<LightId> skies_, sampled_skies_;
  std::vector<LightId> all_;  ///< That may shine somewhere, for choices that know no more.
  float sky_scale_ = 0;
  std::vector<std::vector<bool>> lit_;  ///< Of each light: by object; empty for all of them.
  bool linked_ = false;
  std::vector<std::string> group_names_;
  std::vector<uint32_t> light_groups_, object_groups_;
  size_t size_ = 0;
};

}  // namespace vug::render
