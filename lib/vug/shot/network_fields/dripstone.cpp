// SPDX-License-Identifier: Apache-2.0
// Rock with the speleothems of its drips.
#include <vug/drips/dripstone.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/speleothems/deposits.h>
#include <vug/field/thickened.h>
#include <vug/shot/drip_params.h>
#include <vug/shot/networks.h>

#include <limits>
#include <memory>
#include <mutex>
#include <optional>

namespace vug::shot {
namespace {

struct Dripstone : DripParams {
  double tip = 0.01;
  double stalagmites = 0.6;
  double broken = 0.07;
  double draperies = 0.5;
  double folds = 0.12;
  double flowstone = 0.6;
  double root = 0.3;

  static void describe(Schema<Dripstone>& s) {
    const auto share = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::ratio, .min = 0, .max = 1};
    };
    s.doc(
         "Rock with stalactites and straws at its drips, stalagmites vertically below them, "
         "columns "
         "where they have met, draperies along sloping roofs, and flowstone on walls and floors.")
        .cite("short2005");
    describe_drips(s);
    s.param("tip", &Dripstone::tip,
            positive_length("least radius of every form: 2.55 mm in nature, but at least 0.75 "
                            "voxels. Stalactites of less than six radii are left out"))
        .param("stalagmites", &Dripstone::stalagmites,
               share("share of the drips with a stalagmite below"))
        .param("broken", &Dripstone::broken, share("share of the stalactites that broke"))
        .param("draperies", &Dripstone::draperies,
               share("share of the films under sloping roofs along which draperies hang"))
        .param("folds", &Dripstone::folds, positive_length("mean distance of their folds"))
        .param("flowstone", &Dripstone::flowstone,
               share("share of the films on walls and floors that leave a skin of flowstone"))
        .param("root", &Dripstone::root,
               positive_length("distance over which roots blend into the rock"));
  }

  drips::FormOptions forms() const {
    return {.girth = girth,
            .tip = tip,
            .stalagmites = stalagmites,
            .broken = broken,
            .seed = static_cast<uint64_t>(seed)};
  }

  drips::FlowstoneOptions layers() const {
    return {.share = flowstone, .seed = static_cast<uint64_t>(seed)};
  }
  drips::DraperyOptions sheets() const {
    return {.share = draperies,
            .fold = folds,
            .tip = tip,
            .floor = from.y,
            .seed = static_cast<uint64_t>(seed)};
  }
};

/// All that has grown on a rock, computed once for both of its fields.
class Grown {
 public:
  Grown(field::Field rock, drips::DripstoneOptions options)
      : rock_(std::move(rock)), options_(std::move(options)) {}

  field::Field solids() { return computed().solids; }
  field::Field thickness() { return computed().thickness; }

 private:
  const drips::Dripstone& computed() {
    const std::lock_guard lock(computing_);
    if (!dripstone_) dripstone_ = drips::grow_dripstone(rock_, options_);
    return *dripstone_;
  }
  field::Field rock_;
  drips::DripstoneOptions options_;
  std::mutex computing_;
  std::optional<drips::Dripstone> dripstone_;
};

field::Field with_dripstone(const Dripstone& p) {
  drips::DripstoneOptions options{p.graph(), p.forms(), p.sheets(), p.layers()};
  options.graph.run_out = p.flowstone > 0;
  options.graph.memory = std::numeric_limits<uint64_t>::max();  // Checked before it is computed.
  const Box3d bounds = drips::dripstone_bounds(p.field.bounds(), options.graph, options.forms);
  const double bytes = drips::graph_memory(options.graph);
  const auto grown = std::make_shared<Grown>(p.field, std::move(options));
  const field::Field solids = field::deferred(
      {drips::kDripstoneSlope, field::Exactness::sign, bounds, drips::kDripstoneGrowth},
      "finding drips", [grown] { return grown->solids(); }, bytes);
  const field::Field thickness = field::deferred(
      {field::kSteepestDeposit, field::Exactness::sign, infinite_box(), 0}, "laying flowstone",
      [grown] { return grown->thickness(); }, bytes);
  return field::unite({field::thickened(p.field, thickness, field::kThickestDeposit), solids},
                      {field::Profile::smooth, p.root});
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(dripstone) {
  return field::field_kind<Dripstone>("dripstone", "detail", with_dripstone);
}
