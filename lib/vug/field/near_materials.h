// SPDX-License-Identifier: Apache-2.0
// The materials of points that are near each other, from expressions that are restricted to the
// ball around them and from batches of values in single precision. Where an error of rounding could
// change a material, the result is unknown, and the point is evaluated alone.
#pragma once

#include <vug/field/material_mix.h>
#include <vug/field/node.h>

#include <cstdint>
#include <span>
#include <vector>

namespace vug::field {

/// Points in a ball. The last pack repeats the last point.
struct NearPoints {
  explicit NearPoints(std::vector<Vec3d> points);
  size_t size() const { return at.size(); }

  std::vector<Vec3d> at;
  std::vector<Point<Pack>> packs;  ///< The same points in single precision.
  Ball ball;
};

/// Values at such points. Errors are at most `error`, also of the bounds.
struct NearValues {
  Interval range;
  std::vector<float> values;  ///< Empty if all are above the limit; see values_near.
  double error = 0;

  bool above(size_t i, double bound) const { return values.empty() || values[i] - error > bound; }
  bool below(size_t i, double bound) const { return !values.empty() && values[i] + error < bound; }
};

/// Values of a node, of which only those that are not above the limit matter.
NearValues values_near(const Node& node, const NearPoints& points, double limit);

/// The mixes at such points. Those that are `known` have the same bits as from
/// field::sample_materials; the others have no meaning.
struct NearMixes {
  std::vector<MaterialMix> mixes;
  std::vector<uint8_t> known;

  NearMixes(size_t count, const MaterialMix& mix, bool is_known)
      : mixes(count, mix), known(count, is_known ? 1 : 0) {}
  /// Whether any other mix replaces that of a point.
  bool is_open(size_t i) const { return known[i] && mixes[i].empty(); }
  /// Replaces the mix of a point as field::mixed does with a share of 1.
  void replace(size_t i, const NearMixes& by) {
    if (!by.known[i])
      known[i] = 0;
    else if (!by.mixes[i].empty())
      mixes[i] = by.mixes[i], known[i] = 1;
  }
};

/// An interface of the nodes that find mixes faster for many points than for each of them. A
/// MaterialSource without it has unknown mixes.
class NearMaterials {
 public:
  virtual ~NearMaterials() = default;
  virtual NearMixes mixes_near(const NearPoints& points) const = 0;

 protected:
  NearMaterials() = default;
  NearMaterials(const NearMaterials&) = default;
  NearMaterials& operator=(const NearMaterials&) = default;
};

/// The mixes of a node, by the rule of field::sample_materials for nodes without materials.
NearMixes mixes_near(const Node& node, const NearPoints& points);

/// Lays a body over the mixes of what is around it, with a contact of this width; see
/// field::share_inside.
void lay_over(NearMixes& mixes, const Node& body, double contact, const NearPoints& points);

}  // namespace vug::field
