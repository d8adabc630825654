// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/exchange/light.h>
#include <vug/render/lighting/rectangle_shape.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

/// Unit vectors with a shorter cross product count as parallel.
constexpr double kParallel = 1e-6;

}  // namespace

std::string RectangleParams::fault() const {
  if (!is_direction(normal)) return "the rectangle's normal must be finite and not zero";
  if (!up) return "";
  if (!is_direction(*up)) return "the rectangle's up must be finite and not zero";
  return up->normalized().cross(normal.normalized()).length() < kParallel
             ? "the rectangle's up is parallel to its normal"
             : "";
}

RectangleShape::RectangleShape(const RectangleParams& p)
    : center_(p.center),
      width_(static_cast<float>(p.width)),
      height_(static_cast<float>(p.height)) {
  const Vec3d z = p.normal.normalized();
  const Vec3d up = p.up.value_or(Vec3d(0, 0, 1));
  Vec3d x = up.cross(z);
  if (x.length() < kParallel * up.length() || !(up.length() > 0)) {
    x = Vec3d(1, 0, 0).cross(z);
    if (x.length() < kParallel) x = Vec3d(0, 1, 0).cross(z);
  }
  x.normalize();
  normal_ = Vec3f(z);
  x_ = Vec3f(x);
  y_ = Vec3f(z.cross(x));
  half_x_ = x_ * (0.5f * width_), half_y_ = y_ * (0.5f * height_);
}

/// True where 1 / distance^2 varies by at most a half over the rectangle: its centre is at least
/// eight times as far as the rectangle is deep along that direction, and at least 1.5 diagonals
/// away.
bool RectangleShape::is_far(const Vec3f& to_center) const {
  const float squared = dot(to_center, to_center);
  const float depth = std::fabs(dot(half_x_, to_center)) + std::fabs(dot(half_y_, to_center));
  return 8 * depth < squared && squared > 9 * radius_squared();
}

/// Vertex (x0, y0, z), opposite vertex (x1, y1, z) with z < 0, and the angles of the spherical
/// rectangle; names as in the paper.
struct RectangleShape::View {
  double x0, x1, y0, y1, z, b0, b1, k, solid_angle;

  View(const RectangleShape& r, const Vec3f& to_center) {
    const auto cx = static_cast<double>(dot(to_center, r.x_));
    const auto cy = static_cast<double>(dot(to_center, r.y_));
    z = -std::fabs(static_cast<double>(dot(to_center, r.normal_)));
    const double hx = 0.5 * static_cast<double>(r.width_),
                 hy = 0.5 * static_cast<double>(r.height_);
    x0 = cx - hx, x1 = cx + hx, y0 = cy - hy, y1 = cy + hy;
    const double zz = z * z;
    b0 = -y0 / std::sqrt(y0 * y0 + zz);
    const double n1 = x1 / std::sqrt(x1 * x1 + zz);
    b1 = y1 / std::sqrt(y1 * y1 + zz);
    const double n3 = -x0 / std::sqrt(x0 * x0 + zz);
    const double g0 = maths::acos(-b0 * n1), g1 = maths::acos(-n1 * b1), g2 = maths::acos(-b1 * n3),
                 g3 = maths::acos(-n3 * b0);
    k = 2 * kPi - g2 - g3;
    solid_angle = g0 + g1 - k;
  }
  /// False for a sliver too thin for the difference of angles to be meaningful.
  bool usable() const { return z < 0 && solid_angle > 1e-9; }
};

LightSample RectangleShape::sample(const Vec3f& point, const Vec2f& u) const {
  LightSample out;
  const Vec3f to_center = center_ - point;
  if (!(dot(to_center, normal_) < 0)) return out;
  Vec3f to = to_center;
  const bool far = is_far(to_center);
  if (far) {
    to += x_ * ((u.x - 0.5f) * width_) + y_ * ((u.y - 0.5f) * height_);
  } else {
    const View v(*this, to_center);
    if (!v.usable()) return out;
    const double au = static_cast<double>(u.x) * v.solid_angle + v.k;
    const double sine = maths::sin(au);
    const double fu = (maths::cos(au) * v.b0 - v.b1) / sine;
    const double cu =
        std::clamp(std::copysign(1.0, fu) / std::sqrt(fu * fu + v.b0 * v.b0), -1.0, 1.0);
    const double x = std::clamp(-(cu * v.z) / std::max(std::sqrt(1 - cu * cu), 1e-9), v.x0, v.x1);
    const double d = std::sqrt(x * x + v.z * v.z);
    const double h0 = v.y0 / std::sqrt(d * d + v.y0 * v.y0);
    const double h1 = v.y1 / std::sqrt(d * d + v.y1 * v.y1);
    const double h = h0 + static_cast<double>(u.y) * (h1 - h0);
    const double y = h * h < 1 - 1e-12 ? std::clamp(h * d / std::sqrt(1 - h * h), v.y0, v.y1)
                                       : (h > 0 ? v.y1 : v.y0);
    to =
        x_ * static_cast<float>(x) + y_ * static_cast<float>(y) + normal_ * static_cast<float>(v.z);
    out.pdf = static_cast<float>(1 / v.solid_angle);
  }
  const float squared = dot(to, to);
  out.distance = std::sqrt(squared);
  out.direction = to * (1 / out.distance);
  if (far) {
    const float cosine = -dot(out.direction, normal_);
    out.pdf = cosine > 0 ? squared / (area() * cosine) : 0;
  }
  return out;
}

float RectangleShape::hit(const Ray& ray) const {
  const float cosine = -dot(ray.direction, normal_);
  if (!(cosine > 0)) return 0;
  const Vec3f to_center = center_ - ray.origin;
  const float t = -dot(to_center, normal_) / cosine;
  if (!(t > 0)) return 0;
  const Vec3f across = ray.direction * t - to_center;
  return std::fabs(dot(across, x_)) <= 0.5f * width_ && std::fabs(dot(across, y_)) <= 0.5f * height_
             ? t
             : 0;
}

float RectangleShape::pdf(const Vec3f& point, const Vec3f& direction) const {
  const float t = hit({point, direction});
  if (!(t > 0)) return 0;
  const Vec3f to_center = center_ - point;
  if (is_far(to_center)) return t * t / (area() * -dot(direction, normal_));
  const View v(*this, to_center);
  return v.usable() ? static_cast<float>(1 / v.solid_angle) : 0;
}

LightBounds RectangleShape::bounds(float luminance) const {
  LightBounds out;
  out.box.extendBy(center_ - half_x_ - half_y_);
  out.box.extendBy(center_ - half_x_ + half_y_);
  out.box.extendBy(center_ + half_x_ - half_y_);
  out.box.extendBy(center_ + half_x_ + half_y_);
  out.axis = normal_;
  out.cos_spread = 1;
  out.strength = luminance * area();
  return out;
}

float RectangleShape::importance(const LightSampleContext& point) const {
  const Vec3f to = center_ - point.position;
  const float squared = dot(to, to);
  const float front = -dot(to, normal_);
  if (!(front > 0)) return 0;
  float surface_cosine = 1;
  if (point.on_surface()) {
    // The vertex highest above the horizon decides.
    const float height = dot(point.normal, to) + std::fabs(dot(point.normal, half_x_)) +
                         std::fabs(dot(point.normal, half_y_));
    if (!(height > 0)) return 0;
    surface_cosine = std::min(1.0f, height / std::sqrt(squared + radius_squared()));
  }
  const float light_cosine = std::min(1.0f, front / std::sqrt(squared));
  // Near the rectangle the solid angle is at most a hemisphere, whatever area over squared distance
  // gives.
  return surface_cosine * std::min(2 * kPif, area() * std::max(light_cosine, 0.05f) /
                                                 std::max(squared, 0.25f * radius_squared()));
}

float RectangleShape::importance_along(const Ray& ray, float begin, float end) const {
  const auto front = [&](float t) { return dot(ray.at(t) - center_, normal_) > 0; };
  if (!front(begin) && !front(end)) return 0;
  const float t = std::clamp(dot(center_ - ray.origin, ray.direction), begin, end);
  const Vec3f to = center_ - ray.at(t);
  // Integrated over the ray, 1 / distance^2 gives 1 / (nearest distance).
  return area() / std::sqrt(std::max(dot(to, to), 0.25f * area()));
}

void RectangleShape::export_to(exchange::Light& light) const {
  light.shape = exchange::Light::Shape::rectangle;
  light.place = exchange::look_along(Vec3d(center_), Vec3d(normal_), Vec3d(y_));
  light.width = static_cast<double>(width_);
  light.height = static_cast<double>(height_);
}

}  // namespace vug::render
