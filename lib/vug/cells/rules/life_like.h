// SPDX-License-Identifier: Apache-2.0
// Life-like automata: the number of living neighbours determines whether a cell survives or is
// born.
#pragma once

#include <vug/cells/rule.h>

namespace vug::cells {

struct LifeLike {
  std::vector<int> birth;
  std::vector<int> survive;
  bool scale = false;

  std::string fault() const {
    for (const int count : birth)
      if (count < 1) return "a cell without living neighbours cannot be born";
    return "";
  }

  void step(Pass& pass) const {
    const auto alive = pass.writes<int32_t>("alive");
    // Bit k: whether a dead cell, or a living one, will live with k living neighbours.
    const auto bits = [](const std::vector<int>& counts) {
      uint32_t set = 0;
      for (const int count : counts) set |= 1u << count;
      return set;
    };
    const uint32_t both = bits(birth) | bits(survive) << 16;
    if (scale) return pass.run(ScaledCountRule{{alive, both}});
    pass.run(CountRule{alive, both});
  }

 private:
  struct CountRule {
    AttributeWriter<int32_t> alive;
    uint32_t both;  ///< Bits 0 to 15 for dead cells, from 16 on for living cells.

    void set(uint32_t i, uint32_t living) const {
      const uint32_t own = static_cast<uint32_t>(alive[i] & 1) << 4;
      alive.set(i, static_cast<int32_t>(both >> (own + living) & 1));
    }
    template <class Neighbourhood>
    uint32_t count(const Neighbourhood& neighbours, uint32_t i, uint32_t& living) const {
      return neighbours.each(i, [&](uint32_t n) {
        living += static_cast<uint32_t>(alive[n] & 1);
        one_by_one(living);
      });
    }
    template <class Neighbourhood>
    void operator()(const Neighbourhood& neighbours, uint32_t i) const {
      uint32_t living = 0;
      count(neighbours, i, living);
      set(i, living);
    }
  };
  /// Scales the count to eight neighbours.
  struct ScaledCountRule : CountRule {
    template <class Neighbourhood>
    void operator()(const Neighbourhood& neighbours, uint32_t i) const {
      uint32_t living = 0;
      const uint32_t k = this->count(neighbours, i, living);
      this->set(i, k > 0 ? (8 * living + k / 2) / k : 0);
    }
  };
};

template <class P>
void describe_life(Schema<P>& s) {
  s.param("birth", &P::birth,
          {.doc = "numbers of living neighbours with which a cell is born", .min = 0, .max = 8})
      .param("survive", &P::survive,
             {.doc = "numbers of living neighbours with which a cell survives", .min = 0, .max = 8})
      .param("scale", &P::scale, {.doc = "count as if every cell had eight neighbours"});
}

}  // namespace vug::cells
