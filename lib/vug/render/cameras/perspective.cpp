// A perspective camera, pinhole or thin lens with a round opening.
#include <vug/base/maths.h>
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct Perspective {
  Vec3d eye{0, 0, 5};
  Vec3d target{0, 0, 0};
  Vec3d up{0, 1, 0};
  double fov = kPi / 3;
  double aperture = 0;
  std::optional<double> focus;

  static void describe(Schema<Perspective>& s) {
    s.doc("A perspective view with square pixels.")
        .param("eye", &Perspective::eye, any_length("Where the camera stands."))
        .param("target", &Perspective::target, any_length("What it looks at."))
        .param("up", &Perspective::up, {.doc = "Which way is up in the picture."})
        .param("fov", &Perspective::fov,
               {.doc = "Full horizontal angle of view.",
                .dimension = Dimension::angle,
                .min = 1e-6,
                .max = 3.1})
        .param("aperture", &Perspective::aperture,
               {.doc = "Diameter of the lens opening; 0 keeps everything sharp.",
                .dimension = Dimension::length,
                .min = 0})
        .param("focus", &Perspective::focus,
               positive_length("Distance of the sharp plane; the target's when not given."));
  }
  std::string fault() const {
    const Vec3d forward = target - eye;
    if (!(forward.length() > 0)) return "the camera's eye and target are the same point";
    if (!(forward.cross(up).length() > 1e-9 * forward.length() * up.length()))
      return "the camera's up direction is its direction of view";
    return {};
  }
};

class PerspectiveCamera final : public Camera {
 public:
  explicit PerspectiveCamera(const Perspective& p) {
    const Vec3d forward = (p.target - p.eye).normalized();
    const Vec3d right = forward.cross(p.up).normalized();
    eye_ = to_float(p.eye);
    forward_ = to_float(forward);
    right_ = to_float(right);
    up_ = to_float(right.cross(forward));
    half_width_ = static_cast<float>(maths::tan(0.5 * p.fov));
    lens_radius_ = static_cast<float>(0.5 * p.aperture);
    focus_ = static_cast<float>(p.focus.value_or((p.target - p.eye).length()));
  }

  Ray ray(const Vec2f& film, float aspect, const Vec2f& lens) const override {
    const Vec3f through = forward_ + right_ * ((2 * film.x - 1) * half_width_) +
                          up_ * ((1 - 2 * film.y) * half_width_ / aspect);
    if (!(lens_radius_ > 0)) return {eye_, normalized(through)};
    const Vec2f d = sample_disk(lens);
    const Vec3f shift = right_ * (d.x * lens_radius_) + up_ * (d.y * lens_radius_);
    return {eye_ + shift, normalized(through * focus_ - shift)};
  }
  Vec3f eye() const override { return eye_; }
  float depth(const Vec3f& point) const override { return dot(point - eye_, forward_); }
  std::optional<CameraMatrices> matrices(float aspect) const override {
    CameraMatrices m;
    const Vec3f axes[] = {right_, up_, forward_};
    for (size_t column = 0; column < 3; ++column) {
      const Vec3f& axis = axes[column];
      m.world_to_camera[column] = axis.x;
      m.world_to_camera[4 + column] = axis.y;
      m.world_to_camera[8 + column] = axis.z;
      m.world_to_camera[12 + column] = -dot(axis, eye_);
    }
    m.world_to_camera[15] = 1;
    // w is the depth z; x = z/2 + right / (2 tan(fov/2)), y likewise and downwards. The third
    // column, z - 1, is free: it keeps the matrix invertible.
    for (size_t row = 0; row < 4; ++row) {
      const float* from = &m.world_to_camera[4 * row];
      float* to = &m.world_to_ndc[4 * row];
      to[0] = 0.5f * (from[2] + from[0] / half_width_);
      to[1] = 0.5f * (from[2] - from[1] * aspect / half_width_);
      to[2] = from[2] - (row == 3 ? 1.0f : 0.0f);
      to[3] = from[2];
    }
    return m;
  }

 private:
  Vec3f eye_, forward_, right_, up_;
  float half_width_, lens_radius_, focus_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(perspective, camera, CameraPtr, Perspective, PerspectiveCamera)
