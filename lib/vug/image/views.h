// The views of a picture for stereo, as its channels tell them: "right.albedo.R".
#pragma once

#include <vug/image/image.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::image {

/// What one eye sees. Its channels are named as those of a picture of one view.
struct View {
  std::string name;  ///< "left" or "right"; empty where the channels stand without one.
  std::vector<std::string> channels;

  /// The picture's name of one of `channels`, or of a layer of them.
  std::string full(const std::string& name_in_view) const {
    return name.empty() ? name_in_view : name + "." + name_in_view;
  }
  bool operator==(const View&) const = default;
};

/// First what stands without a name, which is the left view where there is a right one.
std::vector<View> views_of(const std::vector<std::string>& channels);

/// The pixels of one view.
Image extract(const Image& picture, const View& view);

/// The channels of both pictures, which are of one size.
Image joined(const Image& a, const Image& b);

/// What both eyes see as one picture, as it is read from a file: the right eye's channels with
/// "right." before their names.
Image stereo_image(const Image& left, const Image& right);

/// Which layer of `view` a name means: "right.N" is N of the right view, "right" its beauty, and
/// "N" that of every view. None where the name is of another view.
std::optional<std::string> layer_in(const View& view, const std::string& layer);

}  // namespace vug::image
