// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/flat_mesh.h>
#include <vug/mesh/format.h>
#include <vug/mesh/normals.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::exchange {
namespace {

mesh::Attribute& attribute_of(mesh::Mesh& all, const mesh::Attribute& like) {
  for (mesh::Attribute& each : all.attributes)
    if (each.name == like.name && each.arity == like.arity) return each;
  return all.attributes.emplace_back(mesh::Attribute{like.name, like.arity, {}});
}

void append(const Prototype& prototype, const Transform& place, mesh::Mesh& all) {
  const mesh::Mesh mesh = transformed(*prototype.mesh, place);
  const auto first = static_cast<uint32_t>(all.positions.size());
  all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
  const std::vector<Vec3f>& normals =
      mesh.normals.empty() ? mesh::vertex_normals(mesh) : mesh.normals;
  all.normals.insert(all.normals.end(), normals.begin(), normals.end());
  for (const mesh::Triangle& t : mesh.triangles)
    all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  for (const mesh::Attribute& own : mesh.attributes) {
    mesh::Attribute& there = attribute_of(all, own);
    there.values.resize(first * static_cast<size_t>(own.arity));
    there.values.insert(there.values.end(), own.values.begin(), own.values.end());
  }
  mesh::Attribute& color = attribute_of(all, {std::string(mesh::kColour), 3, {}});
  for (size_t i = color.values.size() / 3; i < all.positions.size(); ++i)
    for (int c = 0; c < 3; ++c)
      color.values.push_back(static_cast<float>(prototype.look.base_color[c]));
}

std::string unit_of(double metres) {
  if (metres == 1) return "metres";
  return metres == 0.01 ? "centimetres" : fmt::format("units of {} m", metres);
}

}  // namespace

mesh::Mesh transformed(mesh::Mesh mesh, const Transform& place) {
  for (Vec3f& p : mesh.positions) p = Vec3f(place.point(Vec3d(p)));
  for (Vec3f& n : mesh.normals) n = Vec3f(place.normal(Vec3d(n)).normalized());
  if (place.determinant() < 0)
    for (mesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

mesh::Comments comments_of(const Provenance& from, const Space& space) {
  mesh::Comments notes;
  notes.space = fmt::format("{}, {} up", unit_of(space.metres_per_unit), to_string(space.up));
  notes.texts = {{"vug:recipe", from.recipe},
                 {"vug:seed", std::to_string(from.seed)},
                 {"vug:frame", fmt::format("{}", from.frame)},
                 {"vug:version", from.version}};
  return notes;
}

mesh::Mesh flat_mesh(const Assembly& assembly) {
  mesh::Mesh all;
  for (const InstanceGroup& group : assembly.groups)
    for (const Transform& place : group.places)
      append(assembly.prototypes.at(group.prototype), place, all);
  for (mesh::Attribute& each : all.attributes)
    each.values.resize(all.positions.size() * static_cast<size_t>(each.arity));
  return all;
}

WriteReport write_flat_mesh(const Assembly& assembly, const std::filesystem::path& file,
                            const FormatOptions&, Progress& progress) {
  progress.check();
  mesh::write_mesh(flat_mesh(assembly), file, comments_of(assembly.provenance, assembly.space));
  WriteReport written{{file}, {}};
  const auto report_unsupported = [&](const auto& things, const char* what) {
    for (const auto& each : things)
      written.unsupported.push_back(
          fmt::format("the {} '{}': the file contains only a mesh", what, each.name));
  };
  report_unsupported(assembly.cameras, "camera");
  report_unsupported(assembly.lights, "light");
  return written;
}

std::vector<std::pair<std::string, std::string>> read_flat_metadata(std::string_view bytes,
                                                                    const std::string&) {
  return mesh::read_comments(bytes);
}

}  // namespace vug::exchange
