// SPDX-License-Identifier: Apache-2.0
// The way of a film of water over the surface of rock: the steepest one, which ends where the
// surface no longer falls, where the water detaches, or where it changes from roof to wall or
// floor.
#pragma once

#include <vug/base/rng.h>
#include <vug/field/field.h>

#include <vector>

namespace vug::drips {

struct FilmOptions {
  double temperature = 10;   ///< Degrees Celsius.
  double roof_step = 0.02;   ///< Metres between the points of a path on a roof.
  double floor_step = 0.05;  ///< The same on walls and floors.
  double roof_length = 2;    ///< Length of the longest path on a roof; there it drips.
  double floor_length = 40;  ///< Length of the longest path on walls and floors.
  /// A film under a level roof drips after this number of wavelengths on average (drip_spacing):
  /// drops that form nearer to each other merge.
  double merging = 4;
  Box3d region = infinite_box();  ///< Films end where they leave it.
};

enum class FilmEnd {
  low,       ///< A local low of the surface.
  detached,  ///< Drops fall from a sloping roof.
  wall,      ///< The roof has become a wall.
  floor,     ///< The wall has become a floor.
  overhang,  ///< The wall has become a roof, from which drops fall.
  lost,      ///< The film left the region, became too long, or found no surface.
};

struct Film {
  std::vector<Vec3d> path;  ///< From the start; each point is lower than the one before it.
  Vec3d normal{0.0};        ///< At its end.
  FilmEnd end = FilmEnd::lost;
};

/// The direction in which a film runs on a surface with a unit normal: gravity without its part
/// along the normal, normalised. (0, 0, 0) on level surfaces.
Vec3d film_direction(const Vec3d& normal);

/// The film along a roof from a point of it. Where it detaches is drawn from `random`.
Film roof_film(const field::Field& rock, const Vec3d& start, const FilmOptions& options,
               RandomStream random);
/// The film down a wall to a floor.
Film wall_film(const field::Field& rock, const Vec3d& start, const FilmOptions& options);
/// The film over floors, and walls between them, to a low.
Film floor_film(const field::Field& rock, const Vec3d& start, const FilmOptions& options);

}  // namespace vug::drips
