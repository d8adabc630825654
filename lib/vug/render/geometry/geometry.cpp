// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/raytree/path_scheduler.h>
#include <vug/render/geometry/embree.h>
#include <vug/render/kinds.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

namespace vug::render {
namespace {

float extent_of(const Vec3f& point) {
  return std::max(std::fabs(point.x), std::max(std::fabs(point.y), std::fabs(point.z)));
}

/// The space of a mesh that is not an instance.
struct WorldSpace {
  static const Vec3f& point(const Vec3f& p) { return p; }
  static const Vec3f& normal(const Vec3f& n) { return n; }
  static float orientation() { return 1; }
  static float extent(float size) { return size; }
};

/// The space of an instance, at the time of a ray.
struct InstanceSpace {
  const InstanceTransform& instance;
  Affine to;

  InstanceSpace(const InstanceTransform& p, float time) : instance(p), to(p.at(time)) {}
  Vec3f point(const Vec3f& p) const { return to.point(p); }
  Vec3f normal(const Vec3f& n) const { return normalized(to.normal(n)); }
  /// -1 for mirroring transforms, which reverse the orientation of triangles.
  float orientation() const { return to.determinant() < 0 ? -1.0f : 1.0f; }
  float extent(float size) const {
    return (size + instance.origin_extent()) * instance.error_scale();
  }
};

}  // namespace

Vec3f offset_point(const Vec3f& point, const Vec3f& normal, float extent) {
  constexpr float kUnits = 0x1p-19f;  // 16 units in the last place
  return point + normal * (extent * kUnits);
}

namespace {

using StaticMeshes = std::vector<raytree::WideBvh::Geometry>;

bool have_same_triangles(const StaticMeshes& a, const StaticMeshes& b) {
  const auto same = [](const auto& one, const auto& other) {
    return one.id == other.id &&
           (one.mesh == other.mesh || (one.mesh->positions == other.mesh->positions &&
                                       one.mesh->triangles == other.mesh->triangles));
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace

PreparedScene::Geometry::Geometry(const std::vector<Object>& objects, const Geometry* before) {
  std::set<const mesh::Mesh*> cutout_meshes;
  for (const Object& object : objects)
    if (object.material && object.material->cut_out()) cutout_meshes.insert(object.mesh.get());
  std::vector<Embree::Item> items;
  for (const Object& object : objects) {
    const auto id = static_cast<uint32_t>(objects_.size());
    if (!add(object, static_cast<uint32_t>(&object - objects.data()), before)) continue;
    const bool filtered = object.mesh && cutout_meshes.count(object.mesh.get());
    if (!object.instance && !object.surface && !filtered)
      static_meshes_.push_back({object.mesh, id});
    else
      items.push_back({object.mesh, object.surface, filtered, object.instance, id});
  }
  bounds.makeEmpty();
  for (const auto& each : static_meshes_) bounds.extendBy(box_of(*each.mesh));
  const bool same = before && have_same_triangles(before->static_meshes_, static_meshes_);
  triangles_ = same ? before->triangles_ : std::make_shared<const raytree::WideBvh>(static_meshes_);
  if (!static_meshes_.empty()) ++(same ? trees.reused : trees.built);
  uses_embree_ = !items.empty();
  if (!uses_embree_) return;
  if (before && before->uses_embree_ && before->embree_->items() == items) {
    embree_ = before->embree_;
    trees.reused += embree_->tree_count();
  } else {
    embree_ = std::make_shared<const Embree>(std::move(items),
                                             before ? before->embree_.get() : nullptr, trees);
  }
  for (const Embree::Item& item : embree_->items()) {
    objects_[item.id].corners = embree_->corners(item);
    bounds.extendBy(embree_->box(item));
  }
}

bool PreparedScene::Geometry::add(const Object& object, uint32_t number, const Geometry* before) {
  if (!object.mesh && !object.surface)
    throw Error(ErrorCode::bad_input, fmt::format("object '{}' has no mesh", object.name));
  TracedObject traced;
  traced.material = object.material ? object.material : make_material("lambert");
  traced.scene_index = number;
  traced.emission = object.emission;
  traced.solid = object.solid;
  traced.instance = object.instance;
  traced.world_space_material = object.world_space_material;
  traced.cutout = traced.material->cut_out();
  if (traced.cutout && object.surface)
    throw Error(ErrorCode::bad_input,
                fmt::format("object '{}' is cut out by its material's opacity, but has no mesh "
                            "to cut",
                            object.name),
                {}, "leave out 'direct'");
  if (object.surface) {
    if (object.surface->bricks().empty()) return false;
    traced.surface = object.surface;
    traced.color = object.color;
    traced.flat = object.flat;
  } else {
    const mesh::Mesh& mesh = *object.mesh;
    if (mesh.triangles.empty()) {  // without an entry in `gradients_`, as nothing keeps the mesh
      mesh::validate(mesh, fmt::format("object '{}'", object.name));
      return false;
    }
    auto& gradients = gradients_[&mesh];
    if (!gradients && before)  // a mesh that was valid
      if (const auto known = before->gradients_.find(&mesh); known != before->gradients_.end())
        gradients = known->second;
    if (!gradients) {
      mesh::validate(mesh, fmt::format("object '{}'", object.name));
      gradients = std::make_shared<const AttributeGradients>(mesh);
    }
    traced.mesh = object.mesh;
    if (!object.flat && !mesh.normals.empty()) traced.normals = mesh.normals.data();
    if (const auto* colour = mesh::find_attribute(mesh, mesh::kColour, 3))
      traced.colours = colour->values.data();
    traced.gradients = gradients.get();
  }
  moves = moves || (object.instance && object.instance->moves());
  objects_.push_back(std::move(traced));
  return true;
}

PreparedScene::Geometry::~Geometry() = default;

PreparedScene::Geometry::Intersection PreparedScene::Geometry::intersect(const Ray& ray,
                                                                         float distance,
                                                                         float time) const {
  Intersection found;
  raytree::BvhTraversal traversal(*triangles_, ray, distance,
                                  raytree::BvhTraversal::Query::closest);
  finish(traversal);
  if (traversal.hit())
    found = {true, false, traversal.geometry(), traversal.triangle(), traversal.corners(), {}};
  if (uses_embree_) intersect_embree(ray, time, traversal.distance(), found);
  if (found.hit && !objects_[found.object].surface) {
    const TracedObject& traced = objects_[found.object];
    if (traced.normals || traced.colours)
      __builtin_prefetch(&traced.mesh->triangles[found.primitive]);
  }
  return found;
}

void PreparedScene::Geometry::intersect_embree(const Ray& ray, float time, float distance,
                                               Intersection& found) const {
  RTCRayHit query{};
  query.ray.org_x = ray.origin.x, query.ray.org_y = ray.origin.y, query.ray.org_z = ray.origin.z;
  query.ray.dir_x = ray.direction.x, query.ray.dir_y = ray.direction.y;
  query.ray.dir_z = ray.direction.z;
  query.ray.tnear = 0, query.ray.tfar = distance, query.ray.time = time;
  query.ray.mask = ~0u, query.ray.id = 0, query.ray.flags = 0;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID, query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RayContext context(*this, ray, time);
  rtcIntersect1(embree_->scene(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
  const bool placed = query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
  const uint32_t number = placed ? query.hit.instID[0] : query.hit.geomID;
  found.hit = true, found.is_instance = placed;
  found.object = number, found.primitive = query.hit.primID;
  found.crossing = context.crossing;
  if (!objects_[number].surface) found.corners = (*objects_[number].corners)[query.hit.primID];
}

bool PreparedScene::Geometry::fill_hit(const Intersection& found, const Ray& ray, float time,
                                       Hit& hit) const {
  if (!found.hit) return false;
  const TracedObject& traced = objects_[found.object];
  if (traced.surface)
    fill_surface(traced, found.primitive, found.crossing, time, ray, hit);
  else
    fill_mesh(traced, found.primitive, found.corners, ray, time, hit);
  if (found.is_instance) set_instance(traced, time, hit);
  return true;
}

bool PreparedScene::Geometry::occluded(const Ray& ray, float distance, float time) const {
  raytree::BvhTraversal traversal(*triangles_, ray, distance, raytree::BvhTraversal::Query::any);
  finish(traversal);
  if (traversal.hit() || !uses_embree_) return traversal.hit();
  RTCRay query{};
  query.org_x = ray.origin.x, query.org_y = ray.origin.y, query.org_z = ray.origin.z;
  query.dir_x = ray.direction.x, query.dir_y = ray.direction.y, query.dir_z = ray.direction.z;
  query.tnear = 0, query.tfar = distance, query.time = time;
  query.mask = ~0u, query.id = 0, query.flags = 0;
  RayContext context(*this, ray, time);
  rtcOccluded1(embree_->scene(), &context, &query);
  return query.tfar < 0;
}

void PreparedScene::Geometry::fill_mesh(const TracedObject& traced, uint32_t triangle,
                                        const Corners& corners, const Ray& ray, float time,
                                        Hit& hit) const {
  if (traced.instance)
    fill(traced, triangle, corners, InstanceSpace(*traced.instance, time), ray, hit);
  else
    fill(traced, triangle, corners, WorldSpace(), ray, hit);
}

void PreparedScene::Geometry::set_instance(const TracedObject& traced, float time, Hit& hit) {
  hit.surface.instance = traced.instance.get();
  hit.surface.world_space_material = traced.world_space_material;
  hit.surface.time = time;
}

bool PreparedScene::Geometry::passes_through(uint32_t number, uint32_t triangle,
                                             const RayContext& context) const {
  const TracedObject& traced = objects_[number];
  if (!traced.cutout) return false;
  Hit hit;
  fill_mesh(traced, triangle, (*traced.corners)[triangle], context.ray, context.time, hit);
  if (traced.instance) set_instance(traced, context.time, hit);
  const float opacity = traced.material->opacity(hit.surface);
  if (opacity <= 0 || opacity >= 1) return opacity <= 0;
  const auto bits = [](float x) { return uint64_t{std::bit_cast<uint32_t>(x)}; };
  const Vec3f &o = context.ray.origin, &d = context.ray.direction;
  const RandomKey key = RandomKey(bits(o.x) << 32 | bits(o.y))
                            .at(bits(o.z) << 32 | bits(d.x))
                            .at(bits(d.y) << 32 | bits(d.z))
                            .at(uint64_t{number} << 32 | triangle);
  return static_cast<float>(RandomStream(key).bits() >> 8) * 0x1p-24f >= opacity;
}

template <class Space>
void PreparedScene::Geometry::fill(const TracedObject& traced, uint32_t triangle,
                                   const Corners& own, const Space& space, const Ray& ray,
                                   Hit& hit) const {
  const mesh::Triangle& corner = traced.mesh->triangles[triangle];
  const Vec3f a = space.point(own[0]), b = space.point(own[1]), c = space.point(own[2]);
  const Vec3f ab = b - a, ac = c - a, n = cross(ab, ac) * space.orientation();

  // Moeller and Trumbore 1997; barycentric weights are clamped to the triangle, since Embree may
  // have found it at its edge.
  const Vec3f p = cross(ray.direction, ac), s = ray.origin - a, q = cross(s, ab);
  const float determinant = dot(p, ab);
  const float inverse = determinant != 0 ? 1 / determinant : 0;
  float u = std::clamp(dot(p, s) * inverse, 0.0f, 1.0f);
  float v = std::clamp(dot(q, ray.direction) * inverse, 0.0f, 1.0f);
  if (u + v > 1) {
    const float scale = 1 / (u + v);
    u *= scale, v *= scale;
  }
  const float w = std::max(0.0f, 1 - u - v);

  Surface& surface = hit.surface;
  surface.position = a + ab * u + ac * v;
  hit.distance = dot(surface.position - ray.origin, ray.direction);
  hit.material = traced.material.get();
  hit.object = traced.scene_index;
  hit.triangle = triangle;
  const float area = length(n);
  const float side = dot(n, ray.direction) > 0 ? -1.0f : 1.0f;
  hit.emission = side > 0 ? traced.emission : Rgb(0.0f);
  surface.geometric_normal = area > 0 ? n * (side / area) : -ray.direction;
  surface.shading_normal = surface.geometric_normal;
  surface.inside = side < 0;
  surface.mesh = traced.mesh.get();
  surface.gradients = traced.gradients;
  surface.triangle = triangle;
  surface.u = u, surface.v = v;
  surface.solid = traced.solid.get();
  Vec3f origin = surface.position;
  if (traced.normals) {
    // On features as thin as a voxel, and in broken files, normals may point through their
    // triangle: rays would start behind it and see the other side.
    const auto normal_at = [&](uint32_t vertex) {
      const Vec3f normal = space.normal(traced.normals[vertex]) * side;
      return dot(normal, surface.geometric_normal) > 0 ? normal : surface.geometric_normal;
    };
    const Vec3f na = normal_at(corner[0]), nb = normal_at(corner[1]), nc = normal_at(corner[2]);
    const auto rise = [&](const Vec3f& vertex, const Vec3f& normal) {
      return normal * std::max(0.0f, -dot(surface.position - vertex, normal));
    };
    origin += rise(a, na) * w + rise(b, nb) * u + rise(c, nc) * v;
    const Vec3f smooth = na * w + nb * u + nc * v;
    const float size = length(smooth);
    if (size > 0) surface.shading_normal = smooth * (1 / size);
    surface.face(ray.direction);
  }
  const float size = space.extent(std::max(extent_of(a), std::max(extent_of(b), extent_of(c))));
  hit.origin = offset_point(origin, surface.geometric_normal, size);
  hit.behind = offset_point(surface.position, -surface.geometric_normal, size);
  surface.color = Rgb(1.0f);
  if (traced.colours) {
    const auto colour = [&](uint32_t vertex) {
      const float* values = traced.colours + 3 * static_cast<size_t>(vertex);
      return Rgb(values[0], values[1], values[2]);
    };
    surface.color = colour(corner[0]) * w + colour(corner[1]) * u + colour(corner[2]) * v;
  }
}

}  // namespace vug::render
