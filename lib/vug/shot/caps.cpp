// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/registry.h>
#include <vug/shot/caps.h>

#include <algorithm>
#include <iterator>

namespace vug::shot {

field::Field with_caps(const field::Field& field, const Caps& caps, const Box3d& box,
                       double thickness) {
  std::vector<field::Field> parts = {field};
  for (size_t face = 0; face < caps.closed.size(); ++face) {
    if (!caps.closed[face]) continue;
    const auto axis = static_cast<int>(face / 2);
    const bool high = face % 2 == 1;
    Vec3d inwards(0);
    inwards[axis] = high ? -1 : 1;
    const double offset = (high ? -box.max[axis] : box.min[axis]) + thickness;
    parts.push_back(field::make("half_space", {{"normal", inwards}, {"offset", offset}}));
  }
  return field::unite(std::move(parts));
}

}  // namespace vug::shot

namespace vug {
namespace {

constexpr const char* kFaces[] = {"-X", "+X", "-Y", "+Y", "-Z", "+Z"};

}  // namespace

std::optional<shot::Caps> ValueTraits<shot::Caps>::read(const Value& v) {
  const auto* list = v.get<List>();
  shot::Caps caps;
  for (const Value& each : list ? *list : List{v}) {
    const auto* name = each.get<Value::Name>();
    if (!name) return std::nullopt;
    const auto* const face = std::find(std::begin(kFaces), std::end(kFaces), name->text);
    if (face == std::end(kFaces)) return std::nullopt;
    caps.closed[static_cast<size_t>(face - kFaces)] = true;
  }
  return caps;
}

Value ValueTraits<shot::Caps>::write(const shot::Caps& caps) {
  List faces;
  for (size_t i = 0; i < caps.closed.size(); ++i)
    if (caps.closed[i]) faces.emplace_back(Value::Name{kFaces[i]});
  return faces;
}

}  // namespace vug
