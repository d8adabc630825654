// SPDX-License-Identifier: Apache-2.0
#include <vug/image/brightness.h>
#include <vug/picture/exposure.h>
#include <vug/picture/stereo_views.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::picture {

std::vector<RenderResult> render_views(building::Builder& builder, const PicturePlan& plan,
                                       const RenderOptions& options) {
  if (plan.options.eye != 0 || !is_stereo(plan)) return {render_picture(builder, plan, options)};
  if (!options.part.empty() || !options.checkpoint.empty() || !options.guiding.empty())
    throw Error(
        ErrorCode::bad_input,
        "a stereo picture cannot have a checkpoint or a guiding file, or be rendered in parts", {},
        "render one view at a time: --eye left, then --eye right");
  std::vector<RenderResult> views;
  for (const int eye : {-1, 1}) {
    PicturePlan view = plan;
    view.options.eye = eye;
    RenderOptions one = options;
    if (eye > 0) one.estimate = nullptr, one.inspect = nullptr;
    views.push_back(render_picture(builder, view, one));
  }
  return views;
}

std::vector<PictureView> picture_views(const std::vector<RenderResult>& rendered) {
  std::vector<PictureView> views;
  for (const RenderResult& each : rendered)
    if (each.image)
      views.push_back({*each.image, each.header, each.output, each.deep ? &*each.deep : nullptr});
  return views;
}

void warn_about_exposure(const building::Builder& builder, const RenderResult& picture) {
  constexpr double kOff = 5;  // stops
  const shot::OutputSettings& settings = picture.output.settings;
  const image::WorkingSpace space = settings.working_space;
  const std::optional<double> grey = image::grey_exposure(*picture.image, space);
  if (grey && settings.exposure.metered()) return;
  const double exposure = exposure_stops(settings, *picture.image);
  if (grey && std::fabs(*grey - exposure) <= kOff) return;
  // A single light in a dark room is not a reason to warn: most of the picture must be bright.
  const double bright = 0.18 * std::exp2(kOff - exposure);
  if (grey && *grey < exposure && image::fraction_above(*picture.image, bright, space) < 0.5)
    return;
  builder.warn(picture.where,
               !grey              ? "no light reaches the picture"
               : *grey > exposure ? "the picture is very dark"
                                  : "the picture is very bright",
               grey ? fmt::format("--exposure {:.1f} would show its middle tones as grey", *grey)
                    : "add a light in view of the camera, or a sky behind an opening");
}

}  // namespace vug::picture
