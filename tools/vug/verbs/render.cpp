#include "bar.h"
#include "load.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/session/picture.h>
#include <vug/session/write.h>

#include <charconv>
#include <cmath>

namespace vug::cli {
namespace {

struct Options {
  SceneOptions scene;
  WorkOptions work;
  std::string output;
  std::string products;
  std::string size;
  session::PictureOptions picture;
  std::optional<double> exposure;
  bool full_float = false;
};

/// "1920x1080".
Vec2i parse_size(const std::string& text) {
  Vec2i size(0, 0);
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.x);
  if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, size.y);
    if (height.ec == std::errc() && height.ptr == end && size.x > 0 && size.y > 0) return size;
  }
  throw Error(ErrorCode::bad_input, fmt::format("'{}' is no size", text), {},
              "write --size 1920x1080");
}

/// A first picture of a scene is often black or white, and its light not to be guessed.
void warn_of_exposure(const session::Builder& builder, const session::Picture& picture,
                      double exposure) {
  constexpr double kOff = 5;  // stops
  const std::optional<double> grey = image::grey_exposure(picture.image);
  if (grey && std::fabs(*grey - exposure) <= kOff) return;
  builder.warn(picture.plan.where,
               !grey              ? "no light reaches the picture"
               : *grey > exposure ? "the picture is very dark"
                                  : "the picture is very bright",
               grey ? fmt::format("--exposure {:.1f} would show its middle as grey", *grey)
                    : "put a light where the camera looks, or a sky behind an opening");
}

int run(Options options) {
  if (options.exposure && !(std::fabs(*options.exposure) <= 30))
    throw Error(ErrorCode::bad_input,
                fmt::format("an exposure of {} stops is out of range", *options.exposure), {},
                "write --exposure and a number from -30 to 30");
  const std::filesystem::path exr = options.output;
  if (extension_of(exr) != ".exr")
    throw Error(ErrorCode::bad_input, fmt::format("'{}' does not end in .exr", options.output), {},
                "the picture is an EXR; a PNG is written beside it");
  if (!options.size.empty()) options.picture.size = parse_size(options.size);
  options.picture.seed = options.scene.seed;
  const session::Loaded loaded = options.scene.load();
  const std::filesystem::path png = std::filesystem::path(exr).replace_extension(".png");
  std::vector<std::filesystem::path> outputs = {exr, png};
  if (!options.products.empty())
    for (auto& path : session::product_paths(loaded.shot, options.products))
      outputs.push_back(std::move(path));
  for (const auto& path : outputs) require_writable(path);
  const ThreadLimit threads(options.work.threads);
  session::Builder builder(loaded.shot, options.work.build_options(loaded),
                           terminal_progress(options.work.bar()));
  const session::Picture picture = session::render_picture(builder, options.picture);
  image::ExrOptions exr_options;
  exr_options.half = picture.plan.half && !options.full_float;
  exr_options.metadata = picture.metadata;
  image::write_exr(exr, picture.image, exr_options);
  image::ViewOptions view;
  view.exposure = options.exposure.value_or(picture.plan.exposure);
  warn_of_exposure(builder, picture, view.exposure);
  image::write_png(png, picture.image, view);
  fmt::print("{}\n{}\n", exr.string(), png.string());
  if (!options.products.empty())
    for (const auto& path : session::write_products(builder, options.products))
      fmt::print("{}\n", path.string());
  options.work.summarise(builder);
  return kDone;
}

}  // namespace

Verb render_verb() {
  return {"render", "Renders a picture: an EXR with layers, and a PNG beside it.",
          [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            options->scene.add_to(app);
            app.add_option("-o,--output", options->output, "the .exr to write")->required();
            app.add_option("--products", options->products,
                           "a folder for what `vug build` would make, too");
            app.add_option("--spp", options->picture.spp, "samples per pixel")
                ->check(CLI::Range(1, 1 << 20));
            app.add_option("--size", options->size, "WIDTHxHEIGHT in pixels");
            app.add_option("--camera", options->picture.camera, "which camera");
            app.add_option("--render", options->picture.render, "which render block");
            app.add_option("--exposure", options->exposure, "stops, for the PNG");
            app.add_flag("--float", options->full_float, "32-bit colour channels");
            options->work.add_to(app);
            return [options] { return run(*options); };
          }};
}

}  // namespace vug::cli
