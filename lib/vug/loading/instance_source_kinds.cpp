// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/instance_source_kinds.h>

namespace vug::loading {

#define VUG_KIND(name) const Kind<shot::InstanceSource>& name##_places();
#include <vug/loading/places_kinds.inc>
#undef VUG_KIND

const Kinds<shot::InstanceSource>& instance_source_kinds() {
#define VUG_KIND(name) &name##_places(),
  static const Kinds<shot::InstanceSource> kinds = {
#include <vug/loading/places_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

#define VUG_KIND(name) const Kind<shot::Model>& name##_model();
#include <vug/loading/models_kinds.inc>
#undef VUG_KIND

const Kinds<shot::Model>& model_kinds() {
#define VUG_KIND(name) &name##_model(),
  static const Kinds<shot::Model> kinds = {
#include <vug/loading/models_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

}  // namespace vug::loading
