#include <vug/session/place_kinds.h>

namespace vug::session {

#define VUG_KIND(name) const Kind<Places>& name##_places();
#include <vug/session/places_kinds.inc>
#undef VUG_KIND

const Kinds<Places>& places_kinds() {
#define VUG_KIND(name) &name##_places(),
  static const Kinds<Places> kinds = {
#include <vug/session/places_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

#define VUG_KIND(name) const Kind<Model>& name##_model();
#include <vug/session/models_kinds.inc>
#undef VUG_KIND

const Kinds<Model>& model_kinds() {
#define VUG_KIND(name) &name##_model(),
  static const Kinds<Model> kinds = {
#include <vug/session/models_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

}  // namespace vug::session
