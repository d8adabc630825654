// SPDX-License-Identifier: Apache-2.0
// Scanned facades with ground truth in their file names: one file per door, group of windows, or
// wall.
#pragma once

#include <vug/scan/openings.h>
#include <vug/scan/read.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace vug::scan {

struct Building {
  std::vector<std::string> names;  ///< Names of doors and window groups.
  std::vector<PointCloud> elements;
  PointCloud cloud;  ///< Points of all files.
};

inline Building read_building(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Building out;
  out.cloud = read_clouds(files);
  for (const auto& file : files) {
    const std::string name = file.stem().string();
    if (name.starts_with("wall")) continue;
    out.names.push_back(name);
    out.elements.push_back(read_clouds({file}));
  }
  return out;
}

/// Bounding box of each element's points on the plane, without the outermost half per cent per
/// side.
inline std::vector<Box> true_boxes(const Building& building, const PlaneFrame& frame) {
  std::vector<Box> out;
  for (const PointCloud& element : building.elements) {
    std::vector<double> x, y;
    for (const Vec3d& p : element.positions) {
      x.push_back(frame.local(p).x);
      y.push_back(frame.local(p).y);
    }
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    const size_t cut = x.size() / 200;
    out.emplace_back(Vec2d(x[cut], y[cut]), Vec2d(x[x.size() - 1 - cut], y[y.size() - 1 - cut]));
  }
  return out;
}

}  // namespace vug::scan
