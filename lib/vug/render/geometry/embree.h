// For geometry.cpp and geometry_grid.cpp only: what Embree holds.
#pragma once

#include <vug/raytree/embree_device.h>
#include <vug/render/geometry/geometry.h>
#include <vug/render/geometry/grid_surface.h>

#include <map>
#include <set>

namespace vug::render {

/// What callbacks know of the ray that is on its way: all of it as it started, since Embree turns
/// those of instances into their own space.
struct PreparedScene::Geometry::Search : RTCIntersectContext {
  Search(const Geometry& geometry, const Ray& world_ray, float when)
      : RTCIntersectContext{}, of(geometry), ray(world_ray), time(when) {
    rtcInitIntersectContext(this);
  }
  const Geometry& of;
  const Ray& ray;
  float time;
  Crossing met;  ///< Of the last level set that was met.
};

struct PreparedScene::Geometry::Embree {
  /// The tree of a mesh or a surface that instances share.
  struct Shape {
    RTCScene scene = nullptr;
    std::shared_ptr<const std::vector<Corners>> corners;
    Box3f box;
  };
  raytree::EmbreeDevice device;
  RTCScene scene = nullptr;             ///< Null where all is in Geometry::triangles_.
  std::map<const void*, Shape> shapes;  ///< By mesh or surface.
  std::set<const mesh::Mesh*> cut;      ///< Meshes of objects that rays may pass through.

  ~Embree();
  RTCScene new_scene() const;
  void attach(RTCScene to, RTCGeometry geometry, size_t number) const;
  void add_mesh(RTCScene to, const mesh::Mesh& mesh, size_t number) const;
  /// Embree's question whether a triangle of something cut out is there for the ray.
  static void pass_holes(const RTCFilterFunctionNArguments* args);
  void add_surface(RTCScene to, const volume::SurfaceBricks& surface, size_t number) const;
  void add_instance(const Shape& shape, const InstanceTransform& instance, size_t number) const;
  void build(RTCScene what) const;
  const Shape& shape(const Object& object);
};

}  // namespace vug::render
