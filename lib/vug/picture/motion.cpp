// SPDX-License-Identifier: Apache-2.0
#include <vug/picture/motion.h>
#include <vug/render/cameras/moving_camera.h>

#include <algorithm>

namespace vug::picture {
namespace {

/// Number of time samples while the shutter is open; motion between them is linear.
constexpr int kMoments = 9;

/// Whether something may differ at other frames.
bool is_animated(const shot::Shot& shot, const PicturePlan& plan) {
  return plan.render.settings.camera && shot.animated && plan.options.source;
}

}  // namespace

building::TimeSamples shutter_samples(const shot::Shot& shot, const PicturePlan& plan) {
  building::TimeSamples time_samples;
  if (!is_animated(shot, plan)) return time_samples;
  const render::Shutter shutter = plan.render.settings.camera->shutter();
  for (int i = 0; i < kMoments && !shutter.empty(); ++i)
    time_samples.push_back(plan.options.source->shot_at(
        shot.frame + shutter.open + (shutter.close - shutter.open) * i / (kMoments - 1.0)));
  return time_samples;
}

render::CameraPtr animated_camera(const building::TimeSamples& time_samples,
                                  const PicturePlan& plan) {
  const render::CameraPtr& own = plan.render.settings.camera;
  std::vector<render::CameraPtr> cameras;
  for (const auto& shot : time_samples) cameras.push_back(camera_in(*shot, plan));
  const bool still =
      std::all_of(cameras.begin(), cameras.end(), [&](const auto& each) { return each == own; });
  return still ? own : render::moving_camera(std::move(cameras));
}

render::MotionStepPtr motion_step(building::Builder& builder, const PicturePlan& plan) {
  const shot::Shot& shot = builder.shot();
  if (!is_animated(shot, plan)) return nullptr;
  const loading::SceneSource& source = *plan.options.source;
  const building::TimeSamples both = {source.shot_at(shot.frame), source.shot_at(shot.frame + 1)};
  auto step = std::make_shared<render::MotionStep>();
  step->now = plan.render.settings.camera;
  step->next = camera_in(*both[1], plan);
  if (const int eye = plan.options.eye; eye != 0)
    step->now = step->now->stereo_view(eye), step->next = step->next->stereo_view(eye);
  const building::FlatScene flat = building::flatten_scene(builder, *plan.shown, both);
  for (size_t i = 0; i < flat.objects.size(); ++i)
    if (const auto& instance = flat.objects[i].instance; instance && instance->moves())
      step->transforms[static_cast<uint32_t>(i)] = {instance->keyframes()[0],
                                                    instance->keyframes()[1]};
  return step;
}

}  // namespace vug::picture
