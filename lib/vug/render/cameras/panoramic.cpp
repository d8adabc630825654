// SPDX-License-Identifier: Apache-2.0
// Panoramic camera (equirectangular): longitude to the right, latitude upwards, both evenly spaced.
// The centre of the picture looks at the target.
#include <vug/render/cameras/camera_frame.h>
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct Panoramic : CameraFrameParams, StereoParams {
  double horizontal = 2 * kPi;
  std::optional<double> vertical;

  static void describe(Schema<Panoramic>& s) {
    describe_camera_frame(
        s.doc("An equirectangular panorama (longitude and latitude): a picture twice as wide "
              "as high contains all directions."))
        .param("horizontal", &Panoramic::horizontal,
               {.doc = "Horizontal angle of view.",
                .dimension = Dimension::angle,
                .min = 1e-6,
                .max = 2 * kPi})
        .param("vertical", &Panoramic::vertical,
               {.doc = "Vertical angle of view; by default, pixels are square at the picture's "
                       "centre.",
                .dimension = Dimension::angle,
                .min = 1e-6,
                .max = kPi});
    describe_shutter(describe_stereo(s));
  }
  std::string fault() const { return camera_frame_fault(); }
};

class PanoramicCamera final : public Camera {
 public:
  explicit PanoramicCamera(const Panoramic& p)
      : frame_(p), turns_round_(static_cast<float>(p.horizontal / (2 * kPi))) {
    if (p.vertical) turns_high_ = static_cast<float>(*p.vertical / (2 * kPi));
    half_interaxial_ = static_cast<float>(0.5 * p.interaxial);
    if (p.convergence) convergence_ = static_cast<float>(*p.convergence);
  }

  Ray ray(const Vec2f& film, float aspect, const Vec2f&) const override {
    const SinCos longitude = sincos_turns((film.x - 0.5f) * turns_round_);
    const SinCos latitude = sincos_turns((0.5f - film.y) * turns_high(aspect));
    const Vec3f local(latitude.cos * longitude.sin, latitude.sin, latitude.cos * longitude.cos);
    const Vec3f direction = normalized(frame_.to_world(local));
    if (!(std::fabs(eye_side_) > 0)) return {frame_.eye, direction};
    const Vec3f shift = eye_offset(longitude, (0.5f - film.y) * turns_high(aspect));
    if (!(convergence_ > 0)) return {frame_.eye + shift, direction};
    return {frame_.eye + shift, normalized(direction * convergence_ - shift)};
  }
  std::optional<Vec2f> project(const Vec3f& point, float aspect) const override {
    if (!(std::fabs(eye_side_) > 0)) return project_from_center(point, aspect);
    // The eye's offset depends on the direction: fixed-point iteration from the centre.
    std::optional<Vec2f> film_position = project_from_center(point, aspect);
    for (int step = 0; film_position && step < 8; ++step) {
      const SinCos longitude = sincos_turns((film_position->x - 0.5f) * turns_round_);
      const Vec3f shift = eye_offset(longitude, (0.5f - film_position->y) * turns_high(aspect));
      Vec3f to_point = point - frame_.eye - shift;
      if (convergence_ > 0) {  // from the centre to the ray's hit on the convergence sphere
        to_point = normalized(to_point);
        const float b = dot(shift, to_point), c = dot(shift, shift) - convergence_ * convergence_;
        to_point = shift + to_point * (-b + std::sqrt(std::max(0.0f, b * b - c)));
      }
      film_position = project_from_center(frame_.eye + to_point, aspect);
    }
    return film_position;
  }
  float period() const override { return 1 / turns_round_; }
  Vec3f position() const override { return frame_.eye; }
  float depth(const Vec3f& point) const override { return length(point - frame_.eye); }
  std::optional<CameraMatrices> matrices(float) const override {
    return CameraMatrices{frame_.world_to_camera(), std::nullopt};
  }
  Shutter shutter() const override { return frame_.shutter; }
  /// Omni-directional stereo: in every direction, the eyes are offset perpendicularly to it. Peleg
  /// et al. 2001, "Omnistereo" (peleg2001omnistereo).
  CameraPtr stereo_view(int side) const override {
    if (!(half_interaxial_ > 0)) return nullptr;
    auto one = std::make_shared<PanoramicCamera>(*this);
    one->eye_side_ = half_interaxial_ * static_cast<float>(side);
    one->half_interaxial_ = 0;
    return one;
  }

 private:
  std::optional<Vec2f> project_from_center(const Vec3f& point, float aspect) const {
    const Vec3f local = frame_.to_local(point);
    const float level = std::sqrt(local.x * local.x + local.z * local.z);
    if (!(level > 0 || std::fabs(local.y) > 0)) return std::nullopt;
    const auto signed_turns = [](float turns) { return turns < 0.5f ? turns : turns - 1; };
    return Vec2f(0.5f + signed_turns(turns_of(local.x, local.z)) / turns_round_,
                 0.5f - signed_turns(turns_of(local.y, level)) / turns_high(aspect));
  }
  /// Offset of one eye from the centre. It fades to zero towards the zenith and the nadir, where
  /// the perpendicular direction is undefined.
  Vec3f eye_offset(const SinCos& longitude, float latitude_turns) const {
    constexpr float kFadeBegin = 60 / 360.0f, kFadeEnd = 75 / 360.0f;
    const float t =
        std::clamp((std::fabs(latitude_turns) - kFadeBegin) / (kFadeEnd - kFadeBegin), 0.0f, 1.0f);
    const float part = 1 - t * t * (3 - 2 * t);
    return (frame_.right * longitude.cos - frame_.forward * longitude.sin) * (eye_side_ * part);
  }
  float turns_high(float aspect) const {
    return turns_high_ > 0 ? turns_high_ : std::min(turns_round_ / aspect, 0.5f);
  }

  CameraFrame frame_;
  float turns_round_;
  float turns_high_ = 0;  ///< 0: from the aspect ratio.
  float eye_side_ = 0;    ///< Offset of this eye to the right of the centre.
  float half_interaxial_ = 0, convergence_ = 0;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(panoramic, camera, CameraPtr, Panoramic, PanoramicCamera)
