// The kinds of places, and of models beside those that the text names.
#pragma once

#include <vug/building/instance_source.h>

namespace vug::loading {

/// What can be placed beside what the text names: made from the list in CMakeLists.txt.
const Kinds<shot::Model>& model_kinds();

/// Made from the list in CMakeLists.txt.
const Kinds<shot::InstanceSource>& instance_source_kinds();

using InstanceSourceKind = Kind<shot::InstanceSource>;

/// Opens the one function that the file of a kind of places exports.
#define VUG_INSTANCE_SOURCE_KIND(name) \
  VUG_EXPORT_KIND(vug::loading, InstanceSourceKind, name##_places)

/// Kinds whose parameter struct P has `static void describe(Schema<P>&)`; `make` is
/// std::vector<Place>(const P&, Builder&, RandomKey).
template <class P, class Make>
Kind<shot::InstanceSource> instance_source_kind(std::string name, Make make) {
  return make_kind<shot::InstanceSource, P>(
      std::move(name), "places", [make](const P& params) -> shot::InstanceSource {
        return std::make_shared<const building::InstanceFunction>(
            [params, make](building::Builder& builder, RandomKey key) {
              return make(params, builder, key);
            });
      });
}

}  // namespace vug::loading
