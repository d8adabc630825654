// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/picture/picture_file.h>

namespace vug::cli {
namespace {

struct MergeOptions {
  std::vector<std::string> parts;
  std::string output;
  WorkOptions work;
};

int run_merge(const MergeOptions& options) {
  require_extension(options.output, ".exr", "the picture is an EXR; a PNG is written next to it");
  const std::vector<std::filesystem::path> paths(options.parts.begin(), options.parts.end());
  std::vector<std::filesystem::path> outputs = {options.output, picture::png_path(options.output)};
  if (render::read_partial_render_info(paths.front()).header.deep)
    outputs.push_back(picture::deep_path(options.output));
  require_outputs(outputs, paths);
  Progress& progress = terminal_progress(options.work.bar_mode());
  const render::PartialRender whole = render::merge(paths, progress);
  const image::Image image = render::develop(whole.state, whole.header.aovs);
  std::optional<image::DeepImage> deep;
  if (whole.header.deep) deep = render::develop(whole.state, *whole.header.deep);
  const picture::PictureOutput output = picture::from_header_attributes(whole.header.notes);
  const picture::PictureView view{image, whole.header, output, deep ? &*deep : nullptr};
  for (const auto& path : picture::write_picture(options.output, {view}, progress))
    fmt::print("{}\n", path.string());
  return kDone;
}

}  // namespace

Verb merge_verb() {
  return {
      "merge", "Merges the partial renders written by `vug render --part` into a picture.",
      [](CLI::App& app) {
        auto options = std::make_shared<MergeOptions>();
        app.add_option("parts", options->parts, "All partial renders of one picture")->required();
        app.add_option("-o,--output", options->output, "Output file, an .exr")->required();
        options->work.add_to(app);
        return [options] { return run_merge(*options); };
      }};
}

}  // namespace vug::cli
