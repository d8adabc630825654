// Keeps the light of a path apart: by how it came and by which lights. Only for pictures that ask.
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

/// The parts that sum to the beauty: what the camera sees shine by itself, and for everything else
/// what scattered the light last before the camera, and whether the light came to that place
/// straight from its source. Diffuse and specular mean reflection.
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
/// "emission", "diffuse_direct", ...
const std::vector<std::string>& component_names();

/// What a recorder sums: all Parts or none, then a colour for each group of lights. Then what it
/// reads off the first surface, which are no colours but are summed like them: the wetness and
/// attributes of the mesh.
struct LightPathPlan {
  bool components = false;
  size_t groups = 0;
  bool wetness = false;
  std::vector<std::string> attributes;  ///< Their names.
  /// Colours of LightSet::groups(); groups without a colour are not in it.
  std::unordered_map<uint32_t, size_t> group_of;
  bool motion = false;  ///< A last colour, which is no light, holds the motion.

  /// How many come before what is read off surfaces, and all of them.
  size_t lights() const {
    return (components ? static_cast<size_t>(LightComponent::count) : 0) + groups;
  }
  size_t colours() const { return lights() + (wetness ? 1 : 0) + attributes.size(); }
};

/// The light of one path. An integrator notes what each light source gives at a vertex, as it
/// stands before the path's throughput, and then settles all of it with the throughput.
class LightPathRecorder {
 public:
  explicit LightPathRecorder(const LightPathPlan& plan)
      : plan_(plan), colours_(plan.colours() + (plan.motion ? 1 : 0)) {}

  /// Before a path.
  void clear();
  /// At the first surface that a path meets.
  void read_surface(const Surface& surface, const Material& material);
  /// `diffuse`: the part of `light` that was reflected by diffuse lobes; only for light that a
  /// surface at depth 0 reflects. `group` is the light's.
  void record(uint32_t group, const Rgb& light, const Rgb& diffuse = Rgb(0.0f));
  /// The same for light from the sky: it comes from all skies that light the object.
  void record_environment(const PreparedScene& world, uint32_t object, const Vec3f& direction,
                          const Rgb& weight, const Rgb& diffuse_weight = Rgb(0.0f));

  /// Files what was noted: light that the ray meets whose origin is the vertex before `depth`.
  void flush_emission(int depth, const Rgb& scale);
  /// Light that the surface at `depth` reflects, or the medium before it scatters into the ray.
  void flush_surface(int depth, const Rgb& scale);
  void flush_medium(int depth, const Rgb& scale);

  /// What turned the path at depth 0: a medium, or a surface; of that, `diffuse` (for each channel,
  /// 0 to 1) by diffuse lobes unless the light went through it.
  void scattered_in_medium();
  void scattered_at_surface(bool through, const Rgb& weight, const Rgb& diffuse);

  /// LightPathPlan::colours() of them, then the motion.
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
  LightComponent other_ = LightComponent::volume_direct;  ///< Where what is not diffuse goes; the
                                                          ///< indirect part follows.
};

}  // namespace vug::render
