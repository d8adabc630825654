// SPDX-License-Identifier: Apache-2.0
// Internal to image/: the channels of a file with several parts.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace vug::image {

/// The channels of one part; the names may be empty.
struct PartChannels {
  std::string name, view;
  std::vector<std::string> channels;
};

/// Channels of all parts. Those of a view other than the first are prefixed with its name, as in
/// files with several views in one part; other duplicate names are prefixed with the name of their
/// part, or with "part".
std::vector<std::string> channel_names(const std::vector<PartChannels>& parts);
size_t total_channels(const std::vector<PartChannels>& parts);

/// Throws Error(bad_input) for sizes that only a broken header can state.
void require_reasonable_size(const std::filesystem::path& path, int width, int height,
                             size_t channels);

}  // namespace vug::image
