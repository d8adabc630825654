// SPDX-License-Identifier: Apache-2.0
// The parameters of networks that select the statistics of passage sizes.
#pragma once

#include <vug/base/schema.h>
#include <vug/network/section_statistics.h>

#include <string>

namespace vug::shot {

struct SectionChoice {
  std::string like = "usual";
  double size = 1;
  double variation = 1;

  /// Adds the parameters to the schema of a struct that is derived from this one.
  template <class P>
  static void describe(Schema<P>& s) {
    std::vector<std::pair<std::string, std::string>> names{{"usual", "usual"}};
    for (const network::NamedSectionModel& each : network::section_models())
      names.emplace_back(each.name, each.name);
    s.choice("like", static_cast<std::string P::*>(&SectionChoice::like), std::move(names),
             "the surveyed caves whose widths and heights apply; usual: between them")
        .param("size", &SectionChoice::size,
               {.doc = "factor of widths and heights", .min = 0, .above_min = true})
        .param("variation", &SectionChoice::variation,
               {.doc = "how much they vary along the passages; 1: as in the surveyed caves",
                .min = 0,
                .max = 2});
  }

  network::SectionModel model() const {
    network::SectionModel chosen;
    for (const network::NamedSectionModel& each : network::section_models())
      if (like == each.name) chosen = each.model;
    chosen.width_median *= size;
    chosen.height_median *= size;
    chosen.width_spread *= variation;
    chosen.height_spread *= variation;
    return chosen;
  }
};

}  // namespace vug::shot
