#include <vug/base/error.h>
#include <vug/render/geometry.h>
#include <vug/render/kinds.h>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vug::render {
namespace {

/// Embree's build splits its work by this number, not by the threads there are.
constexpr int kBuildSlots = 1;

}  // namespace

Vec3f lifted(const Vec3f& point, const Vec3f& normal, float extent) {
  constexpr float kUnits = 0x1p-19f;  // 16 units in the last place
  return point + normal * (extent * kUnits);
}

struct World::Geometry::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Embree() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
  void check(const char* doing) const {
    const RTCError code = rtcGetDeviceError(device);
    if (code == RTC_ERROR_NONE) return;
    throw Error(code == RTC_ERROR_OUT_OF_MEMORY ? ErrorCode::too_large : ErrorCode::internal,
                fmt::format("{} failed in the ray tracing library (code {})", doing,
                            static_cast<int>(code)));
  }
};

World::Geometry::Geometry(const std::vector<Object>& objects)
    : embree_(std::make_unique<Embree>()) {
  const MaterialPtr grey = make_material("lambert");
  // One instruction set everywhere: wider ones would choose other triangles at exact ties.
  embree_->device = rtcNewDevice("isa=avx2,set_affinity=0,start_threads=0,verbose=0");
  if (!embree_->device)
    throw Error(ErrorCode::internal, "the ray tracing library does not start on this machine");
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(embree_->scene, RTC_BUILD_QUALITY_MEDIUM);
  bounds.makeEmpty();
  for (const Object& object : objects) {
    if (!object.mesh)
      throw Error(ErrorCode::bad_input, fmt::format("object '{}' has no mesh", object.name));
    const mesh::Mesh& mesh = *object.mesh;
    mesh::validate(mesh, fmt::format("object '{}'", object.name));
    if (mesh.triangles.empty()) continue;
    for (const Vec3f& p : mesh.positions) bounds.extendBy(p);
    Part part{object.mesh,
              nullptr,
              nullptr,
              object.material ? object.material : grey,
              static_cast<uint32_t>(&object - objects.data()),
              object.emission,
              object.solid};
    if (!object.flat && !mesh.normals.empty()) part.normals = mesh.normals.data();
    if (const auto* colour = mesh::find_attribute(mesh, mesh::kColour, 3))
      part.colours = colour->values.data();

    RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Copies, because Embree reads 16 bytes at the last vertex.
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Vec3f), mesh.positions.size());
    if (vertices)
      std::memcpy(vertices, mesh.positions.data(), mesh.positions.size() * sizeof(Vec3f));
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.triangles.data(), 0, sizeof(mesh::Triangle),
                               mesh.triangles.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(embree_->scene, geometry, static_cast<unsigned>(parts_.size()));
    rtcReleaseGeometry(geometry);
    part.corners.reserve(mesh.triangles.size());
    for (const mesh::Triangle& t : mesh.triangles)
      part.corners.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    embree_->check("taking in a mesh");
    parts_.push_back(std::move(part));
  }
  tbb::task_arena arena(kBuildSlots);
  arena.execute([&] { rtcJoinCommitScene(embree_->scene); });
  embree_->check("building the tree of triangles");
}

World::Geometry::~Geometry() = default;

bool World::Geometry::intersect(const Ray& ray, Hit& hit) const {
  RTCRayHit query;
  query.ray.org_x = ray.origin.x, query.ray.org_y = ray.origin.y, query.ray.org_z = ray.origin.z;
  query.ray.dir_x = ray.direction.x, query.ray.dir_y = ray.direction.y;
  query.ray.dir_z = ray.direction.z;
  query.ray.tnear = 0, query.ray.tfar = kFar, query.ray.time = 0;
  query.ray.mask = ~0u, query.ray.id = 0, query.ray.flags = 0;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID, query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  fill(parts_[query.hit.geomID], query.hit.primID, ray, hit);
  return true;
}

bool World::Geometry::occluded(const Ray& ray, float distance) const {
  RTCRay query;
  query.org_x = ray.origin.x, query.org_y = ray.origin.y, query.org_z = ray.origin.z;
  query.dir_x = ray.direction.x, query.dir_y = ray.direction.y, query.dir_z = ray.direction.z;
  query.tnear = 0, query.tfar = distance, query.time = 0;
  query.mask = ~0u, query.id = 0, query.flags = 0;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &query);
  return query.tfar < 0;
}

void World::Geometry::fill(const Part& part, uint32_t triangle, const Ray& ray, Hit& hit) const {
  const mesh::Triangle& corner = part.mesh->triangles[triangle];
  const auto& [a, b, c] = part.corners[triangle];
  const Vec3f ab = b - a, ac = c - a, n = cross(ab, ac);

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
  surface.triangle = triangle;
  surface.u = u, surface.v = v;
  surface.solid = part.solid.get();
  Vec3f origin = surface.position;
  if (part.normals) {
    const Vec3f na = part.normals[corner[0]] * side, nb = part.normals[corner[1]] * side,
                nc = part.normals[corner[2]] * side;
    const auto rise = [&](const Vec3f& vertex, const Vec3f& normal) {
      return normal * std::max(0.0f, -dot(surface.position - vertex, normal));
    };
    origin += rise(a, na) * w + rise(b, nb) * u + rise(c, nc) * v;
    const Vec3f smooth = na * w + nb * u + nc * v;
    const float size = length(smooth);
    if (size > 0) surface.shading_normal = smooth * (1 / size);
    surface.face(ray.direction);
  }
  const auto extent = [](const Vec3f& corner_at) {
    return std::max(std::fabs(corner_at.x),
                    std::max(std::fabs(corner_at.y), std::fabs(corner_at.z)));
  };
  const float size = std::max(extent(a), std::max(extent(b), extent(c)));
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
