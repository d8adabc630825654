// SPDX-License-Identifier: Apache-2.0
// Perspective camera with a pinhole or a thin lens.
#include <vug/exchange/camera.h>
#include <vug/render/cameras/camera_frame.h>
#include <vug/render/cameras/lens.h>
#include <vug/render/kind.h>

namespace vug::render {
namespace {

struct Perspective : CameraFrameParams, LensParams, StereoParams {
  double fov = kPi / 3;
  std::optional<double> focal_length;
  double sensor_width = 0.036;

  static void describe(Schema<Perspective>& s) {
    describe_camera_frame(s.doc("A perspective view with square pixels."))
        .param("fov", &Perspective::fov,
               {.doc = "Horizontal angle of view.",
                .dimension = Dimension::angle,
                .min = 1e-6,
                .max = 3.1})
        .param("focal_length", &Perspective::focal_length,
               {.doc = "Focal length of a photograph's lens, such as 24mm, in place of `fov`.",
                .dimension = Dimension::length,
                .min = 1e-4,
                .max = 100})
        .param(
            "sensor_width", &Perspective::sensor_width,
            {.doc = "Width of the sensor behind the focal length; 36mm is that of 35 mm film, to "
                    "which many cameras convert their focal lengths.",
             .dimension = Dimension::length,
             .min = 1e-4,
             .max = 1});
    describe_lens(s);
    describe_shutter(describe_stereo(s));
  }
  std::string fault() const {
    const std::string fault = camera_frame_fault();
    return fault.empty() ? lens_fault() : fault;
  }
};

class PerspectiveCamera final : public Camera {
 public:
  explicit PerspectiveCamera(const Perspective& p) : frame_(p), aperture_(p) {
    half_width_ = static_cast<float>(p.focal_length ? 0.5 * p.sensor_width / *p.focal_length
                                                    : maths::tan(0.5 * p.fov));
    lens_radius_ = static_cast<float>(0.5 * p.aperture);
    focus_ = static_cast<float>(p.focus.value_or((p.target - p.eye).length()));
    half_interaxial_ = static_cast<float>(0.5 * p.interaxial);
    if (p.convergence) convergence_skew_ = static_cast<float>(0.5 * p.interaxial / *p.convergence);
  }

  Ray ray(const Vec2f& film, float aspect, const Vec2f& lens) const override {
    const Vec3f through = frame_.forward + frame_.right * ((2 * film.x - 1) * half_width_ + skew_) +
                          frame_.up * ((1 - 2 * film.y) * half_width_ / aspect);
    if (!(lens_radius_ > 0)) return {frame_.eye, normalized(through)};
    const Vec2f d = aperture_.sample(lens);
    const Vec3f shift = frame_.right * (d.x * lens_radius_) + frame_.up * (d.y * lens_radius_);
    return {frame_.eye + shift, normalized(through * focus_ - shift)};
  }
  std::optional<Vec2f> project(const Vec3f& point, float aspect) const override {
    const Vec3f local = frame_.to_local(point);
    if (!(local.z > 0)) return std::nullopt;
    const float scale = 0.5f / (local.z * half_width_);
    return Vec2f(0.5f + (local.x - skew_ * local.z) * scale, 0.5f - local.y * scale * aspect);
  }
  Vec3f position() const override { return frame_.eye; }
  float depth(const Vec3f& point) const override { return dot(point - frame_.eye, frame_.forward); }
  std::optional<CameraMatrices> matrices(float aspect) const override {
    // w is the depth z; x = z/2 + right / (2 tan(fov/2)); y is analogous, downwards. The third
    // column, z - 1, is free: it keeps the matrix invertible.
    std::array<float, 16> to_ndc{};
    to_ndc[0] = 0.5f / half_width_;
    to_ndc[5] = -0.5f * aspect / half_width_;
    to_ndc[8] = 0.5f * (1 - skew_ / half_width_);
    to_ndc[9] = 0.5f;
    to_ndc[10] = to_ndc[11] = 1;
    to_ndc[14] = -1;
    const auto to_camera = frame_.world_to_camera();
    return CameraMatrices{to_camera, product(to_camera, to_ndc)};
  }
  bool as_data(exchange::Camera& camera) const override {
    camera.place = frame_.transform();
    camera.fov = 2 * maths::atan2(static_cast<double>(half_width_), 1);
    camera.aperture = 2 * static_cast<double>(lens_radius_);
    camera.focus = static_cast<double>(focus_);
    return true;
  }
  Shutter shutter() const override { return frame_.shutter; }
  /// Both eyes look in the same direction; each sees a different part of the window at the
  /// convergence distance.
  CameraPtr stereo_view(int side) const override {
    if (!(half_interaxial_ > 0)) return nullptr;
    auto one = std::make_shared<PerspectiveCamera>(*this);
    one->frame_.eye += frame_.right * (half_interaxial_ * static_cast<float>(side));
    one->skew_ = -convergence_skew_ * static_cast<float>(side);
    one->half_interaxial_ = 0;
    return one;
  }

 private:
  CameraFrame frame_;
  ApertureShape aperture_;
  float half_width_, lens_radius_, focus_;
  float skew_ = 0;  ///< Offset of the window to the right, at distance 1.
  float half_interaxial_ = 0, convergence_skew_ = 0;  ///< For each eye of a stereo camera.
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(perspective, camera, CameraPtr, Perspective, PerspectiveCamera)
