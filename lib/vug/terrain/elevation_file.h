// SPDX-License-Identifier: Apache-2.0
// A file of elevations (GeoTIFF, ASC and other formats of GDAL), of which parts are read.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vug::terrain {

/// The place of a cell: x = c[0] + c[1] * column + c[2] * row and y = c[3] + c[4] * column + c[5] *
/// row, in the coordinate system of the file. (0, 0) is the outer corner of the first cell; its
/// centre, to which its height belongs, is (0.5, 0.5).
struct GeoTransform {
  std::array<double, 6> c{0, 1, 0, 0, 0, 1};

  Vec3d place(double column, double row) const;
  /// The column and the row of a place, as x and y; the inverse of `place`.
  Vec3d cell(const Vec3d& place) const;
  bool is_rotated() const { return c[2] != 0 || c[4] != 0; }
  double determinant() const { return c[1] * c[5] - c[2] * c[4]; }
};

struct Window {
  int column = 0, row = 0;
  int columns = 0, rows = 0;
};

class ElevationFile {
 public:
  /// `band` counts from 1; 0 means the only band of the file. Throws Error(bad_input) if the file
  /// cannot be read, has no place on the ground, or has several bands of which none is chosen.
  explicit ElevationFile(std::filesystem::path file, int band = 0);
  ~ElevationFile();
  ElevationFile(const ElevationFile&) = delete;
  ElevationFile& operator=(const ElevationFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const GeoTransform& transform() const { return transform_; }
  /// The coordinate system as well-known text; empty if the file does not state it.
  const std::string& system() const { return system_; }

  /// Heights in metres, row by row, NaN for cells without data. The window lies in the file. Throws
  /// Error(bad_input) if a cell cannot be read, Error(too_large) if the memory does not suffice.
  std::vector<float> heights(const Window& window) const;

 private:
  struct Dataset;

  std::filesystem::path path_;
  std::unique_ptr<Dataset> dataset_;
  int columns_ = 0, rows_ = 0;
  GeoTransform transform_;
  std::string system_;
};

}  // namespace vug::terrain
