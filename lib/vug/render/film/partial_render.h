// Parts of a picture as files: what a render farm's machines write and `merge` puts together, and
// what a render that was killed goes on from.
#pragma once

#include <vug/render/film/render_state.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace vug::render {

/// What all parts of one picture agree in.
struct PartialRenderHeader {
  std::string identity;  ///< Of scene, program and settings: pictures of others have other pixels.
  int width = 0, height = 0, spp = 0;
  uint64_t seed = 0;
  Region crop;  ///< The pixels of the picture that are wanted.
  double noise = 0;
  AovPlan aovs;
  /// For whoever writes the picture; parts agree in them, too.
  std::vector<std::pair<std::string, std::string>> notes;

  bool operator==(const PartialRenderHeader&) const = default;
};

PartialRenderHeader partial_render_header(const Options& options);
/// In what two headers differ, as people call it ("seeds, 1 and 2"); empty when they do not.
std::string difference(const PartialRenderHeader& a, const PartialRenderHeader& b);

struct PartialRender {
  PartialRenderHeader header;
  RenderState state;
};

/// A part without its sums.
struct PartialRenderInfo {
  PartialRenderHeader header;
  Region region;
  uint32_t begin = 0, end = 0;  ///< Samples.
  double fraction = 0;          ///< Done, of these.
  uint64_t samples_left = 0;    ///< Of all its pixels together, at most.
};

/// A file with a format of its own: version, header, sums, and a hash over all of it; whole or not
/// there (AtomicFile). About 200 bytes for each pixel. Throws Error(io).
void write_partial_render(const std::filesystem::path& path, const PartialRenderHeader& header,
                          const RenderState& state);

/// Error(bad_input) names the file, `what` it should be, and what is wrong with it: missing, no
/// part, of another version, cut short or changed.
PartialRender read_partial_render(const std::filesystem::path& path,
                                  const std::string& what = "part");
PartialRenderInfo read_partial_render_info(const std::filesystem::path& path);

/// Whether the file begins like a part; false where it cannot be read.
bool is_partial_render(const std::filesystem::path& path);
/// Reads all of a part and keeps none of it. Errors as read_partial_render.
void verify_partial_render(const std::filesystem::path& path);

/// Puts the parts of one picture together. They may overlap nowhere and must leave nothing out.
/// Error(bad_input) says which files do not belong together and in what they differ, what is
/// missing and what is there twice. Holds the whole picture's sums and those of one part.
PartialRender merge(const std::vector<std::filesystem::path>& paths,
                    Progress& progress = Progress::none());

}  // namespace vug::render
