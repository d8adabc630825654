// SPDX-License-Identifier: Apache-2.0
// The passages of a network as a solid.
#include <vug/passages/passages.h>
#include <vug/shot/networks.h>

namespace vug::shot {
namespace {

struct Passages {
  NetworkPtr of;
  std::optional<passages::SectionFamilyPtr> section;
  double width = passages::DefaultSize().width;
  double height = passages::DefaultSize().height;
  double sinuosity = passages::MeanderOptions().sinuosity;
  double chamber = passages::kDefaultChamber;
  double fillet = passages::kDefaultFillet;
  bool smooth = true;
  bool splays = true;

  static void describe(Schema<Passages>& s) {
    s.doc(
         "The air of the passages of a network, to be subtracted from rock. Sizes come from splays "
         "or from distances to the walls where the network has them.")
        .param("of", &Passages::of, {.doc = "the network", .required = true})
        .param("section", &Passages::section,
               {.doc = "cross-section of all passages; by default canyons above the water table, "
                       "tubes below it, and lenses where the passage is wide"})
        .param("width", &Passages::width, positive_length("where it was not measured"))
        .param("height", &Passages::height, positive_length("where it was not measured"))
        .param(
            "sinuosity", &Passages::sinuosity,
            {.doc = "length of a stream's meanders over that of the valley", .min = 1, .max = 3.5})
        .param("chamber", &Passages::chamber,
               {.doc = "factor of sizes that were not measured where passages meet",
                .min = 1,
                .max = 10})
        .param(
            "fillet", &Passages::fillet,
            {.doc = "radius of fillets at junctions, by half the smaller size", .min = 0, .max = 1})
        .param("smooth", &Passages::smooth, {.doc = "curves through the stations"})
        .param("splays", &Passages::splays, {.doc = "sections from splays"});
  }
};

field::Field carve(const Passages& p) {
  passages::PassageOptions options;
  options.size.width = p.width;
  options.size.height = p.height;
  options.meanders.sinuosity = p.sinuosity;
  options.chamber = p.chamber;
  options.fillet = p.fillet;
  options.smooth = p.smooth;
  options.splays = p.splays;
  if (p.section) {
    options.section = *p.section;
    options.rules.clear();
  }
  return passages::passages(*p.of, options);
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(passages) {
  return field::field_kind<Passages>("passages", "passage", carve);
}
