// SPDX-License-Identifier: Apache-2.0
// A part of the rock through which water flows easily.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct Permeable {
  Vec3d at{0, 0, 0};
  double radius = 30;
  double strength = 1;

  static void describe(Schema<Permeable>& s) {
    s.doc("A ball of rock through which water flows easily, or, with a negative strength, poorly.")
        .param("at", &Permeable::at, any_length("its centre"))
        .param("radius", &Permeable::radius, positive_length("its radius"))
        .param("strength", &Permeable::strength,
               {.doc = "1: all passages lead there; -1: none", .min = -1, .max = 1});
  }
  void add(karst::Geology& geology) const {
    geology.permeable.push_back({.center = at, .radius = radius, .strength = strength});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(permeable) { return geology_kind<Permeable>("permeable"); }
