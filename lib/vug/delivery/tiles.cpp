// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/building/memory_estimate.h>
#include <vug/building/product_keys.h>
#include <vug/building/rock_weights.h>
#include <vug/building/tile_surface.h>
#include <vug/delivery/assembly.h>
#include <vug/delivery/tile_levels.h>
#include <vug/delivery/tile_records.h>
#include <vug/delivery/tiles.h>
#include <vug/delivery/write_products.h>
#include <vug/field/deferred.h>
#include <vug/mesh/components.h>
#include <vug/mesh/format.h>
#include <vug/mesh/topology.h>
#include <vug/meshing/tile_pieces.h>
#include <vug/shot/queries.h>
#include <vug/volume/bricks.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vug::delivery {
namespace {

using Json = nlohmann::ordered_json;
using Path = std::filesystem::path;
using volume::LatticeBox;

LatticeBox lattice_box(const Vec3i& tile, int edge) {
  return {tile * edge, tile * edge + Vec3i(edge - 1)};
}

LatticeBox with_mesh_apron(const LatticeBox& box) {
  static_assert(meshing::kMeshApron % 8 == 0);
  return {box.min - Vec3i(meshing::kMeshApron), box.max + Vec3i(meshing::kMeshApron)};
}

std::string tile_name(const std::string& product, const Vec3i& tile) {
  return fmt::format("{}_{}_{}_{}", product, tile.x, tile.y, tile.z);
}

Json numbers(const Vec3i& v) { return Json::array({v.x, v.y, v.z}); }
Json numbers(const Vec3d& v) { return Json::array({v.x, v.y, v.z}); }

/// The digest of all that determines the bytes of the tiles of a volume and of the meshes on it.
Digest key_of_tiles(const shot::Shot& shot, const shot::VolumePlan& volume,
                    const TileOptions& options) {
  Digester out;
  if (options.usd_format != "usda") out(options.usd_format);
  out(options.edge, options.levels, shot.recipe, shot.draft, volume.name,
      building::level_set_key(volume));
  for (const shot::MeshPtr& mesh : shot::declared_meshes(shot))
    if (mesh->volume.get() == &volume)
      out(mesh->name, mesh->format, building::surface_mesh_key(*mesh, shot.draft));
  return out.finish();
}

/// A mesh whose tiles are being written.
struct TiledMesh {
  const shot::MeshPlan& plan;
  meshing::TilePieces pieces = {};
  std::vector<std::string> records = {};  ///< The names of the records of its tiles.
  Json tiles = Json::array();             ///< Its tiles in the index.
};

/// Writes the tiles of one volume and of the meshes on it.
class VolumeTiles {
 public:
  VolumeTiles(building::Builder& builder, const shot::VolumePlan& plan, Path folder,
              const TileOptions& options)
      : builder_(builder),
        plan_(plan),
        folder_(std::move(folder)),
        options_(options),
        voxelize_(building::voxelize_options(plan, builder.memory_budget())),
        records_(folder_, key_of_tiles(builder.shot(), plan, options)),
        levels_(builder.shot(), folder_, options.levels, options.usd_format) {
    for (const shot::MeshPtr& mesh : shot::declared_meshes(builder.shot())) {
      if (mesh->volume.get() != &plan) continue;
      meshes_.push_back({*mesh});
      warn_of_differences(*mesh);
    }
  }

  /// Returns the parts of the index: the volume, and its meshes.
  std::pair<Json, Json> run() {
    field::compute_deferred(plan_.field, builder_.progress(), builder_.memory_budget());
    field_ = volume::field_in_region(plan_.field, voxelize_);
    if (!field_.bounds().isEmpty()) {
      const auto [low, high] = extent();
      visit(field_, low, high);
    }
    Json volume = {{"name", plan_.name},
                   {"voxel", plan_.voxel},
                   {"half_width", plan_.half_width},
                   {"tiles", std::move(tiles_)},
                   {"inside", std::move(inside_)}};
    Json meshes = Json::array();
    for (TiledMesh& mesh : meshes_) meshes.push_back(finish(mesh));
    return {std::move(volume), std::move(meshes)};
  }

  const std::vector<Path>& written() const { return written_; }
  const std::vector<std::string>& level_reports() const { return level_reports_; }
  /// The tiles of the layer of all tiles.
  const std::vector<exchange::UsdTile>& usd_tiles() const { return usd_tiles_; }

 private:
  /// What the tiles of a mesh lack that depends on more than their surroundings.
  void warn_of_differences(const shot::MeshPlan& mesh) const {
    if (mesh.adaptivity > 0)
      builder_.warn(plan_.where,
                    fmt::format("the tiles of the mesh '{}' keep all polygons", mesh.name),
                    "its 'adaptivity' merges flat regions only if the mesh is built as a whole");
    if (mesh.paint)
      builder_.warn(plan_.where,
                    fmt::format("the tiles of the mesh '{}' have no colours", mesh.name),
                    "its 'paint' is evaluated by the renderer, or if the mesh is built as a whole");
  }

  /// The first and the last tile along each axis that the band can reach.
  std::pair<Vec3i, Vec3i> extent() const {
    const double size = options_.edge * plan_.voxel, band = (plan_.half_width + 1) * plan_.voxel;
    Vec3i low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const double first = std::floor((field_.bounds().min[axis] - band) / size),
                   last = std::floor((field_.bounds().max[axis] + band) / size);
      constexpr double kMost = 2e9;
      if (!(std::max(std::fabs(first), std::fabs(last)) * options_.edge < kMost))
        throw Error(
            ErrorCode::bad_input,
            fmt::format("the volume '{}' extends beyond 2^31 voxels from the origin", plan_.name),
            plan_.where, "use a larger voxel or move the solid to the origin");
      low[axis] = static_cast<int>(first);
      high[axis] = static_cast<int>(last);
    }
    return {low, high};
  }

  bool is_wanted(const Vec3i& low, const Vec3i& high) const {
    return options_.only.empty() ||
           std::any_of(options_.only.begin(), options_.only.end(),
                       [&](const Vec3i& tile) { return LatticeBox(low, high).intersects(tile); });
  }

  /// Visits the tiles from `low` to `high` in halves, so that empty space costs little.
  void visit(const field::Field& outer, const Vec3i& low, const Vec3i& high) {
    builder_.progress().check();
    if (!is_wanted(low, high)) return;
    const double size = options_.edge * plan_.voxel;
    const Vec3d from = Vec3d(low) * size, to = Vec3d(high + Vec3i(1)) * size;
    const double limit = (plan_.half_width + 2) * plan_.voxel * std::max(1.0, field_.lipschitz());
    const auto part = outer.restricted_near({(from + to) * 0.5, (to - from).length() * 0.5}, limit);
    if (part.range.lo > limit) return;
    if (part.range.hi < -limit) return add_inside(low, high);
    if (low == high) return add(low);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
      if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
    Vec3i middle = high, next = low;
    middle[axis] = low[axis] + (high[axis] - low[axis]) / 2;
    next[axis] = middle[axis] + 1;
    visit(part.field, low, middle);
    visit(part.field, next, high);
  }

  void add_inside(const Vec3i& low, const Vec3i& high) {
    inside_.push_back({{"from", numbers(low)}, {"to", numbers(high)}});
  }

  /// Writes a tile, unless an interrupted run wrote it, and adds it to the index.
  void add(const Vec3i& tile) {
    const std::string name = tile_name(plan_.name, tile);
    const LatticeBox box = lattice_box(tile, options_.edge);
    const bool all = options_.only.empty();
    const std::optional<TileRecord> known = all ? records_.read(name) : std::nullopt;
    TileRecord record = known ? *known : write(tile, box);
    if (known)
      for (TiledMesh& mesh : meshes_) add_pieces_of_file(mesh, record, box);
    else if (all)
      records_.write(name, record);
    for (const std::string& file : record.files) written_.push_back(folder_ / file);
    if (record.content.contains("inside")) add_inside(tile, tile);
    if (record.content.contains("volume")) tiles_.push_back(std::move(record.content["volume"]));
    for (TiledMesh& mesh : meshes_) {
      const auto found = record.content["meshes"].find(mesh.plan.name);
      if (found == record.content["meshes"].end()) continue;
      mesh.records.push_back(name);
      mesh.tiles.push_back(std::move(*found));
    }
  }

  void add_pieces_of_file(TiledMesh& mesh, const TileRecord& record, const LatticeBox& box) const {
    const Json& written = record.content["meshes"];
    if (mesh.plan.smallest_piece <= 0 || !written.contains(mesh.plan.name)) return;
    meshing::TileMesh tile;
    tile.mesh = mesh::read_mesh(folder_ / written[mesh.plan.name]["file"].get<std::string>());
    tile.keys = meshing::keys_of_attribute(tile.mesh, box);
    mesh.pieces.add(tile, box);
  }

  TileRecord write(const Vec3i& tile, const LatticeBox& box) {
    TileRecord record;
    record.content["meshes"] = Json::object();
    const Progress::Product product(builder_.progress(), tile_name(plan_.name, tile));
    volume::VoxelizeOptions options = voxelize_;
    options.tile = meshes_.empty() ? box : with_mesh_apron(box);
    const volume::LevelSet around = volume::voxelize(plan_.field, options, builder_.progress());
    const volume::LevelSet own = meshes_.empty() ? around : volume::cropped(around, box);
    const volume::Statistics statistics = own.statistics();
    if (statistics.active_voxels == 0) {
      if (own.holds_solid()) record.content["inside"] = true;
    } else {
      const std::string file = tile_name(plan_.name, tile) + ".vdb";
      write_volume(folder_ / file, tile, own);
      record.files.push_back(file);
      record.content["volume"] = {{"tile", numbers(tile)},
                                  {"file", file},
                                  {"active_voxels", statistics.active_voxels},
                                  {"content", own.content().hex()}};
    }
    for (TiledMesh& mesh : meshes_) write_mesh(mesh, tile, box, around, record);
    return record;
  }

  void write_volume(const Path& file, const Vec3i& tile, const volume::LevelSet& own) {
    const volume::Metadata notes = {{"vug:tile", fmt::format("{},{},{}", tile.x, tile.y, tile.z)},
                                    {"vug:tile_edge", static_cast<int64_t>(options_.edge)}};
    std::vector<volume::Grid> grids = {volume_grid(plan_, own).with(notes)};
    if (!plan_.fog)
      for (volume::Grid& grid : building::rock_grids(plan_, own, "", builder_.memory_budget()))
        grids.push_back(grid.with(notes));
    require_writable(file);  // Removes what a killed run left.
    volume::write(file, grids, write_options(builder_.shot()));
  }

  void write_mesh(TiledMesh& mesh, const Vec3i& tile, const LatticeBox& box,
                  const volume::LevelSet& around, TileRecord& record) {
    shot::MeshPlan plan = mesh.plan;
    plan.polish = plan.polish && !builder_.shot().draft;
    meshing::TileMesh made =
        building::make_tile_mesh(plan, around, field_, box, builder_.progress());
    if (made.mesh.triangles.empty()) return;
    if (plan.smallest_piece > 0) mesh.pieces.add(made, box);
    meshing::add_key_attribute(made, box);
    const Path file = folder_ / fmt::format("{}.{}", tile_name(plan.name, tile), plan.format);
    require_writable(file);
    mesh::write_mesh(made.mesh, file, mesh_comments(builder_.shot()));
    record.files.push_back(file.filename().string());
    Json entry = described(made.mesh, numbers(tile), file);
    for (const std::string& each :
         levels_.write(made.mesh, file.filename().string(), entry, builder_.progress()))
      record.files.push_back(each);
    record.content["meshes"][plan.name] = std::move(entry);
  }

  static Json described(const mesh::Mesh& mesh, const Json& tile, const Path& file) {
    const Box3d bounds = mesh::bounds(mesh);
    return {{"tile", tile},
            {"file", file.filename().string()},
            {"vertices", mesh.positions.size()},
            {"triangles", mesh.triangles.size()},
            {"bounds", {{"min", numbers(bounds.min)}, {"max", numbers(bounds.max)}}}};
  }

  /// Removes small pieces from the files of the mesh, and returns its part of the index.
  Json finish(TiledMesh& mesh) {
    size_t removed = 0;
    if (mesh.plan.smallest_piece > 0 && options_.only.empty()) {
      const meshing::TilePieces::Large large = mesh.pieces.large(mesh.plan.smallest_piece);
      removed = large.removed;
      for (size_t i = 0; i < mesh.tiles.size(); ++i) {
        const std::vector<char>& remains = large.remains[i];
        if (std::find(remains.begin(), remains.end(), 0) == remains.end()) continue;
        const Path file = folder_ / mesh.tiles[i]["file"].get<std::string>();
        mesh::Mesh whole = mesh::read_mesh(file);
        const std::vector<uint32_t> component_of =
            mesh::face_components(whole, mesh::find_edges(whole));
        const mesh::Mesh kept = mesh::remaining(std::move(whole), component_of, remains);
        records_.remove(mesh.records[i]);
        mesh::write_mesh(kept, file, mesh_comments(builder_.shot()));
        Json entry = described(kept, Json(mesh.tiles[i]["tile"]), file);
        replace_levels(mesh.tiles[i], kept, file.filename().string(), entry);
        mesh.tiles[i] = std::move(entry);
      }
    }
    if (options_.levels > 0)
      for (const std::string& each : describe_levels(mesh.plan.name, mesh.tiles))
        level_reports_.push_back(each);
    for (Json& entry : mesh.tiles)
      if (std::optional<exchange::UsdTile> tile = take_usd_tile(entry, options_.levels))
        usd_tiles_.push_back(std::move(*tile));
    return {{"name", mesh.plan.name},
            {"volume", plan_.name},
            {"pieces_removed", removed},
            {"tiles", std::move(mesh.tiles)}};
  }

  /// Writes the levels of a tile whose mesh has changed, and removes those that it had before.
  void replace_levels(const Json& before, const mesh::Mesh& mesh, const std::string& file,
                      Json& entry) {
    const std::vector<std::string> now = levels_.write(mesh, file, entry, builder_.progress());
    for (const std::string& old : level_files(before)) {
      if (std::find(now.begin(), now.end(), old) != now.end()) continue;
      std::error_code ignored;
      std::filesystem::remove(folder_ / old, ignored);
      std::erase(written_, folder_ / old);
    }
  }

  building::Builder& builder_;
  const shot::VolumePlan& plan_;
  Path folder_;
  const TileOptions& options_;
  volume::VoxelizeOptions voxelize_;
  TileRecords records_;
  TileLevelFiles levels_;
  field::Field field_;  ///< With the faces of the region.
  std::vector<TiledMesh> meshes_;
  Json tiles_ = Json::array(), inside_ = Json::array();
  std::vector<Path> written_;
  std::vector<std::string> level_reports_;
  std::vector<exchange::UsdTile> usd_tiles_;
};

/// Writes the meshes that are not the surface of a volume, such as stems and models, as a whole.
void write_whole_meshes(building::Builder& builder, const Path& folder,
                        const TileLevelFiles& levels, Json& meshes, std::vector<Path>& written,
                        std::vector<exchange::UsdTile>& usd) {
  for (const shot::MeshPtr& plan : shot::declared_meshes(builder.shot())) {
    if (plan->volume) continue;
    const Path file = folder / fmt::format("{}.{}", plan->name, plan->format);
    mesh::write_mesh(*builder.mesh(plan), file, mesh_comments(builder.shot()));
    meshes.push_back({{"name", plan->name}, {"file", file.filename().string()}});
    written.push_back(file);
    if (levels.count() <= 0 || builder.mesh(plan)->triangles.empty()) continue;
    usd.push_back(levels.write_whole(*builder.mesh(plan), plan->name));
    meshes.back()["usd"] = usd.back().levels.front().file;
    written.push_back(folder / usd.back().levels.front().file);
  }
}

void check(const shot::Shot& shot, const TileOptions& options) {
  constexpr int kSmallest = 64, kLargest = 1 << 14;
  if (options.edge < kSmallest || options.edge > kLargest || options.edge % 8 != 0)
    throw Error(
        ErrorCode::bad_input, fmt::format("tiles cannot have an edge of {} voxels", options.edge),
        {}, fmt::format("give a multiple of 8 from {} to {}, such as 1024", kSmallest, kLargest));
  if (const std::string obstacle = obstacle_to_tiles(shot); !obstacle.empty())
    throw Error(ErrorCode::bad_input, obstacle, {}, "build this scene without --tiles");
  for (const shot::MeshPtr& mesh : shot::declared_meshes(shot))
    if (!options.only.empty() && mesh->smallest_piece > 0)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the small pieces of the mesh '{}' are only known when all tiles are",
                              mesh->name),
                  {}, "build all tiles, or set smallest_piece 0");
  const std::vector<shot::MeshPtr> meshes = shot::declared_meshes(shot);
  if (options.levels > 0 &&
      std::none_of(meshes.begin(), meshes.end(),
                   [](const shot::MeshPtr& each) { return each->volume != nullptr; }))
    throw Error(ErrorCode::bad_input, "levels of detail need the mesh of a volume", {},
                "add, for instance: mesh rock on rock {}");
}

}  // namespace

std::string obstacle_to_tiles(const shot::Shot& shot) {
  for (const shot::VolumePtr& volume : shot.volumes) {
    if (volume->source_mesh)
      return fmt::format("the volume '{}' is made of a mesh, which cannot be divided into tiles",
                         volume->name);
    if (volume->distance == shot::DistanceValues::exact)
      return fmt::format("the exact distances of the volume '{}' need the whole surface",
                         volume->name);
  }
  for (const shot::MeshPtr& mesh : shot::declared_meshes(shot))
    if (mesh->volume && mesh->smallest_piece > 0 && mesh->format != "ply")
      return fmt::format(
          "the small pieces of the mesh '{}' can only be removed from tiles of format ply",
          mesh->name);
  if (!shot::declared_cells(shot).empty()) return "cells grow across tiles";
  return "";
}

Path tile_folder(const shot::Shot& shot, const Path& folder) {
  return folder / (shot.name + ".tiles");
}

TilesReport write_tiles(building::Builder& builder, const Path& folder,
                        const TileOptions& options) {
  const shot::Shot& shot = builder.shot();
  check(shot, options);
  const Path target = tile_folder(shot, folder), index = target / "index.json";
  require_writable(index);
  TilesReport report;
  std::vector<exchange::UsdTile> usd;
  const auto append = [](const auto& from, auto& to) {
    to.insert(to.end(), from.begin(), from.end());
  };
  Json volumes = Json::array(), meshes = Json::array();
  for (const shot::VolumePtr& plan : shot.volumes) {
    VolumeTiles tiles(builder, *plan, target, options);
    auto [volume, own] = tiles.run();
    volumes.push_back(std::move(volume));
    for (Json& mesh : own) meshes.push_back(std::move(mesh));
    append(tiles.written(), report.files);
    append(tiles.level_reports(), report.levels);
    append(tiles.usd_tiles(), usd);
  }
  if (!options.only.empty()) {
    if (report.files.empty())
      throw Error(ErrorCode::bad_input, "the surface does not cross these tiles", {},
                  "see the tiles in index.json, which is written with all of them");
    return report;
  }
  write_whole_meshes(builder, target,
                     TileLevelFiles(shot, target, options.levels, options.usd_format), meshes,
                     report.files, usd);
  Json content = {{"format", "vug-tiles"}, {"version", 1},          {"name", shot.name},
                  {"seed", shot.seed},     {"recipe", shot.recipe}, {"edge", options.edge}};
  if (options.levels > 0) {
    const Path assembly = target / ("assembly." + options.usd_format);
    exchange::write_usd_tiles(shot.name, usd, provenance_of(shot), assembly);
    report.files.push_back(assembly);
    content["levels"] = options.levels;
    content["usd"] = assembly.filename().string();
  }
  content["volumes"] = std::move(volumes);
  content["meshes"] = std::move(meshes);
  write_text(index, content.dump(1) + "\n");
  remove_tile_records(target);
  report.files.push_back(index);
  return report;
}

}  // namespace vug::delivery
