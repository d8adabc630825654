// SPDX-License-Identifier: Apache-2.0
// Optional interfaces of nodes, found faster than by dynamic_cast.
#pragma once

#include <vug/field/node.h>

#include <array>
#include <cstddef>
#include <typeinfo>

namespace vug::field {

/// As dynamic_cast<const Interface*>(&node). The position of an interface in an object depends on
/// the type of the object alone, so each thread remembers it for the types it has met last.
template <class Interface>
const Interface* interface_of(const Node& node) {
  struct Known {
    const std::type_info* type = nullptr;
    std::ptrdiff_t offset = 0;
    bool has = false;
  };
  constexpr size_t kKnown = 64;
  thread_local std::array<Known, kKnown> all;
  const std::type_info* type = &typeid(node);
  Known& known = all[(reinterpret_cast<std::uintptr_t>(type) >> 4) % kKnown];
  const auto* start = reinterpret_cast<const std::byte*>(&node);
  if (known.type != type) {
    const auto* found = dynamic_cast<const Interface*>(&node);
    known = {type, found ? reinterpret_cast<const std::byte*>(found) - start : 0, found != nullptr};
  }
  return known.has ? reinterpret_cast<const Interface*>(start + known.offset) : nullptr;
}

}  // namespace vug::field
