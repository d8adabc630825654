// SPDX-License-Identifier: Apache-2.0
// Conversion of assemblies to another up axis and unit, and the bounds of an assembly.
#include <vug/base/parallel.h>
#include <vug/exchange/assembly.h>
#include <vug/exchange/channels.h>

#include <algorithm>
#include <map>

namespace vug::exchange {
namespace {

/// The rotation between the up axes.
Transform turn(UpAxis from, UpAxis to) {
  if (from == to) return {};
  if (to == UpAxis::z) return {Vec3d(1, 0, 0), Vec3d(0, 0, 1), Vec3d(0, -1, 0), Vec3d(0.0)};
  return {Vec3d(1, 0, 0), Vec3d(0, 0, -1), Vec3d(0, 1, 0), Vec3d(0.0)};
}

/// Converts meshes; shared meshes remain shared.
class Meshes {
 public:
  Meshes(const Transform& way, const Transform& turn) : way_(way), turn_(turn) {}

  mesh::MeshPtr operator()(const mesh::MeshPtr& mesh) {
    mesh::MeshPtr& made = made_[mesh];
    if (!made) made = std::make_shared<const mesh::Mesh>(turned(*mesh));
    return made;
  }

 private:
  mesh::Mesh turned(mesh::Mesh mesh) const {
    const auto each = [](size_t count, const auto& body) { parallel_for(count, body, 4096); };
    each(mesh.positions.size(),
         [&](size_t i) { mesh.positions[i] = Vec3f(way_.point(Vec3d(mesh.positions[i]))); });
    const auto vector = [&](const Vec3f& v) { return Vec3f(turn_.vector(Vec3d(v))); };
    each(mesh.normals.size(), [&](size_t i) { mesh.normals[i] = vector(mesh.normals[i]); });
    for (mesh::Attribute& attribute : mesh.attributes) {
      if (attribute.arity != 3 || is_color(attribute.name)) continue;
      each(attribute.values.size() / 3, [&](size_t i) {
        float* at = attribute.values.data() + 3 * i;
        const Vec3f v = vector({at[0], at[1], at[2]});
        at[0] = v.x, at[1] = v.y, at[2] = v.z;
      });
    }
    return mesh;
  }

  Transform way_, turn_;
  std::map<mesh::MeshPtr, mesh::MeshPtr> made_;
};

}  // namespace

std::string to_string(UpAxis up) { return up == UpAxis::y ? "y" : "z"; }

Transform space_transform(const Space& from, const Space& to) {
  const double scale = from.metres_per_unit / to.metres_per_unit;
  return Transform::scaling(Vec3d(scale)) * turn(from.up, to.up);
}

Box3d bounds(const Assembly& assembly) {
  Box3d all;
  for (const InstanceGroup& group : assembly.groups) {
    const mesh::Mesh& mesh = *assembly.prototypes.at(group.prototype).mesh;
    for (const Transform& place : group.places)
      for (const Vec3f& p : mesh.positions) all.extendBy(place.point(Vec3d(p)));
  }
  return all;
}

Assembly converted(const Assembly& assembly, const Space& to) {
  if (assembly.space == to) return assembly;
  Assembly out = assembly;
  out.space = to;
  const Transform there = space_transform(assembly.space, to), back = there.inverse();
  const Transform turned = turn(assembly.space.up, to.up);
  const double scale = assembly.space.metres_per_unit / to.metres_per_unit;
  Meshes meshes(there, turned);
  for (Prototype& prototype : out.prototypes) {
    prototype.mesh = meshes(prototype.mesh);
    for (Level& level : prototype.coarser) {
      level.mesh = meshes(level.mesh);
      level.distance *= scale;
    }
  }
  for (InstanceGroup& group : out.groups)
    for (Transform& place : group.places) place = there * place * back;
  for (Volume& volume : out.volumes) {
    volume.bounds = there.box(volume.bounds);
    if (!volume.medium) continue;
    volume.medium->extinction /= scale;
    // A flame emits per unit length; without a flame the extinction scales instead.
    if (std::any_of(volume.grids.begin(), volume.grids.end(),
                    [](const VolumeGrid& grid) { return grid.name == "flame"; }))
      volume.medium->emission /= scale, volume.medium->heat /= scale;
  }
  // Object spaces preserve lengths: measures are converted as numbers.
  const auto moved = [&](const Transform& place) {
    const Vec3d origin = there.point(place.origin());
    const Transform axes = turned * place;
    return Transform(axes.column(0), axes.column(1), axes.column(2), origin);
  };
  for (Camera& camera : out.cameras) {
    camera.place = moved(camera.place);
    for (double* length :
         {&camera.span, &camera.aperture, &camera.focus, &camera.near, &camera.far})
      *length *= scale;
  }
  for (Light& light : out.lights) {
    light.place = moved(light.place);
    for (double* length : {&light.radius, &light.width, &light.height}) *length *= scale;
  }
  return out;
}

}  // namespace vug::exchange
