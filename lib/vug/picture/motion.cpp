#include <vug/picture/motion.h>
#include <vug/render/cameras/moving_camera.h>

#include <algorithm>

namespace vug::picture {
namespace {

/// Moments while the shutter is open: lines between them stand for the way.
constexpr int kMoments = 9;

}  // namespace

building::Moments shutter_moments(const shot::Shot& shot, const PictureOptions& options,
                                  const shot::RenderPlan& plan) {
  building::Moments moments;
  if (!plan.camera || !shot.moves || !options.moment) return moments;
  const render::Shutter shutter = plan.camera->shutter();
  for (int i = 0; i < kMoments && !shutter.empty(); ++i)
    moments.push_back(options.moment(shot.frame + shutter.open +
                                     (shutter.close - shutter.open) * i / (kMoments - 1.0)));
  return moments;
}

render::CameraPtr camera_in_motion(const building::Moments& moments, const PictureOptions& options,
                                   const shot::RenderPlan& plan) {
  std::vector<render::CameraPtr> cameras;
  for (const auto& moment : moments) cameras.push_back(render_plan(*moment, options).camera);
  const bool still = std::all_of(cameras.begin(), cameras.end(),
                                 [&](const auto& each) { return each == plan.camera; });
  return still ? plan.camera : render::moving_camera(std::move(cameras));
}

render::FrameStepPtr frame_step(building::Builder& builder, const PictureOptions& options,
                                const shot::RenderPlan& plan) {
  const shot::Shot& shot = builder.shot();
  if (!plan.camera || !shot.moves || !options.moment) return nullptr;
  const building::Moments both = {options.moment(shot.frame), options.moment(shot.frame + 1)};
  auto step = std::make_shared<render::FrameStep>();
  step->now = plan.camera;
  step->next = render_plan(*both[1], options).camera;
  if (options.eye != 0)
    step->now = step->now->eye_view(options.eye), step->next = step->next->eye_view(options.eye);
  const building::Cast cast = building::cast_of(builder, both);
  for (size_t i = 0; i < cast.objects.size(); ++i)
    if (const auto& placing = cast.objects[i].placing; placing && placing->moves())
      step->places[static_cast<uint32_t>(i)] = {placing->steps()[0], placing->steps()[1]};
  return step;
}

}  // namespace vug::picture
