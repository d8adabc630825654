// SPDX-License-Identifier: Apache-2.0
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
constexpr double kMinInterval = 10;
constexpr double kMaxInterval = 600;

/// A hash that differs for runs with different results.
std::string identity(const shot::Shot& shot) {
  Hasher hash;
  hash.add("cells").add_value(shot.text_digest).add_value(shot.seed).add_value(shot.frame);
  hash.add_value(shot.recipe.size()).add(shot.recipe).add(VUG_VERSION);
  return hash.finish().hex();
}

std::vector<volume::Grid> read_checkpoint(const fs::path& file, const std::string& identity) {
  constexpr const char* kAnew = "remove it to start again";
  try {
    const std::vector<volume::Grid> grids = volume::read(file);
    for (const volume::Grid& grid : grids) {
      const volume::Metadata metadata = grid.metadata();
      const auto own = metadata.find(kIdentity);
      if (own == metadata.end())
        throw Error(ErrorCode::bad_input,
                    fmt::format("'{}' is not a checkpoint of cells", file.string()));
      if (own->second != volume::MetaValue(identity))
        throw Error(
            ErrorCode::bad_input,
            fmt::format("the checkpoint '{}' belongs to another scene or to other parameters",
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
      every_(options_.every.value_or(kMinInterval)) {
  if (!fs::exists(options_.file)) return;
  if (!options_.resume)
    throw Error(ErrorCode::bad_input,
                fmt::format("the checkpoint '{}' already exists", options_.file.string()), {},
                "continue from it with --resume, or remove it");
  restored_ = read_checkpoint(options_.file, identity_);
}

void CellsCheckpoint::restore(const shot::CellsPlan& plan, CellLayer& layer) const {
  for (const volume::Grid& grid : restored_)
    if (grid.name() == plan.name) restore_cells(grid, layer.simulation);
}

void CellsCheckpoint::save(const shot::CellsPlan& plan, const CellLayer& layer) {
  const Clock::time_point start = Clock::now();
  std::vector<volume::Grid> grids = finished_;
  grids.push_back(cell_points(plan, layer, cells::PointFormat::exact));
  // Keep those grids of the resumed file whose runs are still to come.
  for (const volume::Grid& old : restored_)
    if (std::none_of(grids.begin(), grids.end(),
                     [&](const volume::Grid& grid) { return grid.name() == old.name(); }))
      grids.push_back(old);
  volume::write(options_.file, grids, {.half = false, .metadata = {{kIdentity, identity_}}});
  saved_ = Clock::now();
  constexpr double kShare = 0.01;
  const double seconds = std::chrono::duration<double>(saved_ - start).count();
  every_ = options_.every.value_or(std::clamp(seconds / kShare, kMinInterval, kMaxInterval));
}

void CellsCheckpoint::after_step(const shot::CellsPlan& plan, const CellLayer& layer) {
  if (std::chrono::duration<double>(Clock::now() - saved_).count() >= every_) save(plan, layer);
}

void CellsCheckpoint::finish(const shot::CellsPlan& plan, const CellLayer& layer) {
  finished_.push_back(cell_points(plan, layer, cells::PointFormat::exact));
}

Error CellsCheckpoint::save_cancelled(const shot::CellsPlan& plan, const CellLayer& layer,
                                      const Error& cancelled) {
  save(plan, layer);
  return Error(
      cancelled.code(), cancelled.what(), cancelled.where(),
      fmt::format("'{}' contains the work so far, {} of {} steps of '{}'; {} continues from it",
                  options_.file.string(), layer.simulation.step(), plan.length(), plan.name,
                  options_.resume ? "the same command" : "the same command with --resume"));
}

void CellsCheckpoint::remove() const {
  std::error_code ignored;
  fs::remove(options_.file, ignored);
}

}  // namespace vug::building
