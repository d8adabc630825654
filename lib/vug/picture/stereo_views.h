// SPDX-License-Identifier: Apache-2.0
// Renders the views of a picture, one or both of a stereo camera, and warns about its exposure.
#pragma once

#include <vug/picture/render_job.h>

#include <vector>

namespace vug::picture {

/// Renders the picture, or the left and right views of a stereo camera. Error(bad_input) for two
/// views with a checkpoint or as a partial render.
std::vector<RenderResult> render_views(building::Builder& builder, const PicturePlan& plan,
                                       const RenderOptions& options = {});

/// The views of all finished pictures, for write_picture; `rendered` must outlive them.
std::vector<PictureView> picture_views(const std::vector<RenderResult>& rendered);

/// Warns about a picture that is nearly black or white at its exposure, as the first picture of a
/// scene often is.
void warn_about_exposure(const building::Builder& builder, const RenderResult& picture);

}  // namespace vug::picture
