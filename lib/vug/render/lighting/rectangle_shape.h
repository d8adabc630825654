// A rectangle as seen from a point: the shape that rectangle lamps and portals share.
#pragma once

#include <vug/base/schema.h>
#include <vug/base/vec.h>
#include <vug/render/light.h>

#include <optional>
#include <string>

namespace vug::render {

/// Where a rectangle stands. `up` turns it about its normal: the first side lies along
/// up x normal, the second along normal x (up x normal).
struct RectangleParams {
  Vec3d center{0, 0, 0};
  Vec3d normal{0, -1, 0};
  std::optional<Vec3d> up;  ///< Else z, or x where that is the normal.
  double width = 1;
  double height = 1;

  std::string fault() const;  ///< Empty, or a sentence on what is wrong.
};

/// The parameters of a kind P that derives from RectangleParams.
template <class P>
void describe_rectangle(Schema<P>& s, const std::string& shines) {
  s.param("center", &RectangleParams::center, any_length("Its middle."))
      .param("normal", &RectangleParams::normal, {.doc = shines})
      .param("up", &RectangleParams::up,
             {.doc = "Turns the sides: the height runs this way; without, z."})
      .param("width", &RectangleParams::width, positive_length("Length across the up direction."))
      .param("height", &RectangleParams::height, positive_length("Length along the up direction."));
}

/// Seen from its front only, the side the normal points to. Nearby it is sampled by solid angle
/// (Urena, Fajardo, King 2013, "An area-preserving parametrization for spherical rectangles",
/// cite urena2013rectangle), from afar by area, which is as good there and cheaper.
class RectangleShape {
 public:
  explicit RectangleShape(const RectangleParams& p);

  /// Direction, distance and pdf; radiance is left alone. Zero pdf behind the rectangle.
  LightSample sample(const Vec3f& point, const Vec2f& u) const;
  float pdf(const Vec3f& point, const Vec3f& direction) const;
  /// Distance at which the ray passes through from the front, 0 when it does not.
  float hit(const Ray& ray) const;

  /// Projected area over squared distance, about: never 0 where the rectangle can light a point,
  /// exactly 0 behind it and below the point's horizon.
  float importance(const LightSampleContext& point) const;
  float importance_along(const Ray& ray, float begin, float end) const;

  LightBounds bounds(float luminance) const;
  void export_to(exchange::Light& light) const;
  const Vec3f& center() const { return center_; }
  float area() const { return width_ * height_; }
  /// To its corners.
  float radius() const { return std::sqrt(radius_squared()); }

 private:
  float radius_squared() const { return 0.25f * (width_ * width_ + height_ * height_); }
  struct View;  ///< The rectangle in coordinates of its own around a point.
  bool is_far(const Vec3f& to_center) const;

  Vec3f center_, normal_, x_, y_;
  float width_, height_;
  Vec3f half_x_, half_y_;  ///< From its middle to its edges.
};

}  // namespace vug::render
