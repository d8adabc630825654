// SPDX-License-Identifier: Apache-2.0
// Where a stream enters the rock.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct Sink {
  Vec3d at{0, 0, 0};
  double discharge = 1;
  std::string name;

  static void describe(Schema<Sink>& s) {
    s.doc("Where a stream enters the rock.")
        .param("at", &Sink::at, position())
        .param("discharge", &Sink::discharge,
               {.doc = "amount of water in relation to other sinks", .min = 0, .above_min = true})
        .param("name", &Sink::name, {.doc = "name of its station"});
  }
  void add(karst::Geology& geology) const {
    geology.sinks.push_back({.position = at, .discharge = discharge, .name = name});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(sink) { return geology_kind<Sink>("sink"); }
