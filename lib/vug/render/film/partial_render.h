// SPDX-License-Identifier: Apache-2.0
// The file format of partial renders and checkpoints.
#pragma once

#include <vug/render/film/render_state.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug::render {

/// The properties that all partial renders of one picture share.
struct PartialRenderHeader {
  std::string
      identity;  ///< Hash of the scene, program version and settings, which determine the pixels.
  int width = 0, height = 0, spp = 0;
  uint64_t seed = 0;
  Region crop;  ///< The pixels to be rendered.
  double noise = 0;
  AovPlan aovs;
  std::optional<DeepOptions> deep;  ///< See Options::deep.
  /// Header attributes for the writer of the picture; they must also agree.
  std::vector<std::pair<std::string, std::string>> notes;

  bool operator==(const PartialRenderHeader&) const = default;
};

PartialRenderHeader partial_render_header(const Options& options);
/// Describes the difference between two headers ("seeds, 1 and 2"); empty if they are equal.
std::string difference(const PartialRenderHeader& a, const PartialRenderHeader& b);

struct PartialRender {
  PartialRenderHeader header;
  RenderState state;
};

/// A partial render without its sums.
struct PartialRenderInfo {
  PartialRenderHeader header;
  Region region;
  uint32_t begin = 0, end = 0;  ///< Range of samples.
  double fraction = 0;          ///< Completed fraction of these samples.
  uint64_t samples_left = 0;    ///< Sum over all its pixels, at most.
};

/// Writes a file: format version, header, sums, and a hash of everything. The file is complete or
/// absent (AtomicFile). About 200 bytes per pixel and, for deep pictures, 24 bytes per sample.
/// Throws Error(io).
void write_partial_render(const std::filesystem::path& path, const PartialRenderHeader& header,
                          const RenderState& state);

/// Throws Error(bad_input) with the file, `what` it should be, and the fault: missing, not a
/// partial render, another version, truncated or changed.
PartialRender read_partial_render(const std::filesystem::path& path,
                                  const std::string& what = "part");
PartialRenderInfo read_partial_render_info(const std::filesystem::path& path);

/// True if the file starts like a partial render; false if it cannot be read.
bool is_partial_render(const std::filesystem::path& path);
/// Reads the whole file and discards it. Throws as read_partial_render does.
void verify_partial_render(const std::filesystem::path& path);

/// Combines the partial renders of one picture. They must not overlap and must cover it completely.
/// Error(bad_input) names the files that do not match and their difference, or the missing or
/// duplicate samples. Needs memory for the sums of the whole picture and of one partial render.
PartialRender merge(const std::vector<std::filesystem::path>& paths,
                    Progress& progress = Progress::none());

}  // namespace vug::render
