// SPDX-License-Identifier: Apache-2.0
#include <vug/picture/motion.h>
#include <vug/render/cameras/moving_camera.h>

#include <algorithm>

namespace vug::picture {
namespace {

/// Number of time samples while the shutter is open; motion between them is linear.
constexpr int kMoments = 9;

}  // namespace

building::TimeSamples shutter_samples(const shot::Shot& shot, const PictureOptions& options,
                                      const shot::RenderPlan& plan) {
  building::TimeSamples time_samples;
  if (!plan.camera || !shot.animated || !options.shot_at_frame) return time_samples;
  const render::Shutter shutter = plan.camera->shutter();
  for (int i = 0; i < kMoments && !shutter.empty(); ++i)
    time_samples.push_back(options.shot_at_frame(
        shot.frame + shutter.open + (shutter.close - shutter.open) * i / (kMoments - 1.0)));
  return time_samples;
}

render::CameraPtr animated_camera(const building::TimeSamples& time_samples,
                                  const PictureOptions& options, const shot::RenderPlan& plan) {
  std::vector<render::CameraPtr> cameras;
  for (const auto& shot : time_samples) cameras.push_back(render_plan(*shot, options).camera);
  const bool still = std::all_of(cameras.begin(), cameras.end(),
                                 [&](const auto& each) { return each == plan.camera; });
  return still ? plan.camera : render::moving_camera(std::move(cameras));
}

render::MotionStepPtr motion_step(building::Builder& builder, const PictureOptions& options,
                                  const shot::RenderPlan& plan) {
  const shot::Shot& shot = builder.shot();
  if (!plan.camera || !shot.animated || !options.shot_at_frame) return nullptr;
  const building::TimeSamples both = {options.shot_at_frame(shot.frame),
                                      options.shot_at_frame(shot.frame + 1)};
  auto step = std::make_shared<render::MotionStep>();
  step->now = plan.camera;
  step->next = render_plan(*both[1], options).camera;
  if (options.eye != 0)
    step->now = step->now->stereo_view(options.eye),
    step->next = step->next->stereo_view(options.eye);
  const building::FlatScene flat = building::flatten_scene(builder, both);
  for (size_t i = 0; i < flat.objects.size(); ++i)
    if (const auto& instance = flat.objects[i].instance; instance && instance->moves())
      step->transforms[static_cast<uint32_t>(i)] = {instance->keyframes()[0],
                                                    instance->keyframes()[1]};
  return step;
}

}  // namespace vug::picture
