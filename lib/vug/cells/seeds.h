// SPDX-License-Identifier: Apache-2.0
// Parameters and random choice of the cells from which a growth starts, and its response to
// moisture and light.
#pragma once

#include <vug/base/schema.h>
#include <vug/cells/pass.h>

namespace vug::cells {

/// Whether a cell is a seed, for a density of `seeds` per square metre.
inline bool is_seed(const Network& n, uint32_t cell, double seeds, RandomKey key) {
  return RandomStream(key.at(position_key(n.position[cell]))).uniform() <
         seeds * static_cast<double>(n.area[cell]);
}

/// Growth for an available amount `has` with the requirement `least`: 0 up to `least`, 1 at 1.
inline float growth_response(float has, double least) {
  const auto floor = static_cast<float>(least);
  return floor < 1 ? std::clamp((has - floor) / (1 - floor), 0.0f, 1.0f) : (has >= 1 ? 1.0f : 0.0f);
}

/// Parameters for seeds and the required moisture and light of the cells (1 if there is no such
/// attribute).
template <class P>
void describe_growth(Schema<P>& s) {
  const auto need = [](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::ratio, .min = 0, .max = 1};
  };
  s.param(
       "seeds", &P::seeds,
       {.doc = "seeds of the growth per square metre", .dimension = Dimension::per_area, .min = 0})
      .param("moisture", &P::moisture, need("moisture below which it does not grow; best at 100%"))
      .param("light", &P::light, need("light below which it does not grow; best at 100%"));
}

}  // namespace vug::cells
