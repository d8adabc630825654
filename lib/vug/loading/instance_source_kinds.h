// SPDX-License-Identifier: Apache-2.0
// The kinds of instance sources and of models.
#pragma once

#include <vug/building/instance_source.h>

namespace vug::loading {

/// The kinds of models other than names of objects, as listed in CMakeLists.txt.
const Kinds<shot::Model>& model_kinds();

/// The kinds of instance sources, as listed in CMakeLists.txt.
const Kinds<shot::InstanceSource>& instance_source_kinds();

using InstanceSourceKind = Kind<shot::InstanceSource>;

/// Begins the definition of the function that the source of such a kind exports.
#define VUG_INSTANCE_SOURCE_KIND(name) \
  VUG_EXPORT_KIND(vug::loading, InstanceSourceKind, name##_places)

/// A kind whose parameter struct P has `static void describe(Schema<P>&)`; `make` is
/// std::vector<building::Instance>(const P&, building::Builder&, RandomKey).
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
