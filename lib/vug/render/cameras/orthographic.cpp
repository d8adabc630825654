// SPDX-License-Identifier: Apache-2.0
// Orthographic camera, for plans and sections.
#include <vug/exchange/camera.h>
#include <vug/render/cameras/camera_frame.h>
#include <vug/render/kind.h>

namespace vug::render {
namespace {

struct Orthographic : CameraFrameParams {
  double width = 4;

  static void describe(Schema<Orthographic>& s) {
    describe_camera_frame(
        s.doc("An orthographic view, for plans and sections. It shows everything in front of "
              "the plane through the eye."))
        .param("width", &Orthographic::width, positive_length("Width of the view in the scene."));
    describe_shutter(s);
  }
  std::string fault() const { return camera_frame_fault(); }
};

class OrthographicCamera final : public Camera {
 public:
  explicit OrthographicCamera(const Orthographic& p)
      : frame_(p), width_(static_cast<float>(p.width)) {}

  Ray ray(const Vec2f& film, float aspect, const Vec2f&) const override {
    return {frame_.eye + frame_.right * ((film.x - 0.5f) * width_) +
                frame_.up * ((0.5f - film.y) * width_ / aspect),
            frame_.forward};
  }
  std::optional<Vec2f> project(const Vec3f& point, float aspect) const override {
    const Vec3f local = frame_.to_local(point);
    if (!(local.z > 0)) return std::nullopt;
    return Vec2f(0.5f + local.x / width_, 0.5f - local.y * aspect / width_);
  }
  Vec3f position() const override { return frame_.eye; }
  Shutter shutter() const override { return frame_.shutter; }
  float depth(const Vec3f& point) const override { return dot(point - frame_.eye, frame_.forward); }
  bool as_data(exchange::Camera& camera) const override {
    camera.place = frame_.transform();
    camera.orthographic = true;
    camera.span = static_cast<double>(width_);
    return true;
  }
  std::optional<CameraMatrices> matrices(float aspect) const override {
    std::array<float, 16> to_ndc{};
    to_ndc[0] = 1 / width_;
    to_ndc[5] = -aspect / width_;
    to_ndc[10] = to_ndc[15] = 1;
    to_ndc[12] = to_ndc[13] = 0.5f;
    const auto to_camera = frame_.world_to_camera();
    return CameraMatrices{to_camera, product(to_camera, to_ndc)};
  }

 private:
  CameraFrame frame_;
  float width_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(orthographic, camera, CameraPtr, Orthographic, OrthographicCamera)
