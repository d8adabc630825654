// SPDX-License-Identifier: Apache-2.0
#include <vug/field/registry.h>

namespace vug::field {

#define VUG_KIND(name) const FieldKind& name##_kind();
#include <vug/field/deformers_kinds.inc>
#include <vug/field/detail_kinds.inc>
#include <vug/field/operators_kinds.inc>
#include <vug/field/primitives_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const BlendKind& name##_kind();
#include <vug/field/blends_kinds.inc>
#undef VUG_KIND

#define VUG_KIND(name) &name##_kind(),

const Kinds<Field>& primitives() {
  static const Kinds<Field> kinds = {
#include <vug/field/primitives_kinds.inc>
  };
  return kinds;
}

const Kinds<Field>& operators() {
  static const Kinds<Field> kinds = {
#include <vug/field/operators_kinds.inc>
  };
  return kinds;
}

const Kinds<Field>& deformers() {
  static const Kinds<Field> kinds = {
#include <vug/field/deformers_kinds.inc>
  };
  return kinds;
}

const Kinds<Field>& details() {
  static const Kinds<Field> kinds = {
#include <vug/field/detail_kinds.inc>
  };
  return kinds;
}

const Kinds<Blend>& blends() {
  static const Kinds<Blend> kinds = {
#include <vug/field/blends_kinds.inc>
  };
  return kinds;
}

#undef VUG_KIND

const Kinds<Field>& field_kinds() {
  static const Kinds<Field> kinds = [] {
    Kinds<Field> all = primitives();
    all.insert(all.end(), operators().begin(), operators().end());
    all.insert(all.end(), deformers().begin(), deformers().end());
    all.insert(all.end(), details().begin(), details().end());
    return all;
  }();
  return kinds;
}

Field make(const std::string& kind, const NamedValues& params) {
  return make_product(field_kinds(), kind, params);
}

}  // namespace vug::field
