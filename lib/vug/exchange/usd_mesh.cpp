// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/channels.h>
#include <vug/exchange/names.h>
#include <vug/exchange/usd_mesh.h>
#include <vug/mesh/rock_weights.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::exchange {
namespace {

constexpr const char* kPerVertex = "vertex";
constexpr const char* kLevels = "levelOfDetail";
constexpr const char* kFull = "full";

bool varies(const Prototype& prototype, const Channel& channel) {
  return mesh::find_attribute(*prototype.mesh, channel.attribute, channel.arity()) != nullptr;
}

std::string primvar(std::string_view attribute) {
  return attribute == mesh::kColour ? "displayColor" : identifier(std::string(attribute));
}

void write_attribute(UsdLayer& out, const mesh::Attribute& attribute) {
  const char* type = attribute.arity == 1       ? "float"
                     : attribute.arity == 2     ? "float2"
                     : attribute.arity == 4     ? "float4"
                     : attribute.arity != 3     ? nullptr
                     : is_color(attribute.name) ? "color3f"
                                                : "vector3f";
  const std::string name = "primvars:" + primvar(attribute.name);
  const float* values = attribute.values.data();
  if (type)
    out.attribute({.type = type, .name = name, .interpolation = kPerVertex},
                  UsdArray{values, attribute.values.size() / static_cast<size_t>(attribute.arity),
                           attribute.arity});
  else
    out.attribute({.type = "float",
                   .name = name,
                   .interpolation = kPerVertex,
                   .element_size = attribute.arity},
                  UsdArray{values, attribute.values.size()});
}

UsdTuple tuple(const Vec3d& v) { return {v.x, v.y, v.z}; }

void write_shape(UsdLayer& out, const mesh::Mesh& mesh) {
  const Box3d box = mesh::bounds(mesh);
  const Vec3d low = box.isEmpty() ? Vec3d(0.0) : box.min, high = box.isEmpty() ? low : box.max;
  out.attribute({"float3", "extent"}, UsdTuples{low, high});
  const std::vector<int32_t> threes(mesh.triangles.size(), 3);
  out.attribute({"int", "faceVertexCounts"}, UsdArray{threes.data(), threes.size()});
  const uint32_t* indices = mesh.triangles.empty() ? nullptr : mesh.triangles[0].data();
  out.attribute({"int", "faceVertexIndices"}, UsdArray{indices, 3 * mesh.triangles.size()});
  const float* points = mesh.positions.empty() ? nullptr : &mesh.positions[0].x;
  out.attribute({"point3f", "points"}, UsdArray{points, mesh.positions.size(), 3});
  if (!mesh.normals.empty())
    out.attribute({.type = "normal3f", .name = "normals", .interpolation = kPerVertex},
                  UsdArray{&mesh.normals[0].x, mesh.normals.size(), 3});
  for (const mesh::Attribute& attribute : mesh.attributes) write_attribute(out, attribute);
}

/// The index of refraction whose reflectance on the whole surface equals that of `ior` on the
/// fraction `share`.
double equivalent_ior(double ior, double share) {
  const double f = std::sqrt(share) * std::fabs((ior - 1) / (ior + 1));
  return (1 + f) / (1 - f);
}

void write_input(UsdLayer& out, const Prototype& prototype, const std::string& path,
                 const Channel& channel, const std::string& input) {
  const UsdAttribute attribute = {channel.color ? "color3f" : "float", "inputs:" + input};
  if (varies(prototype, channel))
    out.connection(attribute,
                   fmt::format("{}/{}.outputs:result", path, primvar(channel.attribute)));
  else if (channel.color)
    out.attribute(attribute, tuple(prototype.look.*channel.color));
  else
    out.attribute(attribute, prototype.look.*channel.number);
}

/// A subset of the triangles for each rock, bound to its material, and one for the triangles
/// without weights. Null: they are not bound.
void write_rock_subsets(UsdLayer& out, const mesh::Mesh& mesh, const UsdMaterials* materials) {
  const std::vector<std::string> names = mesh::rock_materials(mesh);
  if (names.empty()) return;
  const std::vector<int32_t> of_faces = mesh::face_materials(mesh, names);
  out.attribute({"token", "subsetFamily:materialBind:familyType", true}, UsdToken{"partition"});
  for (int32_t m = -1; m < static_cast<int32_t>(names.size()); ++m) {
    std::vector<int32_t> faces;
    for (size_t face = 0; face < of_faces.size(); ++face)
      if (of_faces[face] == m) faces.push_back(static_cast<int32_t>(face));
    if (faces.empty()) continue;
    const std::string name = m < 0 ? "no_rock" : "rock_" + names[static_cast<size_t>(m)];
    UsdPrimMetadata metadata;
    if (materials) metadata.push_back(usd_api_schema("MaterialBindingAPI"));
    out.begin_prim("GeomSubset", name, metadata);
    out.attribute({"token", "elementType", true}, UsdToken{"face"});
    out.attribute({"token", "familyName", true}, UsdToken{"materialBind"});
    out.attribute({"int", "indices"}, UsdArray{faces.data(), faces.size()});
    if (materials)
      out.relationship("material:binding",
                       m < 0 ? materials->whole : materials->of(names[static_cast<size_t>(m)]));
    out.end();
  }
}

void write_topology_kind(UsdLayer& out) {
  out.attribute({"token", "orientation", true}, UsdToken{"rightHanded"});
  out.attribute({"token", "subdivisionScheme", true}, UsdToken{"none"});
}

void write_mesh(UsdLayer& out, const Prototype& prototype, const mesh::Mesh& mesh,
                const std::string& name, const UsdMaterials& materials) {
  out.begin_prim("Mesh", name, {usd_api_schema("MaterialBindingAPI")});
  out.relationship("material:binding", materials.whole);
  write_topology_kind(out);
  if (prototype.look.thin) out.attribute({"bool", "doubleSided", true}, true);
  if (!varies(prototype, channels()[0]))
    out.attribute({.type = "color3f", .name = "primvars:displayColor", .interpolation = "constant"},
                  UsdTuples{prototype.look.base_color});
  write_shape(out, mesh);
  write_rock_subsets(out, mesh, &materials);
  out.end();
}

}  // namespace

std::string usd_mesh_type(const Prototype& prototype) {
  return prototype.coarser.empty() ? "Mesh" : "Xform";
}

void write_usd_mesh(UsdLayer& out, const Prototype& prototype, const std::string& name,
                    const UsdMaterials& materials) {
  if (prototype.coarser.empty())
    return write_mesh(out, prototype, *prototype.mesh, name, materials);
  out.begin_prim(usd_mesh_type(prototype), name,
                 {usd_variant_selection(kLevels, kFull), usd_variant_set(kLevels)});
  out.begin_variant_set(kLevels);
  out.begin_variant(kFull);
  write_mesh(out, prototype, *prototype.mesh, "shape", materials);
  out.end();
  for (size_t i = 0; i < prototype.coarser.size(); ++i) {
    out.begin_variant(fmt::format("lod{}", i + 1));
    out.attribute({.type = "double", .name = "vug:distance", .custom = true},
                  prototype.coarser[i].distance);
    write_mesh(out, prototype, *prototype.coarser[i].mesh, "shape", materials);
    out.end();
  }
  out.end();
  out.end();
}

void write_usd_bare_mesh(UsdLayer& out, const mesh::Mesh& mesh, const std::string& name,
                         const std::string& purpose) {
  out.begin_prim("Mesh", name);
  out.attribute({"token", "purpose", true}, UsdToken{purpose});
  write_topology_kind(out);
  write_shape(out, mesh);
  write_rock_subsets(out, mesh, nullptr);
  out.end();
}

bool same_usd_material(const Prototype& a, const Prototype& b) {
  if (a.material != b.material || !(a.look == b.look) || a.rocks != b.rocks) return false;
  return std::all_of(channels().begin(), channels().end(), [&](const Channel& channel) {
    return varies(a, channel) == varies(b, channel);
  });
}

void write_usd_material(UsdLayer& out, const Prototype& prototype, const std::string& path,
                        const std::string& name) {
  const Look& look = prototype.look;
  out.begin_prim("Material", name);
  out.connection({"token", "outputs:surface"}, path + "/surface.outputs:surface");
  out.begin_prim("Shader", "surface");
  out.attribute({"token", "info:id", true}, UsdToken{"UsdPreviewSurface"});
  bool opacity_varies =
      false;  // Whether opacity varies; it is then not combined with transmission.
  for (const Channel& channel : channels()) {
    if (channel.color == &Look::base_color)
      write_input(out, prototype, path, channel, "diffuseColor");
    if (channel.color == &Look::emission)
      write_input(out, prototype, path, channel, "emissiveColor");
    if (channel.number == &Look::roughness) write_input(out, prototype, path, channel, "roughness");
    if (channel.number == &Look::metallic) write_input(out, prototype, path, channel, "metallic");
    if (channel.number == &Look::wetness) write_input(out, prototype, path, channel, "clearcoat");
    if (channel.number == &Look::opacity && varies(prototype, channel)) {
      write_input(out, prototype, path, channel, "opacity");
      opacity_varies = true;
    }
  }
  out.attribute({"float", "inputs:clearcoatRoughness"}, look.coat_roughness);
  out.attribute({"float", "inputs:ior"}, equivalent_ior(look.ior, look.specular));
  if (!opacity_varies)
    out.attribute({"float", "inputs:opacity"}, (1 - look.transmission) * look.opacity);
  out.attribute({"int", "inputs:useSpecularWorkflow"}, 0);
  out.attribute({"token", "outputs:surface"}, {});
  out.end();
  for (const Channel& channel : channels()) {
    if (!varies(prototype, channel)) continue;
    const std::string reader = primvar(channel.attribute);
    const std::string type = channel.color ? "float3" : "float";
    out.begin_prim("Shader", reader);
    out.attribute({"token", "info:id", true}, UsdToken{"UsdPrimvarReader_" + type});
    out.attribute({"string", "inputs:varname"}, UsdString{reader});
    out.attribute({type, "outputs:result"}, {});
    out.end();
  }
  out.end();
}

}  // namespace vug::exchange
