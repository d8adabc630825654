// SPDX-License-Identifier: Apache-2.0
#include <vug/image/part_channels.h>
#include <vug/image/read_error.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::image {

std::vector<std::string> channel_names(const std::vector<PartChannels>& parts) {
  std::vector<std::string> out;
  for (const PartChannels& part : parts) {
    const bool other = part.view != parts.front().view;
    const std::string prefix = other ? part.view : part.name.empty() ? "part" : part.name;
    for (const std::string& channel : part.channels) {
      const bool known = std::find(out.begin(), out.end(), channel) != out.end();
      out.push_back(other || known ? prefix + "." + channel : channel);
    }
  }
  return out;
}

size_t total_channels(const std::vector<PartChannels>& parts) {
  size_t sum = 0;
  for (const PartChannels& part : parts) sum += part.channels.size();
  return sum;
}

void require_reasonable_size(const std::filesystem::path& path, int width, int height,
                             size_t channels) {
  // 64 GiB of floats; a larger product can only come from a broken header.
  constexpr double kMostValues = 1.6e10;
  if (static_cast<double>(width) * height * static_cast<double>(channels) > kMostValues)
    throw read_error(path, fmt::format("its header claims {} x {} pixels", width, height));
}

}  // namespace vug::image
