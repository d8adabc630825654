// SPDX-License-Identifier: Apache-2.0
// The blocks of a pile and the fine rubble between them as a field.
#include <vug/base/error.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/opaque.h>
#include <vug/passages/breakdown/pile.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kUnderside = 0.5;  // Metres by which the rubble extends below the floor.

/// The cone with a ridge, lower by a factor, with an underside below the floor.
struct Rubble {
  Pile cone;
  double floor = 0;
  double fines = 1;

  field::Gradient sample(const Vec3d& p) const {
    const Vec3d away = cone.from_ridge(p);
    const double distance = away.length(), slope = fines * cone.slope;
    const double scale = 1 / std::sqrt(1 + slope * slope);
    const double above = (p.y - floor - fines * cone.height + slope * distance) * scale;
    const double below = floor - kUnderside - p.y;
    if (below > above) return {below, {0, -1, 0}};
    const Vec3d outwards = distance > 1e-12 ? away / distance : Vec3d(0.0);
    return {above, (Vec3d(0, 1, 0) + outwards * slope) * scale};
  }
};

field::Traits rubble_traits(const Pile& cone, double fines) {
  const double radius = (fines * cone.height + kUnderside) / (fines * cone.slope) + cone.ridge;
  field::Traits traits;
  traits.exactness = field::Exactness::bound;
  traits.bounds = {cone.foot - Vec3d(radius, kUnderside, radius),
                   cone.foot + Vec3d(radius, fines * cone.height, radius)};
  // The least rate is in the direction in which both sides of the cone's foot have equal values.
  const double slope = fines * cone.slope, scale = 1 / std::sqrt(1 + slope * slope);
  const double rate = slope * scale / (1 + scale);
  traits.growth = rate / std::sqrt(1 + rate * rate);
  return traits;
}

void require_fines(double fines) {
  if (!(fines >= 0 && fines <= 1))
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid part {:g} of fines: must be 0 to 1", fines), {},
                "use 0 for blocks without rubble between them");
}

}  // namespace

field::Field pile_body(const Pile& pile, double floor, double fines) {
  require_fines(fines);
  if (pile.blocks.empty()) return field::empty();
  field::Field blocks = polytopes("breakdown", pile.broken);
  if (fines == 0) return blocks;
  Rubble rubble{pile, floor, fines};
  rubble.cone.blocks.clear();
  rubble.cone.broken.clear();
  field::Traits traits = rubble_traits(pile, fines);
  return field::unite({std::move(blocks), field::Field(std::make_shared<field::OpaqueNode<Rubble>>(
                                              "rubble", traits, std::move(rubble)))});
}

field::Field breakdown_body(const Vault& vault, const PileOptions& options, double fines) {
  require_fines(fines);
  const Pile cone = pile_cone(vault, options);
  if (vault.blocks.empty()) return field::empty();
  field::Traits traits;
  traits.exactness = field::Exactness::bound;
  traits.growth = 1 / std::sqrt(3.0);
  // Centres of blocks lie in the cone.
  const double reach = cone.ridge + cone.height / cone.slope + vault.largest();
  traits.bounds = {cone.foot - Vec3d(reach, 0, reach),
                   cone.foot + Vec3d(reach, cone.height + 2 * vault.largest(), reach)};
  if (fines > 0) {
    const field::Traits rubble = rubble_traits(cone, fines);
    traits.growth = std::min(traits.growth, rubble.growth);
    traits.bounds = united(traits.bounds, rubble.bounds);
  }
  return field::deferred(
      std::move(traits), {"piling up blocks"},
      [](const Vault& fallen, const PileOptions& how, double rubble) {
        return pile_body(pile(fallen, how), how.floor, rubble);
      },
      vault, options, fines);
}

}  // namespace vug::passages
