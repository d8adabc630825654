// `grammar NAME: facade { ... }` of a scene: derived at once into rectangles and elements.
#pragma once

#include <vug/facade/tree.h>
#include <vug/session/reader.h>

#include <memory>

namespace vug::session {

/// What a facade's block may set beside its axiom and rules.
const KindInfo& facade_info();

/// The facade; nothing where the text has faults. Its derivation is added to the shot.
Value bind_facade(const scene::Grammar& grammar, Reading& reading);

}  // namespace vug::session

namespace vug {

template <>
struct ValueTraits<std::shared_ptr<const facade::Tree>>
    : ObjectTraits<std::shared_ptr<const facade::Tree>> {
  static constexpr const char* kWord = "facade";
};

}  // namespace vug
