// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/value.h>
#include <vug/delivery/assembly.h>
#include <vug/delivery/tile_levels.h>
#include <vug/delivery/write_products.h>
#include <vug/mesh/format.h>
#include <vug/meshing/tile_levels.h>
#include <vug/meshing/tile_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vug::delivery {
namespace {

using LevelJson = nlohmann::ordered_json;

/// Small, because the layer of all tiles contains the proxies of all of them.
constexpr size_t kProxyTriangles = 64;

/// Programs that read USD have no use for the keys, which are for joining tiles.
mesh::Mesh without_keys(mesh::Mesh mesh) {
  std::erase_if(mesh.attributes,
                [](const mesh::Attribute& each) { return each.name == meshing::kLatticeKey; });
  return mesh;
}

LevelJson proxy_json(const mesh::Mesh& proxy) {
  LevelJson points = LevelJson::array(), triangles = LevelJson::array();
  for (const Vec3f& p : proxy.positions) points.push_back({p.x, p.y, p.z});
  for (const mesh::Triangle& t : proxy.triangles) triangles.push_back(t);
  return {{"points", std::move(points)}, {"triangles", std::move(triangles)}};
}

mesh::Mesh proxy_of(const LevelJson& json) {
  mesh::Mesh out;
  for (const auto& p : json.at("points").get<std::vector<std::array<float, 3>>>())
    out.positions.emplace_back(p[0], p[1], p[2]);
  out.triangles = json.at("triangles").get<std::vector<mesh::Triangle>>();
  return out;
}

Vec3d point_of_json(const LevelJson& json) {
  const auto p = json.get<std::array<double, 3>>();
  return {p[0], p[1], p[2]};
}

}  // namespace

std::vector<std::string> TileLevelFiles::write(const mesh::Mesh& mesh, const std::string& file,
                                               LevelJson& entry, Progress& progress) const {
  std::vector<std::string> written;
  if (count_ <= 0 || mesh.triangles.empty()) return written;
  const std::string stem = std::filesystem::path(file).stem().string();
  const auto write_usd = [&](const mesh::Mesh& each, const std::string& name) {
    written.push_back(name + usd_extension_);
    require_writable(folder_ / written.back());
    exchange::write_usd_tile(without_keys(each), provenance_of(shot_), folder_ / written.back());
    return written.back();
  };
  const std::vector<meshing::TileLevel> coarser = meshing::tile_levels(mesh, count_, progress);
  entry["usd"] = write_usd(mesh, stem);
  LevelJson levels = LevelJson::array();
  for (size_t i = 0; i < coarser.size(); ++i) {
    const mesh::Mesh& level = coarser[i].mesh;
    const std::string name = fmt::format("{}_lod{}", stem, i + 1);
    const std::string own = name + std::filesystem::path(file).extension().string();
    require_writable(folder_ / own);
    mesh::write_mesh(level, folder_ / own, mesh_comments(shot_));
    written.push_back(own);
    levels.push_back({{"file", own},
                      {"usd", write_usd(level, name)},
                      {"vertices", level.positions.size()},
                      {"triangles", level.triangles.size()},
                      {"distance", coarser[i].distance}});
  }
  entry["levels"] = std::move(levels);
  const mesh::Mesh& coarsest = coarser.empty() ? mesh : coarser.back().mesh;
  entry["proxy"] = proxy_json(exchange::coarse_hull(coarsest, kProxyTriangles));
  return written;
}

exchange::UsdTile TileLevelFiles::write_whole(const mesh::Mesh& mesh,
                                              const std::string& name) const {
  const std::string file = name + "_whole" + usd_extension_;
  exchange::write_usd_tile(mesh, provenance_of(shot_), folder_ / file);
  return {name, mesh::bounds(mesh), {{file, 0}}, exchange::coarse_hull(mesh, kProxyTriangles)};
}

std::vector<std::string> level_files(const LevelJson& entry) {
  std::vector<std::string> out;
  if (!entry.contains("usd")) return out;
  out.push_back(entry.at("usd"));
  for (const LevelJson& level : entry.at("levels")) {
    out.push_back(level.at("file"));
    out.push_back(level.at("usd"));
  }
  return out;
}

std::optional<exchange::UsdTile> take_usd_tile(LevelJson& entry, int count) {
  if (!entry.contains("proxy")) return std::nullopt;
  const std::string file = entry.at("usd");
  const LevelJson& bounds = entry.at("bounds");
  exchange::UsdTile out{std::filesystem::path(file).stem().string(),
                        {point_of_json(bounds.at("min")), point_of_json(bounds.at("max"))},
                        {{file, 0}},
                        proxy_of(entry.at("proxy"))};
  entry.erase("proxy");
  for (const LevelJson& level : entry.at("levels"))
    out.levels.push_back({level.at("usd"), level.at("distance")});
  out.levels.resize(static_cast<size_t>(count) + 1, exchange::UsdTile::Level(out.levels.back()));
  return out;
}

std::vector<std::string> describe_levels(const std::string& mesh, const LevelJson& tiles) {
  size_t full = 0, most = 0;
  for (const LevelJson& tile : tiles) {
    full += tile.at("triangles").get<size_t>();
    if (tile.contains("levels")) most = std::max(most, tile.at("levels").size());
  }
  std::vector<std::string> out;
  for (size_t i = 0; i < most; ++i) {
    size_t triangles = 0, own = 0;
    double distance = 0;
    for (const LevelJson& tile : tiles) {
      const LevelJson levels = tile.value("levels", LevelJson::array());
      own += levels.size() > i ? 1 : 0;
      const LevelJson& shown = levels.empty() ? tile : levels.at(std::min(i, levels.size() - 1));
      triangles += shown.at("triangles").get<size_t>();
      distance = std::max(distance, shown.value("distance", 0.0));
    }
    out.push_back(fmt::format(
        "level {} of '{}': {} of {} triangles, at most {} off, {} of {} tiles have it", i + 1, mesh,
        triangles, full, quantity_text(distance, Dimension::length), own, tiles.size()));
  }
  if (most == 0)
    out.push_back(fmt::format("no level of detail of '{}': its tiles are too small", mesh));
  return out;
}

}  // namespace vug::delivery
