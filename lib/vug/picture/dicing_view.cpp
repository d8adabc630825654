// SPDX-License-Identifier: Apache-2.0
#include <vug/picture/dicing_view.h>

#include <algorithm>

namespace vug::picture {

building::DicingView dicing_view(const shot::Shot& shot, const PicturePlan& plan,
                                 const building::TimeSamples& time_samples,
                                 const render::CameraPtr& otherwise) {
  building::DicingView view;
  const auto add = [&](const render::CameraPtr& camera) {
    const auto& known = view.cameras;
    if (camera && std::find(known.begin(), known.end(), camera) == known.end())
      view.cameras.push_back(camera);
  };
  for (const auto& sample : time_samples) add(camera_in(*sample, plan));
  if (view.cameras.empty()) add(camera_in(shot, plan));
  if (view.cameras.empty()) add(otherwise);
  const std::vector<int>& size = plan.render.settings.size;
  view.picture = {size[0], size[1]};
  return view;
}

}  // namespace vug::picture
