// Runs of cells that take long: what is done goes into a file, from which a run that was killed
// goes on to the same bytes.
#pragma once

#include <vug/building/cell_layer.h>
#include <vug/volume/grid.h>

#include <chrono>
#include <filesystem>
#include <optional>

namespace vug::building {

struct CheckpointOptions {
  std::filesystem::path file;   ///< A .vdb with a grid of exact points for each cells.
  std::optional<double> every;  ///< Seconds; none: so that saving takes 1 % of the time, about.
  bool resume = false;          ///< Go on from the file if there is one.
};

/// Of all cells of one shot. Not for several threads at once.
class CellsCheckpoint {
 public:
  /// Error(bad_input) where the file is there without `resume`, or is of another scene, version,
  /// seed or parameters.
  CellsCheckpoint(CheckpointOptions options, const shot::Shot& shot);

  /// Gives the cells what the file has of them, if anything.
  void restore(const shot::CellsPlan& plan, CellLayer& layer) const;
  /// Saves when it is time to.
  void after_step(const shot::CellsPlan& plan, const CellLayer& layer);
  /// Keeps a finished run for the files that later ones save.
  void finish(const shot::CellsPlan& plan, const CellLayer& layer);
  /// Saves now; gives the error of a run that was cancelled, with how to go on.
  Error save_cancelled(const shot::CellsPlan& plan, const CellLayer& layer, const Error& cancelled);
  /// To be called when all that was made of the cells is safe.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  void save(const shot::CellsPlan& plan, const CellLayer& layer);

  CheckpointOptions options_;
  std::string identity_;
  std::vector<volume::Grid> restored_;  ///< Of the file.
  std::vector<volume::Grid> finished_;  ///< Of this run.
  Clock::time_point saved_ = Clock::now();
  double every_;
};

}  // namespace vug::building
