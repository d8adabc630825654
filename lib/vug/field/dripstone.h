// Stone that dripping water leaves in a cave: where drips fall, and what grows there.
#pragma once

#include <vug/field/noise.h>

#include <optional>
#include <vector>

namespace vug::field {

/// Metres throughout.
struct DripOptions {
  Vec3d from{-5, -5, -5}, to{5, 5, 5};  ///< the box that is searched for roofs
  double spacing = 0.8;                 ///< mean distance between places where a drip may fall
  double length = 1.5;                  ///< of the longest stalactites
  double girth = 0.12;                  ///< radius at the root, as a part of the length
  double tip = 0.03;                    ///< radius of every tip
  double stalagmites = 0.6;             ///< share of the drips that built one below, 0..1
  double root = 0.3;                    ///< over which roots flow into the rock
  std::optional<Noise> where;           ///< none where it is -1, every place where it is 1
  int seed = 1;
};

/// A place where water falls from a roof onto a floor, plumb below it.
struct Drip {
  Vec3d roof, floor;
  double stalactite = 0;  ///< length
  double stalagmite = 0;  ///< height; 0 for none
  bool column = false;    ///< both have met
};

/// Every drip inside the box, in the order of the places. Air is where `rock` is positive; roofs
/// are places where the rock's gradient points down, floors where it points up.
std::vector<Drip> find_drips(const Field& rock, const DripOptions& options);

/// What `drips` built, without the rock.
Field dripstone(const std::vector<Drip>& drips, const DripOptions& options);

}  // namespace vug::field
