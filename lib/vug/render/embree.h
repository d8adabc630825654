// For geometry.cpp and geometry_grid.cpp only: what Embree holds.
#pragma once

#include <vug/render/geometry.h>
#include <vug/render/grid_surface.h>

#include <embree3/rtcore.h>

#include <map>

namespace vug::render {

/// A search for the nearest hit; with it what the last level set that was met knows of its.
struct World::Geometry::Search : RTCIntersectContext {
  Crossing met;
};

struct World::Geometry::Embree {
  /// The tree of a mesh or a surface that instances share.
  struct Shape {
    RTCScene scene = nullptr;
    std::shared_ptr<const Corners> corners;
    Box3f box;
  };
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::map<const void*, Shape> shapes;  ///< By mesh or surface.

  ~Embree();
  void check(const char* doing) const;
  RTCScene new_scene() const;
  void attach(RTCScene to, RTCGeometry geometry, size_t number) const;
  void add_mesh(RTCScene to, const mesh::Mesh& mesh, size_t number) const;
  void add_surface(RTCScene to, const volume::SurfaceBricks& surface, size_t number) const;
  void add_instance(const Shape& shape, const Placing& placing, size_t number) const;
  void build(RTCScene what) const;
  const Shape& shape(const Object& object);
};

}  // namespace vug::render
