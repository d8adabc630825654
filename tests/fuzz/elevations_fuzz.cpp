// SPDX-License-Identifier: Apache-2.0
// Any bytes as a file of elevations. It is refused as bad input, or has a place on the ground and
// heights that are plausible or missing.
#include "file_of_bytes.h"
#include "require.h"
#include "target.h"

#include <vug/base/error.h>
#include <vug/terrain/elevation_file.h>

#include <algorithm>
#include <cmath>

/// GDAL, which is loaded on first use, does not free all memory of damaged files.
extern "C" const char* __lsan_default_suppressions() { return "leak:libgdal\nleak:libhdf5\n"; }

namespace {

using namespace vug;
using terrain::ElevationFile, terrain::Window;

void check_heights(const ElevationFile& file, const Window& window) {
  for (const float height : file.heights(window))
    require(std::isnan(height) || std::fabs(height) < 3e4f, "heights are plausible");
}

void check(const ElevationFile& file) {
  require(file.columns() >= 2 && file.rows() >= 2, "the grid has cells");
  const Vec3d place = file.transform().place(0.5, 0.5);
  require(std::isfinite(place.x) && std::isfinite(place.y), "the place is finite");
  require(std::fabs(file.transform().determinant()) > 0, "cells have an area");
  // The first and the last cells: headers can claim any size.
  constexpr int kMost = 16;
  const int columns = std::min(file.columns(), kMost), rows = std::min(file.rows(), kMost);
  check_heights(file, {0, 0, columns, rows});
  check_heights(file, {file.columns() - columns, file.rows() - rows, columns, rows});
}

}  // namespace

VUG_FUZZ_TARGET(elevations) {
  const std::filesystem::path& path = file_of_bytes(data, size, ".asc");
  try {
    const ElevationFile file(path, size % 2 == 0 ? 0 : 1);
    check(file);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::bad_input || error.code() == ErrorCode::too_large,
            "errors blame the input");
  }
}
