// SPDX-License-Identifier: Apache-2.0
// The ground above a cave: elevations of a file in the space of a network. Heights are interpolated
// between the centres of the cells; a file in another coordinate system, or with a rotated grid, is
// first interpolated to a grid of scene space with cells of the same size.
#pragma once

#include <vug/field/ground.h>
#include <vug/field/opaque.h>
#include <vug/network/network.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::terrain {

struct TerrainOptions {
  std::filesystem::path file{};
  /// The network whose space the scene has; null: the middle of the file, rounded to metres, is the
  /// origin.
  std::shared_ptr<const network::Network> around{};
  double margin = 200;           ///< Metres of ground around the stations of the network.
  double base = 20;              ///< Metres of rock below the lowest ground and station.
  std::string system{};          ///< Replaces the coordinate system of the file unless empty.
  int band = 0;                  ///< See ElevationFile.
  double raise = 0;              ///< Metres that are added to the heights.
  std::optional<double> fill{};  ///< Height of cells without data; nothing: they are errors.
  field::Sampling sampling = field::Sampling::bicubic;
};

/// A possible fault of the heights or the place of a terrain.
struct TerrainWarning {
  std::string message, hint;
};

/// The source of a terrain's node.
struct TerrainSource : field::Ground {
  double cell = 0;                                   ///< Edge of a cell in metres.
  std::shared_ptr<const network::Network> around{};  ///< See TerrainOptions.
  std::vector<TerrainWarning> warnings{};
};
using TerrainNode = field::OpaqueNode<TerrainSource>;

/// The ground as a solid, in scene space. Throws Error(bad_input) if the file is unsuitable (see
/// ElevationFile), does not cover the network, lacks heights or cannot be placed, Error(too_large)
/// if the memory does not suffice.
field::Field terrain(const TerrainOptions& options);

}  // namespace vug::terrain
