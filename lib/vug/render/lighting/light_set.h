// SPDX-License-Identifier: Apache-2.0
// All lights of a scene that can be sampled, and the choice between them.
#pragma once

#include <vug/render/guiding/visibility_cache.h>
#include <vug/render/light.h>
#include <vug/render/lighting/emitters.h>
#include <vug/render/lighting/light_selection.h>
#include <vug/render/lighting/light_tree.h>
#include <vug/render/media/medium.h>

#include <vector>

namespace vug::render {

/// Light ids: first the scene's lights in order, then the emissive triangles. Skies, portals and
/// the top branches of two light trees (one of the scene's lights, one of emissive triangles) are
/// weighted one by one; within a branch the choice descends its tree.
class LightSet {
 public:
  /// Links to the objects `omitted` have no effect. Error(bad_input) if a light is linked to
  /// another object name that does not exist.
  LightSet(std::vector<LightPtr> lights, const std::vector<Object>& objects,
           const std::vector<std::string>& omitted = {});
  LightSet(const LightSet&) = delete;
  LightSet& operator=(const LightSet&) = delete;

  /// Number of lights that can be chosen.
  size_t size() const { return size_; }
  /// Number of branches; together they hold all lights, and each is weighted as one.
  size_t branches() const { return branches_.size(); }

  /// Chooses lights with one uniform number. `selection` gives their number and the known
  /// visibility; its other members are set.
  LightChoices choose(const LightSampleContext& point, float u, LightSelection& selection) const;
  /// The same for a point that is yet to be chosen on a ray. `visibility` (may be empty) replaces
  /// that of the selection.
  LightChoices choose_along(const Ray& ray, const Segment& segment, float u,
                            LightSelection selection, const VisibilityCache& visibility) const;
  /// Chooses a light of one branch; kNoLight if the branch contributes nothing.
  LightChoice choose_in(size_t branch, const LightSampleContext& point, float u) const;
  /// Expected number of samples of that light: its probability in `choose` at a point where
  /// `choose` returned `selection`; 0 for a light that contributes nothing there.
  float pmf(LightId light, const LightSampleContext& point, const LightSelection& selection) const;

  /// See Light.
  LightSample sample(LightId light, const LightSampleContext& point, const Vec2f& u) const {
    return light < lights_.size() ? lights_[light]->sample(point, u)
                                  : emitters_.sample(light - scene_light_count(), point, u);
  }
  /// For a direction in which the light is visible from the point.
  float pdf(LightId light, const LightSampleContext& point, const Vec3f& direction) const {
    return light < lights_.size() ? lights_[light]->pdf(point, direction)
                                  : emitters_.pdf(light - scene_light_count(), point, direction);
  }
  Vec3f center(LightId light) const {
    return light < lights_.size() ? lights_[light]->center()
                                  : emitters_.center(light - scene_light_count());
  }
  /// Names of the light groups, and a light's index in that list; kNoGroup without a group.
  const std::vector<std::string>& groups() const { return group_names_; }
  uint32_t group(LightId light) const {
    return light < lights_.size() ? light_groups_[light]
                                  : object_groups_[emitters_.object(light - scene_light_count())];
  }
  static constexpr uint32_t kNoGroup = ~0u;
  /// False if the light is linked to other objects; every light reaches media and the camera.
  bool reaches(LightId light, uint32_t object) const {
    return !linked_ || object == kNoObject || light >= lit_.size() || lit_[light].empty() ||
           lit_[light][object];
  }
  /// Some triangles have an emissive material, which is evaluated at the hit point: see Emitters.
  bool emission_varies() const { return emitters_.emission_varies(); }
  Rgb emission(uint32_t object, uint32_t triangle, float u, float v, float footprint) const {
    return emitters_.radiance(emitters_.index_of(object, triangle), u, v, footprint);
  }
  /// False for a triangle whose estimated emission was zero when the tree was built: it is never
  /// chosen.
  bool can_choose(LightId emitter) const { return emitter_tree_.contains(emitter); }
  /// Id of an emissive triangle.
  LightId emitter(uint32_t object, uint32_t triangle) const {
    return scene_light_count() + emitters_.index_of(object, triangle);
  }

  /// Calls visit(id, light) for each finite light that the ray may hit before `end` and that
  /// reaches the object the ray comes from.
  template <class Visit>
  void for_each_light_on(const Ray& ray, float end, uint32_t object, const Visit& visit) const {
    light_tree_.for_each_hit(ray, end, [&](LightId id) {
      if (reaches(id, object)) visit(id, *lights_[id]);
    });
  }

  bool has_sky() const { return !skies_.empty(); }
  /// False if the scene has portals already, or if a sun shines in addition to a sky that samples
  /// directions: near an opening, portals would take most of the shadow rays from the sun.
  bool needs_portals() const;
  const std::vector<LightId>& skies() const { return skies_; }
  /// Sum over all skies that light the object.
  Rgb sky_radiance(const Vec3f& direction, uint32_t object) const;
  /// Skies that can be chosen: the portals, and all skies that sample directions.
  const std::vector<LightId>& sampled_skies() const { return sampled_skies_; }
  const Light& sky(LightId id) const { return *lights_[id]; }
  /// Density with which light sampling by this selection chooses a sky direction, excluding the
  /// light `known`.
  float sky_pdf(const LightSampleContext& point, const LightSelection& selection,
                const Vec3f& direction, LightId known = kNoLight) const;

 private:
  /// An item weighted on its own: a sky, or a branch of a tree.
  struct Branch {
    const LightTree* tree = nullptr;  ///< Null for a sky.
    uint32_t index = 0;               ///< Lane index in the tree.
    LightId single = kNoLight;        ///< The sky, or the light of a node that has only leaves.
    float scale = 1;  ///< Factor that makes the importance of `single` comparable with that of
                      ///< other branches.
    Vec3f center;     ///< Meaningless for whole skies.
  };
  struct AtPoint;
  struct AlongRay;
  void link(const std::vector<Object>& objects, const std::vector<std::string>& omitted);
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
  std::vector<LightId> all_;  ///< All lights that may emit, for uniform choices.
  bool has_portals_ = false;
  float sky_scale_ = 0;
  std::vector<std::vector<bool>> lit_;  ///< For each light: by object; empty for all objects.
  bool linked_ = false;
  std::vector<std::string> group_names_;
  std::vector<uint32_t> light_groups_, object_groups_;
  size_t size_ = 0;
};

}  // namespace vug::render
