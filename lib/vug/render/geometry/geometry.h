// SPDX-License-Identifier: Apache-2.0
// Ray intersection with all surfaces of a scene. Only this folder and raytree use Embree.
#pragma once

#include <vug/raytree/wide_bvh.h>
#include <vug/render/geometry/attribute_gradients.h>
#include <vug/render/geometry/grid_surface.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/scene.h>
#include <vug/render/vectors.h>

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace vug::render {

/// All triangles and level sets of a scene. Opaque meshes that are not instances are in one
/// raytree::WideBvh. Embree holds the rest in one scene: level sets, cut-out meshes, and instances;
/// each instanced mesh has a shared BVH. All trees are built deterministically, whatever the number
/// of threads. They only identify the closest primitive; the distance and the position on it are
/// computed here, so that they have the same bits on every machine.
struct PreparedScene::Geometry {
  /// `before`: other geometry, whose trees are shared as far as they hold the same shapes; may be
  /// null. The result does not depend on it.
  explicit Geometry(const std::vector<Object>& objects, const Geometry* before = nullptr);
  ~Geometry();

  using Corners = std::array<Vec3f, 3>;
  /// The closest primitive on a ray.
  struct Intersection {
    bool hit = false;
    bool is_instance = false;
    uint32_t object = 0;
    uint32_t primitive = 0;  ///< Triangle or brick.
    Corners corners;         ///< Corners of the triangle, in its mesh's space.
    Crossing crossing;       ///< Valid for level sets.
  };
  /// The closest primitive before `distance`, up to rounding. `time`: see PreparedScene::at.
  /// Prefetches the data that `fill_hit` will read.
  Intersection intersect(const Ray& ray, float distance, float time) const;
  /// False without a hit.
  bool fill_hit(const Intersection& found, const Ray& ray, float time, Hit& hit) const;
  bool occluded(const Ray& ray, float distance, float time) const;

  Box3f bounds;
  bool moves = false;  ///< True if something changes while the shutter is open.
  TreeCounts trees;

 private:
  class Embree;
  struct RayContext;
  struct TracedObject {
    mesh::MeshPtr mesh;
    /// Corners of each triangle that Embree holds, stored together: a hit waits for one memory
    /// access instead of four in sequence.
    std::shared_ptr<const std::vector<Corners>> corners;
    const Vec3f* normals = nullptr;
    const float* colours = nullptr;
    const AttributeGradients* gradients = nullptr;
    MaterialPtr material;
    uint32_t scene_index = 0;
    Rgb emission{0, 0, 0};
    std::shared_ptr<const field::SampledGrid> solid;
    InstanceTransformPtr instance;
    bool world_space_material = false;
    bool cutout = false;               ///< See Material::cut_out.
    volume::SurfaceBricksPtr surface;  ///< Replaces the mesh; then also:
    paint::Paint color;
    bool flat = false;
  };
  /// Appends an object; false if it is empty.
  bool add(const Object& object, uint32_t number, const Geometry* before);
  /// Finds the closest of Embree's primitives before `distance`.
  void intersect_embree(const Ray& ray, float time, float distance, Intersection& found) const;
  /// True if the ray passes through a cut-out triangle: with the probability 1 - opacity, decided
  /// by a hash of the ray and the triangle.
  bool passes_through(uint32_t object, uint32_t triangle, const RayContext& context) const;
  template <class Space>
  void fill(const TracedObject& traced, uint32_t triangle, const Corners& own, const Space& space,
            const Ray& ray, Hit& hit) const;
  void fill_mesh(const TracedObject& traced, uint32_t triangle, const Corners& corners,
                 const Ray& ray, float time, Hit& hit) const;
  /// Sets the properties of hits on instances.
  static void set_instance(const TracedObject& traced, float time, Hit& hit);
  static void fill_surface(const TracedObject& traced, uint32_t brick, const Crossing& seen,
                           float time, const Ray& ray, Hit& hit);

  std::vector<TracedObject> objects_;  ///< Indexed by Embree's geometry ids in the scene.
  std::map<const mesh::Mesh*, std::shared_ptr<const AttributeGradients>> gradients_;
  std::vector<raytree::WideBvh::Geometry> static_meshes_;
  std::shared_ptr<const raytree::WideBvh> triangles_;  ///< The static meshes.
  std::shared_ptr<const Embree> embree_;               ///< Null if it traces nothing.
  bool uses_embree_ = false;
};

/// Offsets a point of a triangle along the normal. Interpolated points are exact to about 3 units
/// in the last place of the triangle's largest coordinate, `extent`; an offset of 16 such units
/// keeps rays from hitting the triangle they leave. A larger offset would let more rays start
/// beyond the walls of a sharp corner. The idea is that of Waechter and Binder 2019, "A fast and
/// robust method for avoiding self-intersection", Ray Tracing Gems, chapter 6 (cite
/// waechter2019offset), but the offset does not shrink where a coordinate happens to be near 0.
Vec3f offset_point(const Vec3f& point, const Vec3f& normal, float extent);

}  // namespace vug::render
