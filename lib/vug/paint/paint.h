// Colours of surfaces from where they are: position, normal and fields, without UVs.
// A mask gives a number between 0 and 1, a paint a linear Rec.709 colour (an albedo).
#pragma once

#include <vug/base/transform.h>
#include <vug/field/sampled.h>

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace vug::paint {

/// The numbers that a mesh carries, at one place on it.
class Attributes {
 public:
  virtual ~Attributes() = default;
  /// A number as three equal ones; nothing when there is no attribute of that name.
  virtual std::optional<Vec3d> read(std::string_view name) const = 0;
};

/// A place on a surface; the normal has unit length and points out of the solid.
struct Spot {
  Vec3d position;
  Vec3d normal;
  const field::SampledGrid* solid = nullptr;  ///< The level set whose surface it is, if known.
  const Transform* to_solid = nullptr;        ///< From here to its space; null: the same.
  const Attributes* attributes = nullptr;     ///< Of the mesh, if known.
  double footprint = 0;  ///< Metres across which one look takes in: finer detail may be left out.
};

/// Immutable functions, shared between threads.
using Mask = std::shared_ptr<const std::function<double(const Spot&)>>;
using Paint = std::shared_ptr<const std::function<Vec3d(const Spot&)>>;

template <class F>
Mask make_mask(F&& f) {
  return std::make_shared<const std::function<double(const Spot&)>>(std::forward<F>(f));
}
template <class F>
Paint make_paint(F&& f) {
  return std::make_shared<const std::function<Vec3d(const Spot&)>>(std::forward<F>(f));
}

/// 0 up to `from`, 1 from `to` on, a smooth step between; from > to runs the other way.
double ramp(double x, double from, double to);

/// The paint at each spot; parallel. Values are clamped to 0..1.
std::vector<Vec3f> colors(const Paint& paint, const std::vector<Spot>& spots);

}  // namespace vug::paint
