#include <vug/base/hash.h>
#include <vug/building/cell_points.h>
#include <vug/building/cells_checkpoint.h>
#include <vug/volume/io.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::building {
namespace {
namespace fs = std::filesystem;

constexpr const char* kIdentity = "vug:identity";
constexpr double kLeastPause = 10;
constexpr double kMostPause = 600;

/// Tells runs with other results apart.
std::string identity(const shot::Shot& shot) {
  Hasher hash;
  hash.add("cells").add_value(shot.texts).add_value(shot.seed).add_value(shot.frame);
  hash.add_value(shot.recipe.size()).add(shot.recipe).add(VUG_VERSION);
  return hash.finish().hex();
}

std::vector<volume::Grid> read_kept(const fs::path& file, const std::string& identity) {
  constexpr const char* kAnew = "remove it to begin anew";
  try {
    const std::vector<volume::Grid> grids = volume::read(file);
    for (const volume::Grid& grid : grids) {
      const volume::Metadata metadata = grid.metadata();
      const auto own = metadata.find(kIdentity);
      if (own == metadata.end())
        throw Error(ErrorCode::bad_input,
                    fmt::format("'{}' is no checkpoint of cells", file.string()));
      if (own->second != volume::MetaValue(identity))
        throw Error(ErrorCode::bad_input,
                    fmt::format("the checkpoint '{}' is of another scene, or of other parameters",
                                file.string()));
    }
    return grids;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;
    throw Error(error.code(), error.what(), error.where(), kAnew);
  }
}

}  // namespace

CellsCheckpoint::CellsCheckpoint(CheckpointOptions options, const shot::Shot& shot)
    : options_(std::move(options)),
      identity_(identity(shot)),
      every_(options_.every.value_or(kLeastPause)) {
  if (!fs::exists(options_.file)) return;
  if (!options_.resume)
    throw Error(ErrorCode::bad_input,
                fmt::format("the checkpoint '{}' is there already", options_.file.string()), {},
                "go on from it with --resume, or remove it");
  kept_ = read_kept(options_.file, identity_);
}

void CellsCheckpoint::put_back(const shot::CellsPlan& plan, Skin& skin) const {
  for (const volume::Grid& grid : kept_)
    if (grid.name() == plan.name) read_cells(grid, skin.simulation);
}

void CellsCheckpoint::save(const shot::CellsPlan& plan, const Skin& skin) {
  const Clock::time_point begun = Clock::now();
  std::vector<volume::Grid> grids = finished_;
  grids.push_back(cell_points(plan, skin, cells::PointFormat::exact));
  // What is yet to come of a file that this run goes on from stays there.
  for (const volume::Grid& old : kept_)
    if (std::none_of(grids.begin(), grids.end(),
                     [&](const volume::Grid& grid) { return grid.name() == old.name(); }))
      grids.push_back(old);
  volume::write(options_.file, grids, {.half = false, .metadata = {{kIdentity, identity_}}});
  saved_ = Clock::now();
  constexpr double kShare = 0.01;
  const double seconds = std::chrono::duration<double>(saved_ - begun).count();
  every_ = options_.every.value_or(std::clamp(seconds / kShare, kLeastPause, kMostPause));
}

void CellsCheckpoint::after_step(const shot::CellsPlan& plan, const Skin& skin) {
  if (std::chrono::duration<double>(Clock::now() - saved_).count() >= every_) save(plan, skin);
}

void CellsCheckpoint::finish(const shot::CellsPlan& plan, const Skin& skin) {
  finished_.push_back(cell_points(plan, skin, cells::PointFormat::exact));
}

Error CellsCheckpoint::stopped(const shot::CellsPlan& plan, const Skin& skin,
                               const Error& cancelled) {
  save(plan, skin);
  return Error(
      cancelled.code(), cancelled.what(), cancelled.where(),
      fmt::format("'{}' keeps what is done, {} of {} steps of '{}'; {} goes on from it",
                  options_.file.string(), skin.simulation.step(), plan.length(), plan.name,
                  options_.resume ? "the same command" : "the same command with --resume"));
}

void CellsCheckpoint::remove() const {
  std::error_code ignored;
  fs::remove(options_.file, ignored);
}

}  // namespace vug::building
