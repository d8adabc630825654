// Where growth begins: some cells a square metre, chosen by chance, the same for any spacing of
// cells.
#pragma once

#include <vug/base/schema.h>
#include <vug/cells/pass.h>

namespace vug::cells {

/// Whether a cell is one of `seeds` a square metre.
inline bool is_seed(const Network& n, uint32_t cell, double seeds, RandomKey key) {
  return RandomStream(key.at(position_key(n.position[cell]))).uniform() <
         seeds * static_cast<double>(n.area[cell]);
}

/// How well something grows that needs `least` of what a cell has: 0 up to there, 1 at 1.
inline float growth_response(float has, double least) {
  const auto floor = static_cast<float>(least);
  return floor < 1 ? std::clamp((has - floor) / (1 - floor), 0.0f, 1.0f) : (has >= 1 ? 1.0f : 0.0f);
}

/// Seeds and what plants need of the cells' moisture and light (1 where nobody says).
template <class P>
void describe_growth(Schema<P>& s) {
  const auto need = [](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::ratio, .min = 0, .max = 1};
  };
  s.param("seeds", &P::seeds, {.doc = "from which it grows, on a square metre", .min = 0})
      .param("moisture", &P::moisture, need("with which it does not grow yet; best with 100%"))
      .param("light", &P::light, need("with which it does not grow yet; best with 100%"));
}

}  // namespace vug::cells
