// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/names.h>
#include <vug/exchange/usd_file.h>
#include <vug/exchange/usd_mesh.h>
#include <vug/exchange/usd_tiles.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/weld.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

namespace vug::exchange {
namespace {

constexpr const char* kSet = "levelOfDetail";
constexpr const char* kFirstLevel = "full";

/// The corners of the boxes for the purposes default, render and proxy, in the order of UsdGeom.
/// There is nothing with the default purpose.
UsdTuples extents_hint(const UsdTile& tile) {
  const Box3d proxy = mesh::bounds(tile.proxy);
  return {Vec3d(kUsdEmptyExtent),
          Vec3d(-kUsdEmptyExtent),
          tile.bounds.min,
          tile.bounds.max,
          proxy.min,
          proxy.max};
}

UsdPrimMetadatum payload(const UsdTile::Level& level) { return usd_payload("./" + level.file); }

void write_tile_prim(UsdLayer& out, const UsdTile& tile, const std::string& name) {
  UsdPrimMetadata metadata = {usd_api_schema("GeomModelAPI"), usd_kind("component")};
  const bool has_levels = tile.levels.size() > 1;
  if (has_levels) {
    metadata.push_back(usd_variant_selection(kSet, kFirstLevel));
    metadata.push_back(usd_variant_set(kSet));
  } else {
    metadata.push_back(payload(tile.levels.at(0)));
  }
  out.begin_prim("Xform", name, metadata);
  out.attribute({"float3", "extentsHint"}, extents_hint(tile));
  write_usd_bare_mesh(out, tile.proxy, "proxy", "proxy");
  if (has_levels) {
    out.begin_variant_set(kSet);
    for (size_t i = 0; i < tile.levels.size(); ++i) {
      out.begin_variant(i == 0 ? kFirstLevel : fmt::format("lod{}", i), {payload(tile.levels[i])});
      if (i > 0)
        out.attribute({.type = "double", .name = "vug:distance", .custom = true},
                      tile.levels[i].distance);
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
  write_usd_file(file, [&](UsdLayer& out) {
    out.header({"tile", provenance, {}});
    out.begin_prim("Xform", "tile");
    write_usd_bare_mesh(out, mesh, "shape", "render");
    out.end();
  });
}

void write_usd_tiles(const std::string& name, const std::vector<UsdTile>& tiles,
                     const Provenance& provenance, const std::filesystem::path& file) {
  write_usd_file(file, [&](UsdLayer& out) {
    const std::string root = identifier(name);
    out.header({root, provenance, {}});
    out.begin_prim("Xform", root, {usd_kind("assembly")});
    UniqueNames names;
    for (const UsdTile& tile : tiles) write_tile_prim(out, tile, names.unique(tile.name));
    out.end();
  });
}

}  // namespace vug::exchange
