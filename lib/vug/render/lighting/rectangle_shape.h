// SPDX-License-Identifier: Apache-2.0
// Rectangles as seen from a point: the shape of rectangle lights and portals.
#pragma once

#include <vug/base/schema.h>
#include <vug/base/vec.h>
#include <vug/render/light.h>

#include <optional>
#include <string>

namespace vug::render {

/// Position and orientation of a rectangle. `up` turns it about its normal: the first side is along
/// up x normal, the second along normal x (up x normal).
struct RectangleParams {
  Vec3d center{0, 0, 0};
  Vec3d normal{0, -1, 0};
  std::optional<Vec3d> up;  ///< Default: z, or x if z is the normal.
  double width = 1;
  double height = 1;

  std::string fault() const;  ///< Empty, or an error message.
};

/// Adds the parameters of a kind P that derives from RectangleParams.
template <class P>
void describe_rectangle(Schema<P>& s, const std::string& normal_doc) {
  s.param("center", &RectangleParams::center, any_length("Centre."))
      .param("normal", &RectangleParams::normal, {.doc = normal_doc})
      .param("up", &RectangleParams::up, {.doc = "Direction of the height; z when not given."})
      .param("width", &RectangleParams::width,
             positive_length("Length perpendicular to the up direction."))
      .param("height", &RectangleParams::height, positive_length("Length along the up direction."));
}

/// Visible from the front only, the side that the normal points to. Sampled by solid angle nearby
/// (Urena, Fajardo, King 2013, "An area-preserving parametrization for spherical rectangles", cite
/// urena2013rectangle) and by area from afar, where area sampling is as good and cheaper.
class RectangleShape {
 public:
  explicit RectangleShape(const RectangleParams& p);

  /// Sets direction, distance and pdf; leaves radiance unchanged. The pdf is 0 behind the
  /// rectangle.
  LightSample sample(const Vec3f& point, const Vec2f& u) const;
  float pdf(const Vec3f& point, const Vec3f& direction) const;
  /// Distance at which the ray hits the front; 0 without a hit.
  float hit(const Ray& ray) const;

  /// Approximately the projected area over squared distance: never 0 where the rectangle can light
  /// a point, exactly 0 behind it and below the point's horizon.
  float importance(const LightSampleContext& point) const;
  float importance_along(const Ray& ray, float begin, float end) const;

  LightBounds bounds(float luminance) const;
  void export_to(exchange::Light& light) const;
  const Vec3f& center() const { return center_; }
  float area() const { return width_ * height_; }
  /// Distance from the centre to the vertices.
  float radius() const { return std::sqrt(radius_squared()); }

 private:
  float radius_squared() const { return 0.25f * (width_ * width_ + height_ * height_); }
  struct View;  ///< The rectangle in its local coordinates around a point.
  bool is_far(const Vec3f& to_center) const;

  Vec3f center_, normal_, x_, y_;
  float width_, height_;
  Vec3f half_x_, half_y_;  ///< From the centre to the edges.
};

}  // namespace vug::render
