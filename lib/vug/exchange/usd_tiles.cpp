// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/names.h>
#include <vug/exchange/usd_header.h>
#include <vug/exchange/usd_mesh.h>
#include <vug/exchange/usd_tiles.h>
#include <vug/mesh/file.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/weld.h>

#include <meshoptimizer.h>

namespace vug::exchange {
namespace {

constexpr const char* kFirstLevel = "full";

/// The corners of the boxes for the purposes default, render and proxy, in the order of UsdGeom.
/// There is nothing with the default purpose; UsdGeom writes such a box as the largest float and
/// its negative.
std::string extents_hint(const UsdTile& tile) {
  constexpr const char* kNothing =
      "(3.4028235e38, 3.4028235e38, 3.4028235e38), (-3.4028235e38, -3.4028235e38, -3.4028235e38)";
  const Box3d proxy = mesh::bounds(tile.proxy);
  return fmt::format("[{}, {}, {}, {}, {}]", kNothing, usd_tuple(tile.bounds.min),
                     usd_tuple(tile.bounds.max), usd_tuple(proxy.min), usd_tuple(proxy.max));
}

std::string payload(const UsdTile::Level& level) {
  return fmt::format("prepend payload = @./{}@", level.file);
}

void write_tile_prim(UsdText& out, const UsdTile& tile, const std::string& name) {
  std::vector<std::string> metadata = {"prepend apiSchemas = [\"GeomModelAPI\"]",
                                       "kind = \"component\""};
  const bool has_levels = tile.levels.size() > 1;
  if (has_levels) {
    metadata.push_back(fmt::format("variants = {{ string levelOfDetail = \"{}\" }}", kFirstLevel));
    metadata.emplace_back("prepend variantSets = \"levelOfDetail\"");
  } else {
    metadata.push_back(payload(tile.levels.at(0)));
  }
  out.def("Xform", name, metadata);
  out.line("float3[] extentsHint = {}", extents_hint(tile));
  write_usd_bare_mesh(out, tile.proxy, "proxy", "proxy");
  if (has_levels) {
    out.open("variantSet \"levelOfDetail\" = {");
    for (size_t i = 0; i < tile.levels.size(); ++i) {
      out.line("\"{}\" (", i == 0 ? kFirstLevel : fmt::format("lod{}", i));
      out.line("    {}", payload(tile.levels[i])).open(") {");
      if (i > 0) out.line("custom double vug:distance = {}", tile.levels[i].distance);
      out.end();
    }
    out.end();
  }
  out.end();
}

}  // namespace

mesh::Mesh coarse_hull(const mesh::Mesh& mesh, size_t triangles) {
  mesh::Mesh out;
  if (mesh.triangles.empty()) return out;
  constexpr float kAnyError = 1;  // Relative to the extent: the number of triangles decides.
  out.positions = mesh.positions;
  if (mesh.triangles.size() <= triangles) {
    out.triangles = mesh.triangles;
    return mesh::without_unused_vertices(out);
  }
  out.triangles.resize(mesh.triangles.size());
  const size_t left =
      meshopt_simplifySloppy(out.triangles[0].data(), mesh.triangles[0].data(),
                             3 * mesh.triangles.size(), &mesh.positions[0].x, mesh.positions.size(),
                             sizeof(Vec3f), 3 * triangles, kAnyError, nullptr);
  out.triangles.resize(left / 3);
  return out.triangles.empty() ? mesh::box_mesh(mesh::bounds(mesh))
                               : mesh::without_unused_vertices(out);
}

void write_usd_tile(const mesh::Mesh& mesh, const Provenance& provenance,
                    const std::filesystem::path& file) {
  mesh::write_file(file, [&](const mesh::ByteSink& sink) {
    UsdText out(sink);
    write_usd_header(out, "tile", provenance, {});
    out.def("Xform", "tile");
    write_usd_bare_mesh(out, mesh, "shape", "render");
    out.end().finish();
  });
}

void write_usd_tiles(const std::string& name, const std::vector<UsdTile>& tiles,
                     const Provenance& provenance, const std::filesystem::path& file) {
  mesh::write_file(file, [&](const mesh::ByteSink& sink) {
    UsdText out(sink);
    const std::string root = identifier(name);
    write_usd_header(out, root, provenance, {});
    out.def("Xform", root, {"kind = \"assembly\""});
    UniqueNames names;
    for (const UsdTile& tile : tiles) write_tile_prim(out, tile, names.unique(tile.name));
    out.end().finish();
  });
}

}  // namespace vug::exchange
