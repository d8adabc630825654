// SPDX-License-Identifier: Apache-2.0
// Synthetic point clouds of known facades.
#pragma once

#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/scan/plane.h>

#include <vector>

namespace vug::scan {

/// A rectangle of a synthetic facade in metres from its lower left corner.
struct Hole {
  double x = 0, y = 0, width = 1, height = 1;
  double behind = 0;  ///< Distance behind the wall in metres; 0: no returns.

  bool holds(double px, double py) const {
    return px >= x && px < x + width && py >= y && py < y + height;
  }
};

struct SyntheticFacade {
  double width = 12, height = 8;
  double step = 0.04;       ///< Metres between points.
  double noise = 0.005;     ///< Standard deviation along the plane's normal, metres.
  double outliers = 0;      ///< Stray points relative to the other points.
  double yaw = 0.7;         ///< Rotation of the facade about z, radians.
  double bow = 0;           ///< Metres by which the middle is in front of the ends.
  Vec3d corner{10, 20, 3};  ///< Lower left corner seen from the front.
  std::vector<Hole> holes = {};

  /// Right-handed, z up in the cloud's axes.
  PlaneFrame frame() const {
    const Vec3d x(maths::cos(yaw), maths::sin(yaw), 0), y(0, 0, 1);
    return {corner, x, y, x.cross(y)};
  }
  PointCloud cloud(uint64_t seed = 1) const {
    PointCloud out;
    RandomStream stream{RandomKey(seed)};
    const PlaneFrame at = frame();
    for (double py = step / 2; py < height; py += step)
      for (double px = step / 2; px < width; px += step) {
        const double u = 2 * px / width - 1;
        double depth = bow * (1 - u * u) + noise * stream.normal();
        bool swallowed = false;
        for (const Hole& hole : holes)
          if (hole.holds(px, py)) depth -= hole.behind, swallowed |= hole.behind == 0;
        if (!swallowed) out.positions.push_back(at.world({px, py, depth}));
      }
    const auto strays = static_cast<size_t>(outliers * static_cast<double>(out.size()));
    for (size_t i = 0; i < strays; ++i) {
      const double px = stream.uniform(0, width), py = stream.uniform(0, height);
      out.positions.push_back(at.world({px, py, stream.uniform(-4, 4)}));
    }
    return out;
  }
};

}  // namespace vug::scan
