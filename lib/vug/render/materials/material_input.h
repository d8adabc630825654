// SPDX-License-Identifier: Apache-2.0
// Inputs of materials: numbers and colours that are constant or vary over the surface by masks and
// paints.
#pragma once

#include <vug/paint/kind.h>
#include <vug/render/material.h>

namespace vug::render {

/// The hit point in the form that masks and paints evaluate; refers to the surface.
class SurfacePoint final : private paint::Attributes {
 public:
  explicit SurfacePoint(const Surface& surface);
  const paint::EvalPoint& eval_point() const { return point_; }
  /// Moves the evaluation point to another point near by. Its normal stays; attributes are
  /// extrapolated by their gradients at the original point.
  void move_to(const Vec3f& point);

 private:
  std::optional<Vec3d> read(std::string_view name) const override;

  const Surface& surface_;
  paint::EvalPoint point_;
  std::optional<Transform> own_;  ///< For an instance: from the scene to the mesh's own space.
  std::optional<Vec3d> moved_;    ///< Displacement of the point, in that space.
  paint::EvalPoint in_scene_;     ///< The point before its transformation to that space.
};

/// A number, or a mask that drives it. Values are clamped to `low` and `high`, the bounds that the
/// schema sets for constants.
struct NumberInput {
  double constant = 0;
  paint::Mask varying;

  NumberInput(double number) : constant(number) {}  // NOLINT
  explicit NumberInput(paint::Mask mask) : varying(std::move(mask)) {}
  bool refers_to_scene() const { return varying && varying->uses().refers_to_scene; }
  float at(const paint::EvalPoint& point, float low = 0, float high = 1) const;
};

/// A linear Rec.709 colour, or a paint; within 0..1.
struct ColorInput {
  Vec3d constant{0, 0, 0};
  paint::Paint varying;
  image::ColourMatrix from_rec709;  ///< To the rendering colour space.

  ColorInput(const Vec3d& color) : constant(color) {}  // NOLINT
  explicit ColorInput(paint::Paint paint) : varying(std::move(paint)) {}
  bool refers_to_scene() const { return varying && varying->uses().refers_to_scene; }
  /// In the rendering colour space; `times` is a Rec.709 colour, such as the vertex colour.
  Rgb at(const paint::EvalPoint& point, const Rgb& times = Rgb(1.0f)) const;
};

}  // namespace vug::render

namespace vug {

template <>
struct ValueTraits<render::NumberInput> {
  static std::string type() { return "number or mask"; }
  static std::optional<render::NumberInput> read(const Value& v);
  static Value write(const render::NumberInput& input);
};

template <>
struct ValueTraits<render::ColorInput> {
  static std::string type() { return "colour or paint"; }
  static std::optional<render::ColorInput> read(const Value& v);
  static Value write(const render::ColorInput& input);
};

}  // namespace vug
