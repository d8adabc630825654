// SPDX-License-Identifier: Apache-2.0
// The materials of rock at a point: up to four names with weights whose sum is 1.
#pragma once

#include <vug/field/point.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace vug::field {

/// A material of rock, sediment or dripstone. Two materials are the same if their names are.
struct RockMaterial {
  std::string name;     ///< "limestone": letters, digits and "_"; see name_fault.
  double hardness = 0;  ///< From 0, which yields to every process, to 1, which resists them all.
};
using RockMaterialPtr = std::shared_ptr<const RockMaterial>;

/// Describes a name that files cannot contain; empty if the name is valid.
std::string name_fault(const RockMaterial& material);

/// Weights of materials. Refers to materials that the nodes of a field own.
class MaterialMix {
 public:
  /// Most materials at one point. Beyond it, the largest weights are kept and divided by their sum.
  static constexpr size_t kMost = 4;
  struct Part {
    const RockMaterial* material = nullptr;
    double weight = 0;
  };

  /// Without a material: unknown, which any known mix replaces.
  MaterialMix() = default;
  explicit MaterialMix(const RockMaterial& material) : parts_{Part{&material, 1}}, count_(1) {}

  /// Parts with weights above 0, ordered by name.
  std::span<const Part> parts() const { return {parts_.data(), count_}; }
  bool empty() const { return count_ == 0; }
  /// 0 for other materials.
  double weight(std::string_view name) const;
  /// The material with the largest weight, of equal ones the first by name; null without materials.
  const RockMaterial* dominant() const;
  /// The mean hardness by weight, 0..1; 0 without materials.
  double hardness() const;

  /// (1 - share) a + share b, share in 0..1. If one of them is empty, the result is the other one.
  friend MaterialMix mixed(const MaterialMix& a, const MaterialMix& b, double share);

 private:
  std::array<Part, kMost> parts_{};
  size_t count_ = 0;
};
MaterialMix mixed(const MaterialMix& a, const MaterialMix& b, double share);

/// Smoothstep across a contact: 1 from width/2 inside a body, 1/2 on its surface, 0 from width/2
/// outside. Its slope is at most 1.5 / width per unit of the distance; without a width it is a
/// step.
template <class T>
T share_inside(const T& distance, double width) {
  if (!(width > 0)) return select(distance < T(0.0), T(1.0), T(0.0));
  const T t = clamp(T(0.5) - distance * T(1 / width), T(0.0), T(1.0));
  return square(t) * (T(3.0) - t * T(2.0));
}
constexpr double kContactSlope = 1.5;

}  // namespace vug::field
