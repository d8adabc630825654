// SPDX-License-Identifier: Apache-2.0
// Embree's part of the geometry: only for geometry.cpp, geometry_grid.cpp and embree.cpp.
#pragma once

#include <vug/raytree/embree_device.h>
#include <vug/render/geometry/geometry.h>
#include <vug/render/geometry/grid_surface.h>

#include <map>
#include <memory>
#include <type_traits>
#include <vector>

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

class PreparedScene::Geometry::Embree {
 public:
  /// An object of the scene that Embree traces: a cut-out mesh, a level set or an instance of one.
  struct Item {
    mesh::MeshPtr mesh;
    volume::SurfaceBricksPtr surface;  ///< Replaces the mesh.
    bool filtered = false;  ///< The mesh is that of an object that rays may pass through.
    InstanceTransformPtr instance;
    uint32_t id = 0;  ///< Index in Geometry::objects_.

    const void* shape() const {
      return surface ? static_cast<const void*>(surface.get()) : mesh.get();
    }
    /// Whether Embree traces the same: the same shape at the same places.
    bool operator==(const Item& other) const;
  };

  /// `before`: shapes that it has a BVH of share it; may be null. Adds to `counts`.
  Embree(std::vector<Item> items, const Embree* before, TreeCounts& counts);

  RTCScene scene() const { return scene_.get(); }
  const std::vector<Item>& items() const { return items_; }
  /// The number of trees: that of the scene, and those that instances share.
  size_t tree_count() const { return 1 + shared_.size(); }
  /// The corners of the triangles of the item's mesh; null for a level set.
  std::shared_ptr<const std::vector<Corners>> corners(const Item& item) const;
  Box3f box(const Item& item) const;

 private:
  using ScenePtr = std::shared_ptr<std::remove_pointer_t<RTCScene>>;
  /// A BVH of a mesh or a level set, shared by its instances.
  struct SharedBvh {
    ScenePtr scene;
    bool filtered = false;
    std::shared_ptr<const std::vector<Corners>> corners;
    Box3f box;
  };
  ScenePtr new_scene() const;
  void attach(RTCScene to, RTCGeometry geometry, size_t number) const;
  void add_shape(RTCScene to, const Item& item, size_t number) const;
  void add_mesh(RTCScene to, const Item& item, size_t number) const;
  void add_surface(RTCScene to, const volume::SurfaceBricks& surface, size_t number) const;
  void add_instance(const SharedBvh& shared, const Item& item) const;
  void commit(RTCScene what) const;
  const SharedBvh& shared_bvh(const Item& item, const Embree* before, TreeCounts& counts);
  /// Embree's filter callback: rejects hits where a cut-out triangle is transparent for the ray.
  static void cutout_filter(const RTCFilterFunctionNArguments* args);

  std::shared_ptr<const raytree::EmbreeDevice> device_;
  std::vector<Item> items_;  ///< Embree refers to their meshes and level sets.
  ScenePtr scene_;
  std::map<const void*, SharedBvh> shared_;  ///< By shape.
  std::map<const void*, std::shared_ptr<const std::vector<Corners>>>
      corners_;  ///< For meshes that are not instances.
};

}  // namespace vug::render
