// SPDX-License-Identifier: Apache-2.0
#include <vug/render/geometry/embree.h>

#include <tbb/task_arena.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Embree's build depends on this number of threads, so it is constant.
constexpr int kBuildThreads = 1;

}  // namespace

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

PreparedScene::Geometry::Embree::~Embree() {
  if (scene) rtcReleaseScene(scene);
  for (const auto& each : shared_bvhs)
    if (each.second.scene) rtcReleaseScene(each.second.scene);
}

RTCScene PreparedScene::Geometry::Embree::new_scene() const {
  RTCScene made = rtcNewScene(device.get());
  rtcSetSceneFlags(made, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(made, RTC_BUILD_QUALITY_MEDIUM);
  return made;
}

void PreparedScene::Geometry::Embree::attach(RTCScene to, RTCGeometry geometry,
                                             size_t number) const {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(to, geometry, static_cast<unsigned>(number));
  rtcReleaseGeometry(geometry);
}

void PreparedScene::Geometry::Embree::commit(RTCScene what) const {
  tbb::task_arena arena(kBuildThreads);
  arena.execute([&] { rtcJoinCommitScene(what); });
  device.check("building the BVH");
}

void PreparedScene::Geometry::Embree::add_mesh(RTCScene to, const mesh::Mesh& mesh,
                                               size_t number) const {
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  // Copied, because Embree reads 16 bytes at the last vertex.
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Vec3f), mesh.positions.size());
  if (vertices)
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3f*>(vertices));
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(mesh::Triangle),
                             mesh.triangles.size());
  if (cutout_meshes.count(&mesh)) {
    rtcSetGeometryIntersectFilterFunction(geometry, cutout_filter);
    rtcSetGeometryOccludedFilterFunction(geometry, cutout_filter);
  }
  attach(to, geometry, number);
  device.check("adding a mesh");
}

void PreparedScene::Geometry::Embree::add_instance(const SharedBvh& shared,
                                                   const InstanceTransform& instance,
                                                   size_t number) const {
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, shared.scene);
  rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(instance.keyframes().size()));
  for (size_t step = 0; step < instance.keyframes().size(); ++step) {
    const Affine& to = instance.keyframes()[step];
    const float columns[] = {to.x.x, to.x.y, to.x.z, to.y.x,      to.y.y,      to.y.z,
                             to.z.x, to.z.y, to.z.z, to.origin.x, to.origin.y, to.origin.z};
    rtcSetGeometryTransform(geometry, static_cast<unsigned>(step), RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                            columns);
  }
  attach(scene, geometry, number);
  device.check("adding an instance");
}

const PreparedScene::Geometry::Embree::SharedBvh& PreparedScene::Geometry::Embree::shared_bvh(
    const Object& object) {
  const void* key = object.mesh.get();
  if (object.surface) key = object.surface.get();
  const auto [at, is_new] = shared_bvhs.try_emplace(key);
  SharedBvh& shared = at->second;
  if (is_new) {
    shared.scene = new_scene();
    if (object.surface) {
      shared.box = box_of(*object.surface);
      add_surface(shared.scene, *object.surface, 0);
    } else {
      shared.corners = corners_of(*object.mesh);
      shared.box = box_of(*object.mesh);
      add_mesh(shared.scene, *object.mesh, 0);
    }
    commit(shared.scene);
  }
  return shared;
}

void PreparedScene::Geometry::Embree::cutout_filter(const RTCFilterFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);  // rays come one at a time
  const bool own = hit.instID[0] == RTC_INVALID_GEOMETRY_ID;
  const auto& context = *static_cast<const RayContext*>(args->context);
  if (context.geometry.passes_through(own ? hit.geomID : hit.instID[0], hit.primID, context))
    args->valid[0] = 0;
}

}  // namespace vug::render
