// SPDX-License-Identifier: Apache-2.0
// The cost of a picture before it is made.
#pragma once

#include <vug/base/progress.h>
#include <vug/building/stored_products.h>
#include <vug/picture/picture_plan.h>

#include <cstdint>

namespace vug::farm {

/// Estimates for one picture on all cores of one machine.
struct PictureCost {
  double voxels = 0;     ///< Active voxels of the level sets that the picture shows.
  double triangles = 0;  ///< Triangles of their meshes; plants, files and cells are not counted.
  double samples = 0;    ///< Samples of all pixels.
  double build_seconds = 0;   ///< Making the products, in each task.
  double start_seconds = 0;   ///< Loading the scene and products that exist, in each process.
  double learn_seconds = 0;   ///< Learning the light, once per picture.
  double render_seconds = 0;  ///< All samples.
  double bytes = 0;           ///< Peak memory of a task.
};

/// Work per core and second. The defaults are those of caves with beds, joints and dripstone, and
/// of paths of ten bounces in haze: 33,000 (show_cave) to 70,000 (river_cave) samples were measured
/// at 480x270. Simple solids and open scenes are ten times as fast.
struct Rates {
  double voxels = 4e5;
  double triangles = 1.5e5;
  double samples = 5e4;
  /// Triangles that are read from the store and sorted into ray trees, after a fixed time that a
  /// process takes to start. Of the grotto at 12 cm, see docs/performance.md.
  double loaded_triangles = 5e5;
  double start_seconds = 1;
};

/// From the level sets that are in the store and a sampling of the fields of others (see
/// volume::estimate), the settings of the picture, and the rates. Computes deferred fields such as
/// drips if they are sampled.
PictureCost estimate_picture(const picture::PicturePlan& plan, int cores, const Rates& rates = {},
                             Progress& progress = Progress::none(),
                             const building::StoreUse& stored = {});

}  // namespace vug::farm
