// SPDX-License-Identifier: Apache-2.0
// The parameters of networks that select the statistics of passage sizes.
#pragma once

#include <vug/base/schema.h>
#include <vug/network/section_statistics.h>

#include <string>
#include <utility>
#include <vector>

namespace vug::shot {

struct SectionChoice {
  int like = 0;  ///< 0: the defaults of SectionModel, else one of section_models(), from 1.
  double size = 1;
  double variation = 1;
  double least_width = 0, least_height = 0;

  /// Adds the parameters to the schema of a struct that is derived from this one.
  template <class P>
  static void describe(Schema<P>& s) {
    std::vector<std::pair<std::string, int>> names{{"usual", 0}};
    for (const network::NamedSectionModel& each : network::section_models())
      names.emplace_back(each.name, static_cast<int>(names.size()));
    s.choice("like", static_cast<int P::*>(&SectionChoice::like), std::move(names),
             "the surveyed caves whose widths and heights apply; usual: between them")
        .param("size", &SectionChoice::size,
               {.doc = "factor of widths and heights", .min = 0, .max = 50, .above_min = true})
        .param("variation", &SectionChoice::variation,
               {.doc = "how much they vary along the passages; 1: as in the surveyed caves",
                .min = 0,
                .max = 2})
        .param("least_width", &SectionChoice::least_width, least("width"))
        .param("least_height", &SectionChoice::least_height, least("height"));
  }

  static ParamSpec least(const std::string& size) {
    return {.doc = "the least " + size + " that is drawn, e.g. for passages that people can walk",
            .dimension = Dimension::length,
            .min = 0,
            .max = 100};
  }

  network::SectionModel model() const {
    network::SectionModel chosen;
    if (like > 0) chosen = network::section_models()[static_cast<size_t>(like - 1)].model;
    chosen.width_median *= size;
    chosen.height_median *= size;
    chosen.width_spread *= variation;
    chosen.height_spread *= variation;
    chosen.least_width = least_width;
    chosen.least_height = least_height;
    return chosen;
  }
};

}  // namespace vug::shot
