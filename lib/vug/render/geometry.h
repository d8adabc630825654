// The only file pair that speaks to Embree.
#pragma once

#include <vug/render/scene.h>
#include <vug/render/vectors.h>
#include <vug/render/world.h>

#include <memory>
#include <vector>

namespace vug::render {

/// All triangles of a scene. The tree is built by a fixed plan, so that it is the same for any
/// number of threads; Embree only tells which triangle is nearest, and distance and place on it
/// are computed here, so that they have the same bits on every machine.
struct World::Geometry {
  explicit Geometry(const std::vector<Object>& objects);
  ~Geometry();

  bool intersect(const Ray& ray, Hit& hit) const;
  bool occluded(const Ray& ray, float distance) const;

  Box3f bounds;

 private:
  struct Embree;
  struct Part {
    mesh::MeshPtr mesh;
    const Vec3f* normals = nullptr;
    const float* colours = nullptr;
    BsdfPtr material;
  };
  void fill(const Part& part, uint32_t triangle, const Ray& ray, Hit& hit) const;

  std::vector<Part> parts_;
  std::unique_ptr<Embree> embree_;
};

/// A point moved off the surface by a few units in the last place of its coordinates:
/// Waechter and Binder 2019, "A fast and robust method for avoiding self-intersection", Ray
/// Tracing Gems, chapter 6 (cite waechter2019offset).
Vec3f lifted(const Vec3f& point, const Vec3f& normal);

}  // namespace vug::render
