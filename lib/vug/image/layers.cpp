// SPDX-License-Identifier: Apache-2.0
#include <vug/image/layers.h>

#include <algorithm>

namespace vug::image {
namespace {

/// The part before the last dot; empty without a dot.
std::string prefix_of(const std::string& channel) {
  const size_t dot = channel.rfind('.');
  return dot == std::string::npos ? "" : channel.substr(0, dot);
}

std::string plain_name(const std::string& channel) {
  return channel.substr(channel.rfind('.') + 1);  // from 0 without a dot
}

bool is_primary(const std::string& channel) {
  return channel == "R" || channel == "G" || channel == "B";
}

}  // namespace

bool Layer::colour() const {
  const auto has = [&](const char* wanted) {
    return std::any_of(channels.begin(), channels.end(),
                       [&](const std::string& channel) { return plain_name(channel) == wanted; });
  };
  return has("R") && has("G") && has("B");
}

std::vector<Layer> layers_of(const std::vector<std::string>& channels) {
  std::vector<Layer> out;
  for (const std::string& channel : channels) {
    const std::string prefix = prefix_of(channel);
    const std::string name = !prefix.empty() ? prefix : is_primary(channel) ? kBeauty : channel;
    auto layer =
        std::find_if(out.begin(), out.end(), [&](const Layer& l) { return l.name == name; });
    if (layer == out.end())
      layer = out.insert(name == kBeauty ? out.begin() : out.end(), {name, {}});
    layer->channels.push_back(channel);
  }
  return out;
}

Image extract(const Image& picture, const Layer& layer) {
  Image out = picture.select(layer.channels);
  for (std::string& channel : out.channels) channel = plain_name(channel);
  return out;
}

}  // namespace vug::image
