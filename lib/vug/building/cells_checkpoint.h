// SPDX-License-Identifier: Apache-2.0
// Checkpoints of long runs of cells: a killed run continues from its file and yields the same
// bytes.
#pragma once

#include <vug/building/cell_layer.h>
#include <vug/volume/grid.h>

#include <chrono>
#include <filesystem>
#include <optional>

namespace vug::building {

struct CheckpointOptions {
  std::filesystem::path file;  ///< A .vdb with one grid of exact points for each plan.
  std::optional<double>
      every;            ///< Interval in seconds; default: saving takes about 1 % of the time.
  bool resume = false;  ///< Continue from the file if it exists.
};

/// The checkpoint of all cells of one shot. Not thread-safe.
class CellsCheckpoint {
 public:
  /// Error(bad_input) if the file exists without `resume`, or belongs to another scene, version,
  /// seed or other parameters.
  CellsCheckpoint(CheckpointOptions options, const shot::Shot& shot);

  /// Restores the state of the cells from the file, if it contains them.
  void restore(const shot::CellsPlan& plan, CellLayer& layer) const;
  /// Saves if the interval has passed.
  void after_step(const shot::CellsPlan& plan, const CellLayer& layer);
  /// Records a finished run, which later checkpoints include.
  void finish(const shot::CellsPlan& plan, const CellLayer& layer);
  /// Saves at once; returns the error of the cancelled run with a hint on how to continue.
  Error save_cancelled(const shot::CellsPlan& plan, const CellLayer& layer, const Error& cancelled);
  /// Removes the file; call it after all products of the cells have been written.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  void save(const shot::CellsPlan& plan, const CellLayer& layer);

  CheckpointOptions options_;
  std::string identity_;
  std::vector<volume::Grid> restored_;  ///< From the file.
  std::vector<volume::Grid> finished_;  ///< Computed by this process.
  Clock::time_point saved_ = Clock::now();
  double every_;
};

}  // namespace vug::building
