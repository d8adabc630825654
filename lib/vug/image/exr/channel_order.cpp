// SPDX-License-Identifier: Apache-2.0
#include <vug/image/exr/channel_order.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <tuple>

namespace vug::image::exr {
namespace {

constexpr std::array<std::string_view, 20> kColours = {
    "r",     "red", "g",  "green", "b",  "blue", "y",  "real", "imag",  "a",
    "alpha", "ar",  "ra", "ag",    "ga", "ab",   "ba", "z",    "depth", "zback"};
/// Coordinates have the place of Y in kColours.
constexpr std::array<std::string_view, 3> kCoordinates = {"x", "y", "z"};

/// A name with its layer; `last` is the part after the layer in lower case.
struct Channel {
  std::string name, layer, last;

  explicit Channel(const std::string& full) : name(full) {
    const size_t dot = full.rfind('.');
    layer = full.substr(0, dot == full.npos ? 0 : dot + 1);
    last = full.substr(layer.size());
    for (char& c : last)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
};

template <size_t kCount>
size_t index_in(const std::array<std::string_view, kCount>& list, const std::string& last) {
  return static_cast<size_t>(std::find(list.begin(), list.end(), last) - list.begin());
}

/// Ranks of a layer's channels. X and at least one of Y and Z are coordinates.
class Ranks {
 public:
  explicit Ranks(const std::vector<Channel>& channels) {
    for (const Channel& channel : channels) known_.emplace(channel.layer, channel.last);
  }
  std::pair<size_t, size_t> operator()(const Channel& channel) const {
    const size_t axis = index_in(kCoordinates, channel.last);
    if (axis < kCoordinates.size() && has_coordinates(channel.layer))
      return {index_in(kColours, "y"), axis};
    return {index_in(kColours, channel.last), 0};
  }

 private:
  bool has_coordinates(const std::string& layer) const {
    return known_.count({layer, "x"}) && (known_.count({layer, "y"}) || known_.count({layer, "z"}));
  }

  std::set<std::pair<std::string, std::string>> known_;
};

}  // namespace

void sort_channels(std::vector<std::string>& names) {
  std::vector<Channel> channels(names.begin(), names.end());
  const Ranks rank(channels);
  std::sort(channels.begin(), channels.end(), [&](const Channel& a, const Channel& b) {
    return std::make_tuple(a.layer, rank(a), a.name) < std::make_tuple(b.layer, rank(b), b.name);
  });
  std::transform(channels.begin(), channels.end(), names.begin(),
                 [](const Channel& channel) { return channel.name; });
}

}  // namespace vug::image::exr
