// SPDX-License-Identifier: Apache-2.0
// Three decorated chambers, with the numbers of the styles show_cave, pristine and dry.
#pragma once

#include <vug/drips/dripstone.h>

#include "rooms.h"

namespace vug::drips {

struct Style {
  const char* name;
  double spacing, density, age, interval, broken, films, straws, voxel;
};

inline constexpr Style kStyles[] = {
    {"show_cave", 0.25, 0.6, 20000, 110, 0.06, 0.6, 0.25, 0.02},
    {"pristine", 0.16, 0.9, 9000, 180, 0, 0.9, 0.55, 0.01},
    {"dry", 0.4, 0.2, 30000, 400, 0.45, 0.25, 0, 0.02},
};

inline DripstoneOptions options_of(const Style& style) {
  DripstoneOptions o;
  // Sparse drips need a larger chamber for statistics.
  const double half = style.density < 0.5 ? 10 : 4;
  o.graph = graph_options(half);
  o.graph.spacing = style.spacing;
  o.graph.density = style.density;
  o.graph.oldest = style.age;
  o.graph.interval = style.interval;
  o.graph.straws = style.straws;
  o.graph.planes = joints();
  o.forms = {
      .tip = 0.75 * style.voxel, .broken = style.broken, .age = style.age, .final_age = style.age};
  o.draperies = {.share = style.films, .tip = o.forms.tip, .floor = -3};
  o.flowstone = {.share = style.films};
  return o;
}

/// Their rock.
inline field::Field rock_of(const DripstoneOptions& o) {
  return cave(2.2 * o.graph.to.x, 0.12, 2.2 * o.graph.to.x);
}

}  // namespace vug::drips
