// SPDX-License-Identifier: Apache-2.0
// Splits the light of a path by light component and light group, for pictures with such AOVs.
#pragma once

#include <vug/render/vectors.h>

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace vug::render {

class Material;
class PreparedScene;
struct Surface;
struct SurfaceAov;

/// The components that sum to the beauty: directly visible emission, and for all other light the
/// last scattering event before the camera, and whether the light arrived there directly from its
/// source. Diffuse and specular refer to reflection.
enum class LightComponent : size_t {
  emission,
  diffuse_direct,
  diffuse_indirect,
  specular_direct,
  specular_indirect,
  transmission_direct,
  transmission_indirect,
  volume_direct,
  volume_indirect,
  count
};
/// The name and the content of the AOV of a light component.
struct LightComponentInfo {
  std::string name;
  std::string doc;
};
/// In the order of LightComponent.
const std::vector<LightComponentInfo>& light_components();

/// The values of a recorder, in order: all LightComponents or none; one colour per light group;
/// then values read at the first surface, which are not light but are summed like it: surface AOVs
/// and mesh attributes.
struct LightPathPlan {
  bool components = false;
  size_t groups = 0;
  std::vector<const SurfaceAov*> surface;
  std::vector<std::string> attributes;  ///< Attribute names.
  /// From the indices of LightSet::groups() to colours; groups without an AOV are not included.
  std::unordered_map<uint32_t, size_t> group_of;
  bool motion = false;  ///< True if a last colour, which is not light, holds the motion vector.

  /// The number of values before those read at surfaces, and of all values.
  size_t lights() const {
    return (components ? static_cast<size_t>(LightComponent::count) : 0) + groups;
  }
  size_t colours() const { return lights() + surface.size() + attributes.size(); }
};

/// The light of one path. An integrator records what each light contributes at a vertex, before the
/// path's throughput is applied, and then flushes these records with the throughput.
class LightPathRecorder {
 public:
  explicit LightPathRecorder(const LightPathPlan& plan)
      : plan_(plan), colours_(plan.colours() + (plan.motion ? 1 : 0)) {}

  /// Call this before each path.
  void clear();
  /// Call this at the first surface of a path.
  void read_surface(const Surface& surface, const Material& material);
  /// Records light of a group. `diffuse`: the share of `light` reflected by diffuse lobes; only
  /// needed for light that a surface at depth 0 reflects.
  void record(uint32_t group, const Rgb& light, const Rgb& diffuse = Rgb(0.0f));
  /// Records light from the environment: from all environments that illuminate the object.
  void record_environment(const PreparedScene& world, uint32_t object, const Vec3f& direction,
                          const Rgb& weight, const Rgb& diffuse_weight = Rgb(0.0f));

  /// Adds the recorded emission that a ray hits; the ray starts at the vertex before `depth`.
  void flush_emission(int depth, const Rgb& scale);
  /// Adds the recorded light that the surface at `depth` reflects, or that the medium in front of
  /// it scatters into the ray.
  void flush_surface(int depth, const Rgb& scale);
  void flush_medium(int depth, const Rgb& scale);

  /// The scattering event at depth 0: in a medium, or at a surface. At a surface, `diffuse` is the
  /// share of `weight` from diffuse lobes, unless the light is transmitted (`through`).
  void scattered_in_medium();
  void scattered_at_surface(bool through, const Rgb& weight, const Rgb& diffuse);

  /// LightPathPlan::colours() values, then the motion.
  const std::vector<Rgb>& colours() const { return colours_; }
  void set_motion(const Vec2f& motion) { colours_.back() = {motion.x, motion.y, 0}; }

 private:
  struct Record {
    uint32_t group;
    Rgb light, diffuse;
  };
  Rgb& component(LightComponent p) { return colours_[static_cast<size_t>(p)]; }
  void add_scattered(const Rgb& light, bool direct);
  void flush_groups(const Rgb& scale);

  const LightPathPlan& plan_;
  std::vector<Rgb> colours_;
  std::vector<Record> records_;
  Rgb diffuse_{0, 0, 0};
  LightComponent other_ =
      LightComponent::volume_direct;  ///< Receives the non-diffuse share of direct light; the
                                      ///< indirect component follows it.
};

}  // namespace vug::render
