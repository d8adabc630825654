// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/carve.h>
#include <vug/facade/element.h>
#include <vug/facade/split.h>

namespace vug::facade {

#define VUG_KIND(name) const SplitKind& name##_split();
#include <vug/facade/splits_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const ElementKind& name##_element();
#include <vug/facade/elements_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const SolidKind& name##_solid();
#include <vug/facade/solids_kinds.inc>
#undef VUG_KIND

const Kinds<SplitPtr>& splits() {
#define VUG_KIND(name) &name##_split(),
  static const Kinds<SplitPtr> kinds = {
#include <vug/facade/splits_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

const Kinds<ElementPtr>& elements() {
#define VUG_KIND(name) &name##_element(),
  static const Kinds<ElementPtr> kinds = {
#include <vug/facade/elements_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

const Kinds<field::Field>& solids() {
#define VUG_KIND(name) &name##_solid(),
  static const Kinds<field::Field> kinds = {
#include <vug/facade/solids_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

Value as_sizes(const Value& value) {
  if (const Number* number = value.get<Number>()) return ValueTraits<Size>::write({*number});
  const List* list = value.get<List>();
  if (!list) return value;
  List out;
  for (const Value& each : *list) out.push_back(as_sizes(each));
  return out;
}

}  // namespace vug::facade
