// Inputs of materials: numbers and colours that are the same everywhere, or vary with the place as
// masks and paints do.
#pragma once

#include <vug/paint/kind.h>
#include <vug/render/material.h>

namespace vug::render {

/// The place of a hit as masks and paints see it; refers to the surface.
class SurfacePoint final : private paint::Attributes {
 public:
  explicit SurfacePoint(const Surface& surface);
  const paint::EvalPoint& eval_point() const { return point_; }
  /// Another place of the scene, near by: the spot moves there. Its normal stays; attributes go on
  /// as they slope where it was.
  void move_to(const Vec3f& point);

 private:
  std::optional<Vec3d> read(std::string_view name) const override;

  const Surface& surface_;
  paint::EvalPoint point_;
  std::optional<Transform> own_;  ///< Of an instance: from the scene to the mesh's own space.
  std::optional<Vec3d> moved_;    ///< How far it has been moved, in that space.
};

/// A number, or a mask that leads to one. What is read is kept within `low` and `high`, the
/// bounds that constants are held to by the schema.
struct NumberInput {
  double constant = 0;
  paint::Mask varying;

  NumberInput(double number) : constant(number) {}  // NOLINT
  explicit NumberInput(paint::Mask mask) : varying(std::move(mask)) {}
  float at(const paint::EvalPoint& point, float low = 0, float high = 1) const;
};

/// A linear Rec.709 colour, or a paint; within 0..1.
struct ColorInput {
  Vec3d constant{0, 0, 0};
  paint::Paint varying;
  image::ColourMatrix way;  ///< To the space that light is computed in.

  ColorInput(const Vec3d& color) : constant(color) {}  // NOLINT
  explicit ColorInput(paint::Paint paint) : varying(std::move(paint)) {}
  /// In the working space; `times` is a Rec.709 colour, such as the vertex colour.
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
