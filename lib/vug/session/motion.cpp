#include <vug/render/moving_camera.h>
#include <vug/session/motion.h>

#include <algorithm>

namespace vug::session {
namespace {

/// Moments while the shutter is open: lines between them stand for the way.
constexpr int kMoments = 9;

}  // namespace

render::CameraPtr camera_in_motion(const Shot& shot, const PictureOptions& options,
                                   const RenderPlan& plan) {
  if (!plan.camera || !shot.moves || !options.moment) return plan.camera;
  const render::Shutter shutter = plan.camera->shutter();
  if (shutter.empty()) return plan.camera;
  std::vector<render::CameraPtr> cameras;
  for (int i = 0; i < kMoments; ++i) {
    const double after =
        shutter.open + (shutter.close - shutter.open) * i / static_cast<double>(kMoments - 1);
    const auto moment = options.moment(shot.frame + after);
    cameras.push_back(render_plan(*moment, options).camera);
  }
  const bool still = std::all_of(cameras.begin(), cameras.end(),
                                 [&](const auto& each) { return each == plan.camera; });
  return still ? plan.camera : render::moving_camera(std::move(cameras));
}

render::FrameStepPtr frame_step(const Shot& shot, const PictureOptions& options,
                                const RenderPlan& plan) {
  if (!plan.camera || !shot.moves || !options.moment) return nullptr;
  const render::CameraPtr next = render_plan(*options.moment(shot.frame + 1), options).camera;
  if (!next || next == plan.camera) return nullptr;
  auto step = std::make_shared<render::FrameStep>();
  step->now = options.eye == 0 ? plan.camera : plan.camera->eye_view(options.eye);
  step->next = options.eye == 0 ? next : next->eye_view(options.eye);
  return step;
}

}  // namespace vug::session
