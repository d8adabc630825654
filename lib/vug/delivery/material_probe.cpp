// SPDX-License-Identifier: Apache-2.0
#include <vug/delivery/material_probe.h>
#include <vug/mesh/normals.h>
#include <vug/render/geometry/instance_transform.h>

namespace vug::delivery {
namespace {

std::vector<uint32_t> corners_of(const mesh::Mesh& mesh) {
  std::vector<uint32_t> out(mesh.positions.size(), UINT32_MAX);
  for (size_t face = 0; face < mesh.triangles.size(); ++face)
    for (size_t k = 0; k < 3; ++k) {
      uint32_t& known = out[mesh.triangles[face][k]];
      if (known == UINT32_MAX) known = static_cast<uint32_t>(3 * face + k);
    }
  return out;
}

}  // namespace

bool varies_by_instance(const render::Object& object) {
  return object.instance &&
         (object.world_space_material || (object.material && object.material->refers_to_scene()));
}

MaterialProbe::MaterialProbe(const render::Object& object)
    : object_(object),
      mesh_(*object.mesh),
      corners_(corners_of(mesh_)),
      color_(mesh::find_attribute(mesh_, mesh::kColour, 3)) {
  if (mesh_.normals.empty()) normals_ = mesh::vertex_normals(mesh_);
  if (varies_by_instance(object)) instance_ = object.instance.get();
}

render::Surface MaterialProbe::surface(const Vec3f& position, const Vec3f& normal,
                                       const Vec3f& color) const {
  render::Surface surface;
  surface.mesh = &mesh_;
  surface.solid = object_.solid.get();
  surface.position = position;
  surface.shading_normal = normal;
  surface.color = color;
  if (instance_) {
    const render::Affine place = instance_->at(0);
    surface.instance = instance_;
    surface.world_space_material = object_.world_space_material;
    surface.position = place.point(surface.position);
    surface.shading_normal = render::normalized(place.normal(surface.shading_normal));
  }
  surface.geometric_normal = surface.shading_normal;
  return surface;
}

Vec3f MaterialProbe::color_of(size_t vertex) const {
  if (!color_) return render::Rgb(1.0f);
  const float* c = &color_->values[3 * vertex];
  return {c[0], c[1], c[2]};
}

exchange::Look MaterialProbe::at(size_t vertex) const {
  render::Surface surface =
      this->surface(mesh_.positions[vertex], normals()[vertex], color_of(vertex));
  exchange::Look look;
  if (const uint32_t corner = corners_[vertex]; corner != UINT32_MAX) {
    surface.triangle = corner / 3;
    surface.u = corner % 3 == 1 ? 1 : 0;
    surface.v = corner % 3 == 2 ? 1 : 0;
    if (object_.material) look = object_.material->look(surface);
    if (object_.material && object_.material->cut_out())
      look.opacity = static_cast<double>(object_.material->opacity(surface));
    if (object_.material && object_.material->is_emissive())
      look.emission = Vec3d(object_.material->emission(surface));
  }
  if (!object_.material) look.base_color = Vec3d(surface.color) * 0.5;
  look.emission += Vec3d(object_.emission);
  return look;
}

double MaterialProbe::opacity(size_t triangle, float u, float v) const {
  if (!object_.material || !object_.material->cut_out()) return 1;
  const mesh::Triangle& t = mesh_.triangles[triangle];
  const auto between = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    return a * (1 - u - v) + b * u + c * v;
  };
  render::Surface surface =
      this->surface(between(mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]),
                    render::normalized(between(normals()[t[0]], normals()[t[1]], normals()[t[2]])),
                    between(color_of(t[0]), color_of(t[1]), color_of(t[2])));
  surface.triangle = static_cast<uint32_t>(triangle);
  surface.u = u;
  surface.v = v;
  return static_cast<double>(object_.material->opacity(surface));
}

}  // namespace vug::delivery
