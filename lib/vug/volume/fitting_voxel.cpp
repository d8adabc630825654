// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/fitting_voxel.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::volume {

double fitting_voxel(double voxel, double bytes, double limit) {
  constexpr double kReserve = 1.1;  // The estimate is rougher for other voxels.
  const double fitting = voxel * std::sqrt(kReserve * bytes / limit);
  double unit = 1;  // Of the second digit.
  while (fitting / unit >= 100) unit *= 10;
  while (fitting / unit < 10) unit /= 10;
  return std::ceil(fitting / unit) * unit;
}

std::string fitting_voxel_hint(double voxel, double bytes, uint64_t limit) {
  if (!(bytes > 0 && std::isfinite(bytes)) || limit == 0)
    return "use a larger voxel, a smaller region";
  return fmt::format("use voxels of at least {:.2g} m, a smaller region",
                     fitting_voxel(voxel, bytes, static_cast<double>(limit)));
}

}  // namespace vug::volume
