// SPDX-License-Identifier: Apache-2.0
// Interface of procedural masks and paints: functions of position, normal, fields and attributes,
// without UVs. A mask returns a number between 0 and 1, a paint a linear Rec.709 colour (an
// albedo).
#pragma once

#include <vug/base/error.h>
#include <vug/base/transform.h>
#include <vug/field/sampled.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vug::paint {

/// Mesh attributes at one point.
class Attributes {
 public:
  virtual ~Attributes() = default;
  /// The attribute's value; a scalar is returned as three equal numbers. Empty if the attribute
  /// does not exist.
  virtual std::optional<Vec3d> read(std::string_view name) const = 0;
};

/// A point on a surface; the normal has unit length and points out of the solid.
struct EvalPoint {
  Vec3d position;
  Vec3d normal;
  const field::SampledGrid* solid = nullptr;  ///< Level set of the surface, if known.
  const Transform* to_solid =
      nullptr;  ///< From this space to that of `solid`; null if they are the same.
  const Attributes* attributes = nullptr;  ///< The attributes of the mesh, if known.
  double footprint = 0;  ///< Width in metres of the sampled area; finer detail may be left out.
  const EvalPoint* in_scene =
      nullptr;  ///< The point in the space of the scene; null if this space is the same.
};

/// An attribute that a mask or a paint reads, and where the text names it.
struct AttributeUse {
  std::string attribute;
  SourceLocation where;
};
/// The attributes that masks and paints read, and whether they depend on the position of an
/// instance.
struct AttributeUses : std::vector<AttributeUse> {
  using vector::vector;
  bool refers_to_scene = false;

  void add(const AttributeUses& more) {
    insert(end(), more.begin(), more.end());
    refers_to_scene = refers_to_scene || more.refers_to_scene;
  }
};

/// A function of an EvalPoint, with the attributes that it reads. Immutable, shared between
/// threads.
template <class T>
class SurfaceFunction {
 public:
  SurfaceFunction(std::function<T(const EvalPoint&)> evaluate, AttributeUses uses)
      : evaluate_(std::move(evaluate)), uses_(std::move(uses)) {}
  T operator()(const EvalPoint& point) const { return evaluate_(point); }
  const AttributeUses& uses() const { return uses_; }

 private:
  std::function<T(const EvalPoint&)> evaluate_;
  AttributeUses uses_;
};
using Mask = std::shared_ptr<const SurfaceFunction<double>>;
using Paint = std::shared_ptr<const SurfaceFunction<Vec3d>>;

/// `uses` are those of the masks and paints that f evaluates: see attribute_uses.
template <class F>
Mask make_mask(F&& f, AttributeUses uses = {}) {
  return std::make_shared<const SurfaceFunction<double>>(std::forward<F>(f), std::move(uses));
}
template <class F>
Paint make_paint(F&& f, AttributeUses uses = {}) {
  return std::make_shared<const SurfaceFunction<Vec3d>>(std::forward<F>(f), std::move(uses));
}

/// The attributes that these masks or paints read, concatenated; null ones are skipped.
template <class T>
AttributeUses attribute_uses(const std::vector<std::shared_ptr<const SurfaceFunction<T>>>& parts) {
  AttributeUses all;
  for (const auto& part : parts)
    if (part) all.add(part->uses());
  return all;
}
AttributeUses attribute_uses(const Mask& mask, const Paint& a, const Paint& b = nullptr);

/// Smoothstep: 0 up to `from`, 1 from `to` on; descending if from > to.
double ramp(double x, double from, double to);

/// The paint at each point, evaluated in parallel. Values are clamped to 0..1.
std::vector<Vec3f> colors(const Paint& paint, const std::vector<EvalPoint>& points);

}  // namespace vug::paint
