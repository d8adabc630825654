// SPDX-License-Identifier: Apache-2.0
// Embree's part of the geometry: only for geometry.cpp, geometry_grid.cpp and embree.cpp.
#pragma once

#include <vug/raytree/embree_device.h>
#include <vug/render/geometry/geometry.h>
#include <vug/render/geometry/grid_surface.h>

#include <map>
#include <set>

namespace vug::render {

/// Data of the current ray for Embree's callbacks: the ray in world space, since Embree transforms
/// rays into the space of an instance.
struct PreparedScene::Geometry::RayContext : RTCIntersectContext {
  RayContext(const Geometry& scene_geometry, const Ray& world_ray, float when)
      : RTCIntersectContext{}, geometry(scene_geometry), ray(world_ray), time(when) {
    rtcInitIntersectContext(this);
  }
  const Geometry& geometry;
  const Ray& ray;
  float time;
  Crossing crossing;  ///< The last crossing with a level set.
};

std::shared_ptr<std::vector<std::array<Vec3f, 3>>> corners_of(const mesh::Mesh& mesh);
Box3f box_of(const mesh::Mesh& mesh);
Box3f box_of(const volume::SurfaceBricks& surface);

struct PreparedScene::Geometry::Embree {
  /// The BVH of a mesh or a level set, shared by instances.
  struct SharedBvh {
    RTCScene scene = nullptr;
    std::shared_ptr<const std::vector<Corners>> corners;
    Box3f box;
  };
  raytree::EmbreeDevice device;
  RTCScene scene = nullptr;  ///< Null if all geometry is in Geometry::triangles_.
  std::map<const void*, SharedBvh> shared_bvhs;  ///< By mesh or surface.
  std::set<const mesh::Mesh*> cutout_meshes;     ///< Meshes of objects that rays may pass through.

  ~Embree();
  RTCScene new_scene() const;
  void attach(RTCScene to, RTCGeometry geometry, size_t number) const;
  void add_mesh(RTCScene to, const mesh::Mesh& mesh, size_t number) const;
  /// Embree's filter callback: rejects hits where a cut-out triangle is transparent for the ray.
  static void cutout_filter(const RTCFilterFunctionNArguments* args);
  void add_surface(RTCScene to, const volume::SurfaceBricks& surface, size_t number) const;
  void add_instance(const SharedBvh& shared, const InstanceTransform& instance,
                    size_t number) const;
  void commit(RTCScene what) const;
  const SharedBvh& shared_bvh(const Object& object);
};

}  // namespace vug::render
