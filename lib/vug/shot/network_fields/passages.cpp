// SPDX-License-Identifier: Apache-2.0
// The passages of a network as a solid.
#include <vug/passages/passages.h>
#include <vug/shot/passage_line.h>
#include <vug/shot/section_rules.h>

namespace vug::shot {
namespace {

struct Passages : PassageLine {
  std::optional<passages::SectionFamilyPtr> section;
  std::vector<passages::SectionRule> sections;
  double chamber = passages::kDefaultChamber;
  double fillet = passages::kDefaultFillet;
  bool splays = true;

  static void describe(Schema<Passages>& s) {
    s.doc(
        "The air of the passages of a network, to be subtracted from rock. Sizes come from splays "
        "or from distances to the walls where the network has them.");
    describe_network(s);
    s.param(
        "section", &Passages::section,
        {.doc = "cross-section where no rule of `sections` applies; without both, canyons above "
                "the water table, tubes below it, and lenses where the passage is wide"});
    describe_axes(s);
    s.param(
         "chamber", &Passages::chamber,
         {.doc = "factor of sizes that were not measured where passages meet", .min = 1, .max = 10})
        .param(
            "fillet", &Passages::fillet,
            {.doc = "radius of fillets at junctions, by half the smaller size", .min = 0, .max = 1})
        .param("splays", &Passages::splays, {.doc = "sections from splays"})
        .param("sections", &Passages::sections,
               {.doc = "rules when(...) for the cross-section, of which the first that applies "
                       "counts"});
  }
};

field::Field carve(const Passages& p) {
  passages::PassageOptions options = p.options();
  options.chamber = p.chamber;
  options.fillet = p.fillet;
  options.splays = p.splays;
  if (p.section || !p.sections.empty()) options.rules = p.sections;
  if (p.section) options.section = *p.section;
  return passages::passages(*p.of, options);
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(passages) {
  return field::field_kind<Passages>("passages", "passage", carve);
}
