// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/channels.h>
#include <vug/exchange/names.h>
#include <vug/exchange/usd_mesh.h>
#include <vug/mesh/rock_weights.h>

#include <algorithm>
#include <cmath>

namespace vug::exchange {
namespace {

constexpr const char* kPerVertex = " (interpolation = \"vertex\")";
constexpr const char* kFull = "full";

bool varies(const Prototype& prototype, const Channel& channel) {
  return mesh::find_attribute(*prototype.mesh, channel.attribute, channel.arity()) != nullptr;
}

std::string primvar(std::string_view attribute) {
  return attribute == mesh::kColour ? "displayColor" : identifier(std::string(attribute));
}

void write_attribute(UsdText& out, const mesh::Attribute& attribute) {
  const char* type = attribute.arity == 1       ? "float"
                     : attribute.arity == 2     ? "float2"
                     : attribute.arity == 4     ? "float4"
                     : attribute.arity != 3     ? nullptr
                     : is_color(attribute.name) ? "color3f"
                                                : "vector3f";
  const std::string name = "primvars:" + primvar(attribute.name);
  if (type)
    out.array(type, name, attribute.values.data(),
              attribute.values.size() / static_cast<size_t>(attribute.arity), attribute.arity,
              kPerVertex);
  else
    out.array("float", name, attribute.values.data(), attribute.values.size(), 1,
              fmt::format(" (elementSize = {} interpolation = \"vertex\")", attribute.arity));
}

void write_shape(UsdText& out, const mesh::Mesh& mesh) {
  const Box3d box = mesh::bounds(mesh);
  const Vec3d low = box.isEmpty() ? Vec3d(0.0) : box.min, high = box.isEmpty() ? low : box.max;
  out.line("float3[] extent = [{}, {}]", usd_tuple(low), usd_tuple(high));
  const std::vector<int> threes(mesh.triangles.size(), 3);
  out.array("int", "faceVertexCounts", threes.data(), threes.size(), 1);
  out.array("int", "faceVertexIndices", mesh.triangles.empty() ? nullptr : mesh.triangles[0].data(),
            3 * mesh.triangles.size(), 1);
  const auto* points = mesh.positions.empty() ? nullptr : &mesh.positions[0].x;
  out.array("point3f", "points", points, mesh.positions.size(), 3);
  if (!mesh.normals.empty())
    out.array("normal3f", "normals", &mesh.normals[0].x, mesh.normals.size(), 3, kPerVertex);
  for (const mesh::Attribute& attribute : mesh.attributes) write_attribute(out, attribute);
}

/// The index of refraction whose reflectance on the whole surface equals that of `ior` on the
/// fraction `share`.
double equivalent_ior(double ior, double share) {
  const double f = std::sqrt(share) * std::fabs((ior - 1) / (ior + 1));
  return (1 + f) / (1 - f);
}

void write_input(UsdText& out, const Prototype& prototype, const std::string& path,
                 const Channel& channel, const std::string& input) {
  const char* type = channel.color ? "color3f" : "float";
  if (varies(prototype, channel))
    out.line("{} inputs:{}.connect = <{}/{}.outputs:result>", type, input, path,
             primvar(channel.attribute));
  else if (channel.color)
    out.line("{} inputs:{} = {}", type, input, usd_tuple(prototype.look.*channel.color));
  else
    out.line("{} inputs:{} = {}", type, input, prototype.look.*channel.number);
}

/// A subset of the triangles for each rock, bound to its material, and one for the triangles
/// without weights. Null: they are not bound.
void write_rock_subsets(UsdText& out, const mesh::Mesh& mesh, const UsdMaterials* materials) {
  const std::vector<std::string> names = mesh::rock_materials(mesh);
  if (names.empty()) return;
  const std::vector<int32_t> of_faces = mesh::face_materials(mesh, names);
  out.line("uniform token subsetFamily:materialBind:familyType = \"partition\"");
  for (int32_t m = -1; m < static_cast<int32_t>(names.size()); ++m) {
    std::vector<int32_t> faces;
    for (size_t face = 0; face < of_faces.size(); ++face)
      if (of_faces[face] == m) faces.push_back(static_cast<int32_t>(face));
    if (faces.empty()) continue;
    const std::string name = m < 0 ? "no_rock" : "rock_" + names[static_cast<size_t>(m)];
    if (materials)
      out.def("GeomSubset", name, {"prepend apiSchemas = [\"MaterialBindingAPI\"]"});
    else
      out.def("GeomSubset", name);
    out.line("uniform token elementType = \"face\"");
    out.line("uniform token familyName = \"materialBind\"");
    out.array("int", "indices", faces.data(), faces.size(), 1);
    if (materials)
      out.line("rel material:binding = <{}>",
               m < 0 ? materials->whole : materials->of(names[static_cast<size_t>(m)]));
    out.end();
  }
}

void write_mesh(UsdText& out, const Prototype& prototype, const mesh::Mesh& mesh,
                const std::string& name, const UsdMaterials& materials) {
  out.def("Mesh", name, {"prepend apiSchemas = [\"MaterialBindingAPI\"]"});
  out.line("rel material:binding = <{}>", materials.whole);
  out.line("uniform token orientation = \"rightHanded\"");
  out.line("uniform token subdivisionScheme = \"none\"");
  if (prototype.look.thin) out.line("uniform bool doubleSided = true");
  if (!varies(prototype, channels()[0]))
    out.line("color3f[] primvars:displayColor = [{}] (interpolation = \"constant\")",
             usd_tuple(prototype.look.base_color));
  write_shape(out, mesh);
  write_rock_subsets(out, mesh, &materials);
  out.end();
}

}  // namespace

std::string usd_mesh_type(const Prototype& prototype) {
  return prototype.coarser.empty() ? "Mesh" : "Xform";
}

void write_usd_mesh(UsdText& out, const Prototype& prototype, const std::string& name,
                    const UsdMaterials& materials) {
  if (prototype.coarser.empty())
    return write_mesh(out, prototype, *prototype.mesh, name, materials);
  out.def(usd_mesh_type(prototype), name,
          {fmt::format("variants = {{ string levelOfDetail = \"{}\" }}", kFull),
           "prepend variantSets = \"levelOfDetail\""});
  out.open("variantSet \"levelOfDetail\" = {");
  out.open(fmt::format("\"{}\" {{", kFull));
  write_mesh(out, prototype, *prototype.mesh, "shape", materials);
  out.end();
  for (size_t i = 0; i < prototype.coarser.size(); ++i) {
    out.open(fmt::format("\"lod{}\" {{", i + 1));
    out.line("custom double vug:distance = {}", prototype.coarser[i].distance);
    write_mesh(out, prototype, *prototype.coarser[i].mesh, "shape", materials);
    out.end();
  }
  out.end().end();
}

void write_usd_bare_mesh(UsdText& out, const mesh::Mesh& mesh, const std::string& name,
                         const std::string& purpose) {
  out.def("Mesh", name);
  out.line("uniform token purpose = \"{}\"", purpose);
  out.line("uniform token orientation = \"rightHanded\"");
  out.line("uniform token subdivisionScheme = \"none\"");
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

void write_usd_material(UsdText& out, const Prototype& prototype, const std::string& path,
                        const std::string& name) {
  const Look& look = prototype.look;
  out.def("Material", name);
  out.line("token outputs:surface.connect = <{}/surface.outputs:surface>", path);
  out.def("Shader", "surface");
  out.line("uniform token info:id = \"UsdPreviewSurface\"");
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
  out.line("float inputs:clearcoatRoughness = {}", look.coat_roughness);
  out.line("float inputs:ior = {}", equivalent_ior(look.ior, look.specular));
  if (!opacity_varies)
    out.line("float inputs:opacity = {}", (1 - look.transmission) * look.opacity);
  out.line("int inputs:useSpecularWorkflow = 0");
  out.line("token outputs:surface");
  out.end();
  for (const Channel& channel : channels()) {
    if (!varies(prototype, channel)) continue;
    const std::string reader = primvar(channel.attribute);
    out.def("Shader", reader);
    out.line("uniform token info:id = \"UsdPrimvarReader_float{}\"", channel.color ? "3" : "");
    out.line("string inputs:varname = \"{}\"", reader);
    out.line("{} outputs:result", channel.color ? "float3" : "float");
    out.end();
  }
  out.end();
}

}  // namespace vug::exchange
