// SPDX-License-Identifier: Apache-2.0
#include <vug/field/box_fault.h>
#include <vug/shot/drip_params.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::shot {

drips::DripstoneOptions DripParams::options() const {
  const auto random = static_cast<uint64_t>(seed);
  drips::GraphOptions o;
  o.from = from;
  o.to = to;
  o.spacing = spacing;
  o.density = density;
  o.where = where;
  if (!joints.empty()) {
    karst::Geology geology;
    geology.bounds = Box3d(from, to);
    for (const GeologyFeaturePtr& feature : joints) (*feature)(geology);
    karst::require_valid(geology);
    o.planes = drips::Planes(std::move(geology), static_cast<uint64_t>(joint_seed));
  }
  o.interval = interval;
  o.oldest = age;
  o.final_age = final_age;
  o.temperature = temperature;
  o.girth = girth;
  o.straws = straws;
  if (budget > 0) o.edits.budget = static_cast<size_t>(budget);
  for (const DripEditPtr& edit : edits) (*edit)(o.edits);
  o.seed = random;
  const double last = o.last_age();
  return {std::move(o),
          {.girth = girth,
           .tip = tip,
           .stalagmites = stalagmites,
           .broken = broken,
           .age = age,
           .final_age = last,
           .seed = random},
          {.share = draperies, .fold = folds, .tip = tip, .floor = from.y, .seed = random},
          {.share = flowstone, .seed = random}};
}

std::string DripParams::fault() const {
  const Vec3d size = to - from;
  if (const std::string fault = field::box_fault(from, to); !fault.empty()) return fault;
  const double places = size.x / spacing * (size.z / spacing);
  if (!(places <= drips::kMostColumns))
    return fmt::format(
        "the spacing is too small for a box of this size: there would be millions of drips, at "
        "{:.2g} places, and at most {:.2g} are possible; use a spacing of {:.3g} m or more",
        places, drips::kMostColumns, 1.01 * std::sqrt(size.x * size.z / drips::kMostColumns));
  if (final_age > 0 && final_age < age)
    return "the final age must be at least the age; it is the age at the end of a sequence";
  return "";
}

}  // namespace vug::shot
