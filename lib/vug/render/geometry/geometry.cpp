#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/raytree/path_scheduler.h>
#include <vug/render/geometry/embree.h>
#include <vug/render/kinds.h>

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace vug::render {
namespace {

/// Embree's build splits its work by this number, not by the threads there are.
constexpr int kBuildSlots = 1;

std::shared_ptr<std::vector<std::array<Vec3f, 3>>> corners_of(const mesh::Mesh& mesh) {
  auto corners = std::make_shared<std::vector<std::array<Vec3f, 3>>>();
  corners->reserve(mesh.triangles.size());
  for (const mesh::Triangle& t : mesh.triangles)
    corners->push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
  return corners;
}

Box3f box_of(const mesh::Mesh& mesh) {
  Box3f box;
  for (const Vec3f& p : mesh.positions) box.extendBy(p);
  return box;
}

Box3f box_of(const volume::SurfaceBricks& surface) {
  const Box3d box = surface.bounds();
  return {Vec3f(box.min), Vec3f(box.max)};
}

float extent_of(const Vec3f& point) {
  return std::max(std::fabs(point.x), std::max(std::fabs(point.y), std::fabs(point.z)));
}

/// The space of a mesh that stands in the scene itself.
struct OwnSpace {
  static const Vec3f& point(const Vec3f& p) { return p; }
  static const Vec3f& normal(const Vec3f& n) { return n; }
  static float turn() { return 1; }
  static float extent(float size) { return size; }
};

/// The space of an instance, at the time of a ray.
struct PlacedSpace {
  const InstanceTransform& instance;
  Affine to;

  PlacedSpace(const InstanceTransform& p, float time) : instance(p), to(p.at(time)) {}
  Vec3f point(const Vec3f& p) const { return to.point(p); }
  Vec3f normal(const Vec3f& n) const { return normalized(to.normal(n)); }
  /// Mirrors turn the way round a triangle over.
  float turn() const { return to.determinant() < 0 ? -1.0f : 1.0f; }
  float extent(float size) const { return (size + instance.origin_extent()) * instance.error_scale(); }
};

}  // namespace

Vec3f lifted(const Vec3f& point, const Vec3f& normal, float extent) {
  constexpr float kUnits = 0x1p-19f;  // 16 units in the last place
  return point + normal * (extent * kUnits);
}

PreparedScene::Geometry::Embree::~Embree() {
  if (scene) rtcReleaseScene(scene);
  for (const auto& each : shapes)
    if (each.second.scene) rtcReleaseScene(each.second.scene);
}

RTCScene PreparedScene::Geometry::Embree::new_scene() const {
  RTCScene made = rtcNewScene(device.get());
  rtcSetSceneFlags(made, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(made, RTC_BUILD_QUALITY_MEDIUM);
  return made;
}

void PreparedScene::Geometry::Embree::attach(RTCScene to, RTCGeometry geometry, size_t number) const {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(to, geometry, static_cast<unsigned>(number));
  rtcReleaseGeometry(geometry);
}

void PreparedScene::Geometry::Embree::build(RTCScene what) const {
  tbb::task_arena arena(kBuildSlots);
  arena.execute([&] { rtcJoinCommitScene(what); });
  device.check("building the tree of triangles");
}

void PreparedScene::Geometry::Embree::add_mesh(RTCScene to, const mesh::Mesh& mesh, size_t number) const {
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  // Copies, because Embree reads 16 bytes at the last vertex.
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Vec3f), mesh.positions.size());
  if (vertices)
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3f*>(vertices));
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(mesh::Triangle),
                             mesh.triangles.size());
  if (cut.count(&mesh)) {
    rtcSetGeometryIntersectFilterFunction(geometry, pass_holes);
    rtcSetGeometryOccludedFilterFunction(geometry, pass_holes);
  }
  attach(to, geometry, number);
  device.check("taking in a mesh");
}

void PreparedScene::Geometry::Embree::add_instance(const Shape& shape, const InstanceTransform& instance,
                                           size_t number) const {
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, shape.scene);
  rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(instance.keyframes().size()));
  for (size_t step = 0; step < instance.keyframes().size(); ++step) {
    const Affine& to = instance.keyframes()[step];
    const float columns[] = {to.x.x, to.x.y, to.x.z, to.y.x,      to.y.y,      to.y.z,
                             to.z.x, to.z.y, to.z.z, to.origin.x, to.origin.y, to.origin.z};
    rtcSetGeometryTransform(geometry, static_cast<unsigned>(step), RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                            columns);
  }
  attach(scene, geometry, number);
  device.check("instance an instance");
}

const PreparedScene::Geometry::Embree::Shape& PreparedScene::Geometry::Embree::shape(const Object& object) {
  const void* key = object.mesh.get();
  if (object.surface) key = object.surface.get();
  const auto [at, is_new] = shapes.try_emplace(key);
  Shape& shape = at->second;
  if (is_new) {
    shape.scene = new_scene();
    if (object.surface) {
      shape.box = box_of(*object.surface);
      add_surface(shape.scene, *object.surface, 0);
    } else {
      shape.corners = corners_of(*object.mesh);
      shape.box = box_of(*object.mesh);
      add_mesh(shape.scene, *object.mesh, 0);
    }
    build(shape.scene);
  }
  return shape;
}

PreparedScene::Geometry::Geometry(const std::vector<Object>& objects)
    : embree_(std::make_unique<Embree>()) {
  embree_->scene = embree_->new_scene();
  bounds.makeEmpty();
  for (const Object& object : objects)
    if (object.material && object.material->cut_out()) embree_->cut.insert(object.mesh.get());
  std::vector<raytree::WideBvh::Geometry> static_meshes;
  for (const Object& object : objects)
    add(object, static_cast<uint32_t>(&object - objects.data()), static_meshes);
  triangles_ = raytree::WideBvh(static_meshes);
  const bool all = static_meshes.size() == parts_.size();
  if (!all) embree_->build(embree_->scene);
  rest_ = !all;
}

void PreparedScene::Geometry::add(const Object& object, uint32_t number,
                          std::vector<raytree::WideBvh::Geometry>& static_meshes) {
  if (!object.mesh && !object.surface)
    throw Error(ErrorCode::bad_input, fmt::format("object '{}' has no mesh", object.name));
  Part part;
  part.material = object.material ? object.material : make_material("lambert");
  part.object = number;
  part.emission = object.emission;
  part.solid = object.solid;
  part.instance = object.instance;
  part.world_space_material = object.world_space_material;
  part.cut = part.material->cut_out();
  if (part.cut && object.surface)
    throw Error(ErrorCode::bad_input,
                fmt::format("object '{}' has holes by its material's opacity, but no mesh to cut "
                            "them in",
                            object.name),
                {}, "leave out 'direct'");
  if (object.surface) {
    if (object.surface->bricks().empty()) return;
    part.surface = object.surface;
    part.color = object.color;
    part.flat = object.flat;
  } else {
    const mesh::Mesh& mesh = *object.mesh;
    if (!embree_->shapes.count(&mesh))
      mesh::validate(mesh, fmt::format("object '{}'", object.name));
    if (mesh.triangles.empty()) return;
    part.mesh = object.mesh;
    if (!object.flat && !mesh.normals.empty()) part.normals = mesh.normals.data();
    if (const auto* colour = mesh::find_attribute(mesh, mesh::kColour, 3))
      part.colours = colour->values.data();
    auto& gradients = gradients_[&mesh];
    if (!gradients) gradients = std::make_unique<const AttributeGradients>(mesh);
    part.gradients = gradients.get();
  }
  if (object.instance) {
    const Embree::Shape& shape = embree_->shape(object);
    part.corners = shape.corners;
    moves = moves || object.instance->moves();
    embree_->add_instance(shape, *object.instance, parts_.size());
    for (const Affine& to : object.instance->keyframes()) bounds.extendBy(to.box(shape.box));
  } else if (object.surface) {
    embree_->add_surface(embree_->scene, *object.surface, parts_.size());
    bounds.extendBy(box_of(*object.surface));
  } else {
    bounds.extendBy(box_of(*object.mesh));
    if (embree_->cut.count(object.mesh.get())) {
      part.corners = corners_of(*object.mesh);
      embree_->add_mesh(embree_->scene, *object.mesh, parts_.size());
    } else {
      static_meshes.push_back({object.mesh, static_cast<uint32_t>(parts_.size())});
    }
  }
  parts_.push_back(std::move(part));
}

PreparedScene::Geometry::~Geometry() = default;

PreparedScene::Geometry::Found PreparedScene::Geometry::find(const Ray& ray, float time) const {
  Found found;
  raytree::BvhTraversal traversal(triangles_, ray, kFar, raytree::BvhTraversal::Query::closest);
  finish(traversal);
  if (traversal.hit())
    found = {true, false, traversal.geometry(), traversal.triangle(), traversal.corners(), {}};
  if (rest_) find_before(ray, time, traversal.distance(), found);
  if (found.any && !parts_[found.part].surface) {
    const Part& part = parts_[found.part];
    if (part.normals || part.colours) __builtin_prefetch(&part.mesh->triangles[found.primitive]);
  }
  return found;
}

void PreparedScene::Geometry::find_before(const Ray& ray, float time, float distance, Found& found) const {
  RTCRayHit query{};
  query.ray.org_x = ray.origin.x, query.ray.org_y = ray.origin.y, query.ray.org_z = ray.origin.z;
  query.ray.dir_x = ray.direction.x, query.ray.dir_y = ray.direction.y;
  query.ray.dir_z = ray.direction.z;
  query.ray.tnear = 0, query.ray.tfar = distance, query.ray.time = time;
  query.ray.mask = ~0u, query.ray.id = 0, query.ray.flags = 0;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID, query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  Search search(*this, ray, time);
  rtcIntersect1(embree_->scene, &search, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
  const bool placed = query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
  const uint32_t number = placed ? query.hit.instID[0] : query.hit.geomID;
  found.any = true, found.placed = placed;
  found.part = number, found.primitive = query.hit.primID;
  found.met = search.met;
  if (!parts_[number].surface) found.corners = (*parts_[number].corners)[query.hit.primID];
}

bool PreparedScene::Geometry::fill(const Found& found, const Ray& ray, float time, Hit& hit) const {
  if (!found.any) return false;
  const Part& part = parts_[found.part];
  if (part.surface)
    fill_surface(part, found.primitive, found.met, time, ray, hit);
  else
    fill_mesh(part, found.primitive, found.corners, ray, time, hit);
  if (found.placed) set_place(part, time, hit);
  return true;
}

bool PreparedScene::Geometry::occluded(const Ray& ray, float distance, float time) const {
  raytree::BvhTraversal traversal(triangles_, ray, distance, raytree::BvhTraversal::Query::any);
  finish(traversal);
  if (traversal.hit() || !rest_) return traversal.hit();
  RTCRay query{};
  query.org_x = ray.origin.x, query.org_y = ray.origin.y, query.org_z = ray.origin.z;
  query.dir_x = ray.direction.x, query.dir_y = ray.direction.y, query.dir_z = ray.direction.z;
  query.tnear = 0, query.tfar = distance, query.time = time;
  query.mask = ~0u, query.id = 0, query.flags = 0;
  Search search(*this, ray, time);
  rtcOccluded1(embree_->scene, &search, &query);
  return query.tfar < 0;
}

void PreparedScene::Geometry::fill_mesh(const Part& part, uint32_t triangle, const Corners& corners,
                                const Ray& ray, float time, Hit& hit) const {
  if (part.instance)
    fill(part, triangle, corners, PlacedSpace(*part.instance, time), ray, hit);
  else
    fill(part, triangle, corners, OwnSpace(), ray, hit);
}

void PreparedScene::Geometry::set_place(const Part& part, float time, Hit& hit) {
  hit.surface.instance = part.instance.get();
  hit.surface.world_space_material = part.world_space_material;
  hit.surface.time = time;
}

bool PreparedScene::Geometry::passes(uint32_t number, uint32_t triangle, const Search& search) const {
  const Part& part = parts_[number];
  if (!part.cut) return false;
  Hit hit;
  fill_mesh(part, triangle, (*part.corners)[triangle], search.ray, search.time, hit);
  if (part.instance) set_place(part, search.time, hit);
  const float opacity = part.material->opacity(hit.surface);
  if (opacity <= 0 || opacity >= 1) return opacity <= 0;
  const auto bits = [](float x) { return uint64_t{std::bit_cast<uint32_t>(x)}; };
  const Vec3f &o = search.ray.origin, &d = search.ray.direction;
  const RandomKey key = RandomKey(bits(o.x) << 32 | bits(o.y))
                            .at(bits(o.z) << 32 | bits(d.x))
                            .at(bits(d.y) << 32 | bits(d.z))
                            .at(uint64_t{number} << 32 | triangle);
  return static_cast<float>(RandomStream(key).bits() >> 8) * 0x1p-24f >= opacity;
}

void PreparedScene::Geometry::Embree::pass_holes(const RTCFilterFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);  // rays come one at a time
  const bool own = hit.instID[0] == RTC_INVALID_GEOMETRY_ID;
  const auto& search = *static_cast<const Search*>(args->context);
  if (search.of.passes(own ? hit.geomID : hit.instID[0], hit.primID, search)) args->valid[0] = 0;
}

template <class Space>
void PreparedScene::Geometry::fill(const Part& part, uint32_t triangle, const Corners& own,
                           const Space& space, const Ray& ray, Hit& hit) const {
  const mesh::Triangle& corner = part.mesh->triangles[triangle];
  const Vec3f a = space.point(own[0]), b = space.point(own[1]), c = space.point(own[2]);
  const Vec3f ab = b - a, ac = c - a, n = cross(ab, ac) * space.turn();

  // Moeller and Trumbore 1997; barycentric weights are clamped onto the triangle, since Embree
  // may have found it by its edge.
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
  hit.material = part.material.get();
  hit.object = part.object;
  hit.triangle = triangle;
  const float area = length(n);
  const float side = dot(n, ray.direction) > 0 ? -1.0f : 1.0f;
  hit.emission = side > 0 ? part.emission : Rgb(0.0f);
  surface.geometric_normal = area > 0 ? n * (side / area) : -ray.direction;
  surface.shading_normal = surface.geometric_normal;
  surface.inside = side < 0;
  surface.mesh = part.mesh.get();
  surface.gradients = part.gradients;
  surface.triangle = triangle;
  surface.u = u, surface.v = v;
  surface.solid = part.solid.get();
  Vec3f origin = surface.position;
  if (part.normals) {
    // On fins as thin as a voxel, and in broken files, normals may point through their triangle:
    // rays would leave from behind it, and see what lies outside.
    const auto normal_at = [&](uint32_t vertex) {
      const Vec3f normal = space.normal(part.normals[vertex]) * side;
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
  hit.origin = lifted(origin, surface.geometric_normal, size);
  hit.behind = lifted(surface.position, -surface.geometric_normal, size);
  surface.color = Rgb(1.0f);
  if (part.colours) {
    const auto colour = [&](uint32_t vertex) {
      const float* values = part.colours + 3 * static_cast<size_t>(vertex);
      return Rgb(values[0], values[1], values[2]);
    };
    surface.color = colour(corner[0]) * w + colour(corner[1]) * u + colour(corner[2]) * v;
  }
}

}  // namespace vug::render
