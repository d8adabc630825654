// SPDX-License-Identifier: Apache-2.0
// A place that a grammar names as a point, e.g. for cameras and lights.
#include <vug/base/pluralize.h>
#include <vug/sgm/named_places.h>
#include <vug/shot/networks.h>

#include <fmt/format.h>

namespace vug::shot {
namespace {

struct Locator {
  field::Field of;
  std::string name;
  int index = 1;
  double up = 0;

  static void describe(Schema<Locator>& s) {
    s.doc("The middle of a shape that a grammar names with the clause 'name'.")
        .param("of", &Locator::of, {.doc = "the grammar", .required = true})
        .param("name", &Locator::name, {.doc = "the name", .required = true})
        .param("index", &Locator::index,
               {.doc = "1 for the first shape of that name, 2 for the second, ...", .min = 1})
        .param("up", &Locator::up, any_length("how far above the middle"));
  }
};

Vec3d locator_position(const Locator& p) {
  int found = 0;
  std::vector<std::string> names;
  for (const sgm::NamedPlace& place : sgm::places_of(p.of)) {
    names.push_back(place.name);
    if (place.name == p.name && ++found == p.index) return place.position + Vec3d(0, p.up, 0);
  }
  if (found > 0)
    throw Error(ErrorCode::bad_input,
                fmt::format("the grammar has only {} with the name '{}'",
                            pluralize(static_cast<size_t>(found), "shape"), p.name),
                {}, fmt::format("'index' is at most {}", found));
  throw Error(ErrorCode::bad_input,
              fmt::format("the solid has no shape with the name '{}'", p.name), {},
              names.empty() ? "'of' is a grammar whose items have a clause such as name \"hall\""
                            : suggestion(p.name, names));
}

}  // namespace
}  // namespace vug::shot

VUG_POINT_KIND(locator) { return make_kind<Vec3d, Locator>("locator", "point", locator_position); }
