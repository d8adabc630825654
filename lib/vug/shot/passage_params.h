// SPDX-License-Identifier: Apache-2.0
// The parameters that all fields in passages of a network share: they select the same walls.
#pragma once

#include <vug/shot/passage_line.h>
#include <vug/shot/section_rules.h>

#include <fmt/format.h>

#include <optional>

namespace vug::shot {

struct PassageParams : PassageLine {
  std::optional<passages::SectionFamilyPtr> section;
  std::vector<passages::SectionRule> sections;
  double chamber = passages::kDefaultChamber;
  double fillet = passages::kDefaultFillet;

  passages::PassageOptions options() const;

  /// Adds the parameters of the walls to the schema of a struct that is derived from this one.
  template <class P>
  static void describe_walls(Schema<P>& s) {
    s.param(
        "section", &PassageParams::section,
        {.doc = "cross-section where no rule of `sections` applies; without both, canyons above "
                "the water table, tubes below it, and lenses where the passage is wide"});
    describe_axes(s);
    s.param(
         "chamber", &PassageParams::chamber,
         {.doc = "factor of sizes that were not measured where passages meet", .min = 1, .max = 10})
        .param(
            "fillet", &PassageParams::fillet,
            {.doc = "radius of fillets at junctions, by half the smaller size", .min = 0, .max = 1})
        .param("sections", &PassageParams::sections,
               {.doc = "rules when(...) for the cross-section, of which the first that applies "
                       "counts"});
  }
};

/// Adds the sediment on the floor, `depth` and `fill` of P.
template <class P>
void describe_bed(Schema<P>& s, const char* depth, const char* fill) {
  s.param(depth, &P::depth,
          {.doc = "depth of sediment above the lowest point of the floor",
           .dimension = Dimension::length,
           .min = 0})
      .param(fill, &P::fill,
             {.doc = "additional depth of sediment, as a part of the passage's height",
              .min = 0,
              .max = 1});
}

/// Adds `overlap` of P, by which `body` extends into the rock.
template <class P>
void describe_overlap(Schema<P>& s, const char* body) {
  s.param("overlap", &P::overlap,
          {.doc = fmt::format("how far the {} extends into walls and floor", body),
           .dimension = Dimension::length,
           .min = 0.05,
           .max = 100});
}

/// The stations with these names; see network::find_station.
std::vector<int> stations_named(const network::Network& network,
                                const std::vector<std::string>& names);

}  // namespace vug::shot
