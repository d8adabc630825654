// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/look.h>
#include <vug/field/enclosed.h>
#include <vug/field/operands.h>
#include <vug/loading/placement/solid.h>
#include <vug/mesh/triangle.h>
#include <vug/mesh/winding_number.h>
#include <vug/shot/cells_plan.h>

#include <algorithm>
#include <cmath>

namespace vug::loading {
namespace {

Interval own_value(const Solid& solid, const Vec3d& own, Accuracy accuracy) {
  return accuracy == Accuracy::exact ? Interval(solid.field.value(own))
                                     : field::bounds_at(solid.field, own);
}

Interval value_at(const Solid& solid, const Vec3d& p, Accuracy accuracy) {
  return own_value(solid, solid.to_own.point(p), accuracy);
}

exchange::Look look_at(const render::Material& material, const Vec3d& p) {
  render::Surface surface;
  surface.position = Vec3f(p);
  surface.geometric_normal = surface.shading_normal = {0, 1, 0};
  return material.look(surface);
}

/// The mesh of a plan without its cells, and the mesh of which a volume was made.
void add_solids(const shot::MeshPlan& plan, const Solid& like, std::vector<Solid>& solids) {
  for (const shot::MeshPtr& part : plan.parts) add_solids(*part, like, solids);
  if (const shot::MeshPtr support = shot::mesh_without_cells(plan))
    return add_solids(*support, like, solids);
  if (plan.volume && plan.volume->source_mesh)
    return add_solids(*plan.volume->source_mesh, like, solids);
  Solid solid = like;
  if (plan.file_mesh) {
    solid.mesh = plan.file_mesh;
  } else if (plan.volume && !plan.volume->fog) {
    const shot::VolumePlan& volume = *plan.volume;
    solid.field =
        volume.from ? field::enclosed(volume.field, Box3d(*volume.from, *volume.to)) : volume.field;
    solid.voxel = volume.voxel;
    solid.slack = 0.5 * volume.voxel;
  } else {
    return;
  }
  solid.box = solid.mesh ? mesh::bounds(*solid.mesh) : solid.field.bounds();
  solids.push_back(std::move(solid));
}

}  // namespace

bool Solid::is_clear(const Vec3d& p) const {
  if (!material) return false;
  return material->cut_out() || material->thin() || look_at(*material, p).transmission > 0;
}

bool Solid::is_translucent(const Vec3d& p) const {
  return is_clear(p) || (material && look_at(*material, p).subsurface > 0);
}

bool Solid::contains(const Vec3d& p, Accuracy accuracy) const {
  if (!box.intersects(p)) return false;
  if (mesh) return mesh::winding_number(*mesh, to_own.point(p)) > 0.5;
  return value_at(*this, p, accuracy).hi < -slack;
}

bool Solid::voxels_contain(const Vec3d& p, Accuracy accuracy) const {
  if (voxel == 0 || value_at(*this, p, accuracy).hi <= 0) return false;
  const Vec3d at = to_own.point(p) / voxel;
  const Vec3d low(std::floor(at.x), std::floor(at.y), std::floor(at.z));
  const Vec3d weight = at - low;
  double interpolated = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d step(corner & 1, corner >> 1 & 1, corner >> 2);
    double share = 1;
    for (int axis = 0; axis < 3; ++axis) share *= step[axis] > 0 ? weight[axis] : 1 - weight[axis];
    interpolated += share * own_value(*this, (low + step) * voxel, accuracy).hi;
  }
  return interpolated < 0;
}

double Solid::depth(const Vec3d& p, Accuracy accuracy) const {
  if (!box.intersects(p)) return 0;
  const double stretch = to_own.max_stretch();
  if (!mesh) {
    const double slope = std::max(field.lipschitz(), 1e-9) * stretch;
    return std::max(0.0, -value_at(*this, p, accuracy).hi) / slope;
  }
  if (!contains(p, accuracy)) return 0;
  if (!distances) distances = std::make_shared<mesh::MeshDistance>(*mesh);
  return distances->closest(to_own.point(p)).distance / stretch;
}

bool Solid::is_farther(const Vec3d& p, double distance, Accuracy accuracy) const {
  const Vec3d own = to_own.point(p);
  const double reach = distance * to_own.max_stretch();
  if (!mesh) return value_at(*this, p, accuracy).hi > reach + slack;
  const Box3d near = grown(Box3d(own), reach);
  for (size_t face = 0; face < mesh->triangles.size(); ++face) {
    const auto corners = mesh::corners(*mesh, face);
    Box3d around(corners[0]);
    around.extendBy(corners[1]);
    around.extendBy(corners[2]);
    if (around.intersects(near) &&
        (mesh::nearest_on_triangle(own, corners).point - own).length() <= reach)
      return false;
  }
  return true;
}

std::vector<Solid> solids_of(const shot::ObjectPlan& object) {
  Solid like;
  like.name = object.name;
  like.material = object.material;
  like.shines =
      object.emission.length2() > 0 || (object.material && object.material->is_emissive());
  std::vector<Solid> solids;
  add_solids(*object.mesh, like, solids);
  return solids;
}

Solid moved(Solid solid, const Transform& by) {
  solid.to_scene = by * solid.to_scene;
  solid.to_own = solid.to_scene.inverse();
  solid.box = by.box(solid.box);
  solid.slack *= by.max_stretch();
  return solid;
}

}  // namespace vug::loading
