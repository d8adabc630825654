// SPDX-License-Identifier: Apache-2.0
#include <vug/scan/point_cloud.h>

#include <utility>

namespace vug::scan {
namespace {

template <class T>
void join(std::vector<T>& a, const std::vector<T>& b, bool both) {
  if (both)
    a.insert(a.end(), b.begin(), b.end());
  else
    a.clear();
}

}  // namespace

PointCloud concatenated(PointCloud a, const PointCloud& b) {
  if (a.size() == 0 || b.size() == 0) {
    const size_t dropped = a.dropped + b.dropped;
    if (a.size() == 0) a = b;
    a.dropped = dropped;
    return a;
  }
  join(a.colours, b.colours, !a.colours.empty() && !b.colours.empty());
  join(a.intensities, b.intensities, !a.intensities.empty() && !b.intensities.empty());
  join(a.normals, b.normals, !a.normals.empty() && !b.normals.empty());
  join(a.positions, b.positions, true);
  a.dropped += b.dropped;
  return a;
}

}  // namespace vug::scan
