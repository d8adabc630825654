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

/// All triangles and level sets of a scene. Solid meshes that stand in the scene itself make a
/// raytree::WideBvh. All else is Embree's: level sets and meshes with holes make a second tree, and
/// each mesh of instances has one of its own, whose places stand in that. Trees are built by a
/// fixed plan, so that they are the same for any number of threads; they only tell which triangle
/// is nearest, and distance and place on it are computed here, so that they have the same bits on
/// every machine.
struct PreparedScene::Geometry {
  explicit Geometry(const std::vector<Object>& objects);
  ~Geometry();

  using Corners = std::array<Vec3f, 3>;
  /// The nearest surface on a ray.
  struct Found {
    bool any = false;
    bool placed = false;  ///< By an instance.
    uint32_t part = 0;
    uint32_t primitive = 0;  ///< Triangle or brick.
    Corners corners;         ///< Of the triangle, in its mesh's space.
    Crossing met;            ///< Of a level set.
  };
  /// `time`: see PreparedScene::at. Calls for what `fill` will read.
  Found find(const Ray& ray, float time) const;
  /// False when nothing was found.
  bool fill(const Found& found, const Ray& ray, float time, Hit& hit) const;
  bool occluded(const Ray& ray, float distance, float time) const;

  Box3f bounds;
  bool moves = false;  ///< Something is elsewhere at another time.

 private:
  struct Embree;
  struct Search;
  struct Part {
    mesh::MeshPtr mesh;
    /// Of each triangle that Embree has, side by side: a hit waits for one place in memory, not for
    /// four in turn.
    std::shared_ptr<const std::vector<Corners>> corners;
    const Vec3f* normals = nullptr;
    const float* colours = nullptr;
    const AttributeGradients* gradients = nullptr;
    MaterialPtr material;
    uint32_t object = 0;
    Rgb emission{0, 0, 0};
    std::shared_ptr<const field::SampledGrid> solid;
    InstanceTransformPtr instance;
    bool world_space_material = false;
    bool cut = false;                  ///< See Material::cut_out.
    volume::SurfaceBricksPtr surface;  ///< In place of the mesh; then also:
    paint::Paint color;
    bool flat = false;
  };
  /// Appends meshes for the raytree::WideBvh to `static_meshes`.
  void add(const Object& object, uint32_t number,
           std::vector<raytree::WideBvh::Geometry>& static_meshes);
  /// What Embree finds before that distance.
  void find_before(const Ray& ray, float time, float distance, Found& found) const;
  /// Whether the ray goes on through a triangle that has holes: by its opacity there, with a chance
  /// that hangs on the ray and the triangle only.
  bool passes(uint32_t part, uint32_t triangle, const Search& search) const;
  template <class Space>
  void fill(const Part& part, uint32_t triangle, const Corners& own, const Space& space,
            const Ray& ray, Hit& hit) const;
  void fill_mesh(const Part& part, uint32_t triangle, const Corners& corners, const Ray& ray,
                 float time, Hit& hit) const;
  /// What the hit of an instance knows besides.
  static void set_place(const Part& part, float time, Hit& hit);
  static void fill_surface(const Part& part, uint32_t brick, const Crossing& seen, float time,
                           const Ray& ray, Hit& hit);

  std::vector<Part> parts_;  ///< By Embree's numbers of what stands in the scene.
  std::map<const mesh::Mesh*, std::unique_ptr<const AttributeGradients>> gradients_;
  raytree::WideBvh triangles_;
  std::unique_ptr<Embree> embree_;
  bool rest_ = false;  ///< Embree holds something.
};

/// A point of a triangle moved off it along the normal. Interpolated points are exact to about 3
/// units in the last place of the triangle's largest coordinate, `extent`; 16 of them keep rays
/// from meeting the triangle they leave. More would let more rays start beyond the walls of a
/// sharp corner. The idea is that of Waechter and Binder 2019, "A fast and robust method for
/// avoiding self-intersection", Ray Tracing Gems, chapter 6 (cite waechter2019offset), but the
/// step does not shrink where a coordinate happens to be near 0.
Vec3f lifted(const Vec3f& point, const Vec3f& normal, float extent);

}  // namespace vug::render
