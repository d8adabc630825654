// A scene made ready for rays: the acceleration structure and the choice of lights.
#pragma once

#include <vug/render/light.h>
#include <vug/render/medium.h>
#include <vug/render/scene.h>

#include <memory>
#include <vector>

namespace vug::render {

/// The nearest surface on a ray.
struct Hit {
  float distance = 0;
  const Material* material = nullptr;
  Surface surface;
  /// Where rays leave from, on the viewer's side: lifted to the smooth surface that vertex normals
  /// stand for, against shadow steps (Hanika 2021, "Hacking the shadow terminator",
  /// cite hanika2021terminator), and clear of the triangle itself.
  Vec3f origin;
  Vec3f behind;  ///< Where rays leave from that the surface lets through.
};

/// How next-event estimation at one place shares its samples out between the lights.
struct LightOdds {
  bool all = false;  ///< Every light that matters gets a sample.
  float total = 0;   ///< Sum of all importances; else half of the choices are in proportion to it,
  float count = 0;   ///< and half are even between the lights that matter.

  /// Samples to expect for a light of that importance. Importance knows nothing of walls, so a
  /// light behind one must not take the choices from the one that shines: the even half keeps
  /// any light's share above 1 / (2 count) (a defensive mixture: Hesterberg 1995, "Weighted average
  /// importance sampling and defensive mixture distributions", cite hesterberg1995).
  float of(float importance) const {
    if (!(importance > 0)) return 0;
    return all ? 1 : 0.5f * (importance / total + 1 / count);
  }
};

/// Which light next-event estimation turns to, and with what probability.
struct LightChoice {
  const Light* light = nullptr;
  float probability = 0;
  LightOdds odds;
};

class World {
 public:
  /// Keeps references into the scene's meshes. Throws as `render` does.
  explicit World(const Scene& scene);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// False when nothing is hit.
  bool intersect(const Ray& ray, Hit& hit) const;
  /// True when a surface lies on the ray before `distance`.
  bool occluded(const Ray& ray, float distance) const;
  const Box3f& bounds() const;

  /// Lamps: what a ray meets on its way. Skies: what it gathers when it escapes.
  const std::vector<const Light*>& lamps() const { return lamps_; }
  bool has_sky() const { return !skies_.empty(); }
  const std::vector<const Light*>& skies() const { return skies_; }
  Rgb sky_radiance(const Vec3f& direction) const;
  /// Portals, or without any the skies that sample directions themselves.
  const std::vector<const Light*>& sampled_skies() const { return sampled_skies_; }

  /// All lights that can be sampled: lamps and `sampled_skies`.
  const std::vector<const Light*>& sampled() const { return sampled_; }
  /// Chooses one of them by its odds, with one uniform number; null when none matters.
  LightChoice choose(const LitPoint& point, float u) const;
  LightChoice choose_along(const Ray& ray, const Segment& segment, float u) const;
  /// As `choose` weighs it; 0 where it cannot shine.
  float importance(const Light& light, const LitPoint& point) const;
  float importance_along(const Light& light, const Ray& ray, const Segment& segment) const;
  /// Density with which sampling lights by these odds turns to the sky in a direction.
  float sky_pdf(const LitPoint& point, const LightOdds& odds, const Vec3f& direction) const;

  const Medium* medium() const { return medium_.get(); }

 private:
  struct Geometry;
  template <class Weight>
  LightChoice choose_by(float u, const Weight& weight) const;

  std::unique_ptr<Geometry> geometry_;
  std::vector<LightPtr> owned_;
  std::vector<const Light*> lamps_, skies_;
  std::vector<const Light*> sampled_, sampled_skies_;
  float sky_scale_ = 1;
  MediumPtr medium_;
};

}  // namespace vug::render
