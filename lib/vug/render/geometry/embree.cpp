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

bool PreparedScene::Geometry::Embree::Item::operator==(const Item& other) const {
  return mesh == other.mesh && surface == other.surface && filtered == other.filtered &&
         id == other.id && are_equal(instance, other.instance);
}

PreparedScene::Geometry::Embree::Embree(std::vector<Item> items, const Embree* before,
                                        TreeCounts& counts)
    : device_(before ? before->device_ : std::make_shared<const raytree::EmbreeDevice>()),
      items_(std::move(items)),
      scene_(new_scene()) {
  for (const Item& item : items_) {
    if (item.instance)
      add_instance(shared_bvh(item, before, counts), item);
    else
      add_shape(scene_.get(), item, item.id);
    if (!item.instance && item.mesh && !corners_.count(item.shape()))
      corners_[item.shape()] = corners_of(*item.mesh);
  }
  commit(scene_.get());
  ++counts.built;
}

std::shared_ptr<const std::vector<PreparedScene::Geometry::Corners>>
PreparedScene::Geometry::Embree::corners(const Item& item) const {
  if (item.instance) return shared_.at(item.shape()).corners;
  const auto found = corners_.find(item.shape());
  return found == corners_.end() ? nullptr : found->second;
}

Box3f PreparedScene::Geometry::Embree::box(const Item& item) const {
  if (!item.instance) return item.surface ? box_of(*item.surface) : box_of(*item.mesh);
  Box3f box;
  for (const Affine& to : item.instance->keyframes())
    box.extendBy(to.box(shared_.at(item.shape()).box));
  return box;
}

PreparedScene::Geometry::Embree::ScenePtr PreparedScene::Geometry::Embree::new_scene() const {
  ScenePtr made(rtcNewScene(device_->get()), rtcReleaseScene);
  rtcSetSceneFlags(made.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(made.get(), RTC_BUILD_QUALITY_MEDIUM);
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
  device_->check("building the BVH");
}

void PreparedScene::Geometry::Embree::add_shape(RTCScene to, const Item& item,
                                                size_t number) const {
  if (item.surface)
    add_surface(to, *item.surface, number);
  else
    add_mesh(to, item, number);
}

void PreparedScene::Geometry::Embree::add_mesh(RTCScene to, const Item& item, size_t number) const {
  const mesh::Mesh& mesh = *item.mesh;
  RTCGeometry geometry = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  // Copied, because Embree reads 16 bytes at the last vertex.
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Vec3f), mesh.positions.size());
  if (vertices)
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3f*>(vertices));
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(mesh::Triangle),
                             mesh.triangles.size());
  if (item.filtered) {
    rtcSetGeometryIntersectFilterFunction(geometry, cutout_filter);
    rtcSetGeometryOccludedFilterFunction(geometry, cutout_filter);
  }
  attach(to, geometry, number);
  device_->check("adding a mesh");
}

void PreparedScene::Geometry::Embree::add_instance(const SharedBvh& shared,
                                                   const Item& item) const {
  const InstanceTransform& instance = *item.instance;
  RTCGeometry geometry = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, shared.scene.get());
  rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(instance.keyframes().size()));
  for (size_t step = 0; step < instance.keyframes().size(); ++step) {
    const Affine& to = instance.keyframes()[step];
    const float columns[] = {to.x.x, to.x.y, to.x.z, to.y.x,      to.y.y,      to.y.z,
                             to.z.x, to.z.y, to.z.z, to.origin.x, to.origin.y, to.origin.z};
    rtcSetGeometryTransform(geometry, static_cast<unsigned>(step), RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                            columns);
  }
  attach(scene_.get(), geometry, item.id);
  device_->check("adding an instance");
}

const PreparedScene::Geometry::Embree::SharedBvh& PreparedScene::Geometry::Embree::shared_bvh(
    const Item& item, const Embree* before, TreeCounts& counts) {
  const auto [at, is_new] = shared_.try_emplace(item.shape());
  SharedBvh& shared = at->second;
  if (!is_new) return shared;
  if (before)
    if (const auto known = before->shared_.find(item.shape());
        known != before->shared_.end() && known->second.filtered == item.filtered) {
      shared = known->second;
      ++counts.reused;
      return shared;
    }
  shared.scene = new_scene();
  shared.filtered = item.filtered;
  if (item.mesh && !item.surface) shared.corners = corners_of(*item.mesh);
  shared.box = item.surface ? box_of(*item.surface) : box_of(*item.mesh);
  add_shape(shared.scene.get(), item, 0);
  commit(shared.scene.get());
  ++counts.built;
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
