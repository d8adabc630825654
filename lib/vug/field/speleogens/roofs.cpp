// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/box_fault.h>
#include <vug/field/speleogens/roofs.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

constexpr double kMostHollows = 1e6;  // More suggest a wrong unit.
constexpr double kLineSteps = 400;    // Of the vertical lines, at most 5 cm each.

std::vector<Roof> roofs_at(const RoofHollows& h, const Vec3d& at, RandomStream& random) {
  std::vector<Roof> out;
  const std::vector<double> heights = surface_heights(h.field, at.x, at.z, h.from.y, h.to.y);
  for (size_t i = 0; i < heights.size(); ++i) {
    // Just below a roof is air.
    if (!(h.field.value({at.x, heights[i] - 1e-6, at.z}) > 0)) continue;
    const double floor = i + 1 < heights.size() ? heights[i + 1] : h.from.y;
    Roof roof{{at.x, heights[i], at.z}, heights[i] - floor, {}};
    for (double& r : roof.random) r = random.uniform();
    out.push_back(roof);
  }
  return out;
}

}  // namespace

std::vector<double> surface_heights(const Field& rock, double x, double z, double low,
                                    double high) {
  const double step = std::min(0.05, (high - low) / kLineSteps);
  auto value = [&](double y) { return rock.value({x, y, z}); };
  std::vector<double> out;
  double y = high, here = value(y);
  while (y > low) {
    const double next = y - std::max(step, 0.999 * std::fabs(here) / rock.lipschitz());
    const double there = value(next);
    if ((there > 0) != (here > 0)) {
      double above = y, below = next;
      for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (above + below);
        ((value(middle) > 0) == (here > 0) ? above : below) = middle;
      }
      out.push_back(0.5 * (above + below));
    }
    y = next;
    here = there;
  }
  return out;
}

std::string RoofHollows::fault() const {
  const Vec3d size = to - from;
  if (const std::string fault = box_fault(from, to); !fault.empty()) return fault;
  if (!(size.x / spacing * (size.z / spacing) <= kMostHollows))
    return "the spacing is too small for a box of this size: there would be millions of hollows";
  return "";
}

std::vector<Roof> find_roofs(const RoofHollows& h) {
  const auto wide = static_cast<size_t>(std::ceil((h.to.x - h.from.x) / h.spacing)),
             deep = static_cast<size_t>(std::ceil((h.to.z - h.from.z) / h.spacing));
  const RandomKey key = RandomKey(static_cast<uint64_t>(h.seed)).at("roofs");
  std::vector<std::vector<Roof>> found(wide * deep);
  parallel_for(found.size(), [&](size_t cell) {
    RandomStream random(key.at(cell % wide).at(cell / wide));
    const double across = random.uniform(), along = random.uniform(), chance = random.uniform();
    const Vec3d at(h.from.x + h.spacing * (static_cast<double>(cell % wide) + across), 0,
                   h.from.z + h.spacing * (static_cast<double>(cell / wide) + along));
    if (at.x > h.to.x || at.z > h.to.z) return;
    for (const Roof& roof : roofs_at(h, at, random))
      if (!h.where || chance < 0.5 + 0.5 * h.where->field.value(roof.at))
        found[cell].push_back(roof);
  });
  std::vector<Roof> roofs;
  for (const auto& cell : found) roofs.insert(roofs.end(), cell.begin(), cell.end());
  return roofs;
}

}  // namespace vug::field
