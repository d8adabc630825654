// The views that a picture is of: one, or those of both eyes.
#pragma once

#include <vug/session/long_render.h>

#include <vector>

namespace vug::session {

/// The picture, or both views of a camera for stereo, left and right. Error(bad_input) for two
/// views with a checkpoint or in parts.
std::vector<Rendered> render_views(Builder& builder, const RenderOptions& options);

/// Of those that are no parts: what writes them. They must outlive it.
std::vector<PictureView> views_of(const std::vector<Rendered>& rendered);

/// Warns of a picture that is all but black or white at its exposure: a first picture of a scene
/// often is, and its light not to be guessed.
void warn_of_exposure(const Builder& builder, const Rendered& picture);

}  // namespace vug::session
