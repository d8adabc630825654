// Automata that count: whether a cell lives on or is born depends on how many neighbours live.
#pragma once

#include <vug/cells/rule.h>

namespace vug::cells {

struct LifeLike {
  std::vector<int> birth;
  std::vector<int> survive;
  bool scale = false;

  std::string fault() const {
    for (const int count : birth)
      if (count < 1) return "a cell that nobody lives beside is not born";
    return "";
  }

  void step(Pass& pass) const {
    const auto alive = pass.writes<int32_t>("alive");
    // Bit k of each: whether a cell that is dead, or alive, will live beside k that live.
    const auto bits = [](const std::vector<int>& counts) {
      uint32_t set = 0;
      for (const int count : counts) set |= 1u << count;
      return set;
    };
    const uint32_t both = bits(birth) | bits(survive) << 16;
    if (scale) return pass.run(Scaled{{alive, both}});
    pass.run(Counted{alive, both});
  }

 private:
  struct Counted {
    AttributeWriter<int32_t> alive;
    uint32_t both;  ///< Bits for the dead, then, from 16 on, for the living.

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
  /// As if there were eight neighbours.
  struct Scaled : Counted {
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
             {.doc = "numbers of living neighbours with which a cell lives on", .min = 0, .max = 8})
      .param("scale", &P::scale, {.doc = "count as if every cell had eight neighbours"});
}

}  // namespace vug::cells
