// The views that a picture is of: one, or those of both eyes.
#pragma once

#include <vug/picture/render_job.h>

#include <vector>

namespace vug::picture {

/// The picture, or both views of a camera for stereo, left and right. Error(bad_input) for two
/// views with a checkpoint or in parts.
std::vector<RenderResult> render_views(building::Builder& builder, const RenderOptions& options);

/// Of those that are no parts: what writes them. They must outlive it.
std::vector<PictureView> picture_views(const std::vector<RenderResult>& rendered);

/// Warns of a picture that is all but black or white at its exposure: a first picture of a scene
/// often is, and its light not to be guessed.
void warn_of_exposure(const building::Builder& builder, const RenderResult& picture);

}  // namespace vug::picture
