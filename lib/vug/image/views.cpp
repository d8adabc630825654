// SPDX-License-Identifier: Apache-2.0
#include <vug/image/layers.h>
#include <vug/image/views.h>

#include <algorithm>

namespace vug::image {
namespace {

constexpr const char* kNames[] = {"", "left", "right"};

/// The view prefix of a name; empty without a prefix.
std::string view_in(const std::string& name) {
  for (const std::string view : {"left", "right"})
    if (name == view || name.rfind(view + ".", 0) == 0) return view;
  return "";
}

std::string without_view(const std::string& name) {
  const size_t length = view_in(name).size();
  return length == 0 ? name : length == name.size() ? "" : name.substr(length + 1);
}

}  // namespace

std::vector<View> views_of(const std::vector<std::string>& channels) {
  std::vector<View> out;
  for (const std::string name : kNames) {
    View view{name, {}};
    for (const std::string& channel : channels)
      if (view_in(channel) == name) view.channels.push_back(without_view(channel));
    if (!view.channels.empty()) out.push_back(std::move(view));
  }
  return out;
}

Image extract(const Image& picture, const View& view) {
  std::vector<std::string> names;
  for (const std::string& channel : view.channels) names.push_back(view.full(channel));
  Image out = picture.select(names);
  out.channels = view.channels;
  return out;
}

Image joined(const Image& a, const Image& b) {
  std::vector<std::string> channels = a.channels;
  channels.insert(channels.end(), b.channels.begin(), b.channels.end());
  Image out(a.width, a.height, channels);
  float* to = out.pixels.data();
  for (size_t p = 0; p < a.pixel_count(); ++p) {
    to = std::copy_n(&a.pixels[p * a.channels.size()], a.channels.size(), to);
    to = std::copy_n(&b.pixels[p * b.channels.size()], b.channels.size(), to);
  }
  return out;
}

Image stereo_image(const Image& left, const Image& right) {
  Image out = joined(left, right);
  for (size_t c = left.channels.size(); c < out.channels.size(); ++c)
    out.channels[c] = "right." + out.channels[c];
  return out;
}

std::optional<std::string> layer_in(const View& view, const std::string& layer) {
  const std::string named = view_in(layer);
  if (named.empty()) return layer;
  if (named != (view.name.empty() ? "left" : view.name)) return {};
  const std::string rest = without_view(layer);
  return rest.empty() ? kBeauty : rest;
}

}  // namespace vug::image
