// SPDX-License-Identifier: Apache-2.0
// Changes of the drips of a cave in the text of a scene: drips that are added, moved or removed.
#pragma once

#include <vug/base/kind.h>
#include <vug/drips/edits.h>

#include <functional>
#include <memory>

namespace vug::shot {

/// Adds one change to a list.
using DripEdit = std::function<void(drips::DripEdits&)>;
using DripEditPtr = std::shared_ptr<const DripEdit>;

/// The kinds listed in CMakeLists.txt.
const Kinds<DripEditPtr>& drip_edit_kinds();
using DripEditKind = Kind<DripEditPtr>;

/// A kind whose parameter struct P has `static void describe(Schema<P>&)` and
/// `void add(drips::DripEdits&, const SourceLocation&) const`, which keeps the place of the call.
template <class P>
DripEditKind drip_edit_kind(std::string name) {
  Schema<P> schema(std::move(name), "drip edit");
  P::describe(schema);
  KindInfo info = schema.info();
  return {std::move(info),
          [schema = std::move(schema)](const Arguments& arguments, const SourceLocation& where,
                                       Diagnostics& diagnostics) -> std::optional<DripEditPtr> {
            const std::optional<P> params = schema.bind(arguments, where, diagnostics);
            if (!params) return std::nullopt;
            return std::make_shared<const DripEdit>(
                [params = *params, where](drips::DripEdits& edits) { params.add(edits, where); });
          }};
}

/// Begins the definition of the function that the source of such a kind exports.
#define VUG_DRIP_EDIT_KIND(name) VUG_EXPORT_KIND(vug::shot, DripEditKind, name##_drip_edit)

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::DripEditPtr> : ObjectTraits<shot::DripEditPtr> {
  static constexpr const char* kWord = "drip edit";
};

}  // namespace vug
