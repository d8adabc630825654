// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/image/denoise.h>
#include <vug/image/views.h>
#include <vug/picture/exposure.h>
#include <vug/picture/picture_file.h>
#include <vug/render/film/cryptomatte.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::picture {
namespace {

/// The denoised AOV as a picture of its own.
image::Image as_colour(image::Image smooth) {
  smooth.channels = {"R", "G", "B"};
  return smooth;
}

void write_png(const std::filesystem::path& png, const image::Image& image,
               const PictureOutput& output, double exposure) {
  image::ViewOptions view = image::view_options(output.view(), output.settings.working_space);
  view.exposure = exposure;
  image::write_png(png, image, view);
}

image::ExrOptions exr_options(const PictureView& view, double exposure) {
  const shot::OutputSettings& settings = view.output.settings;
  image::ExrOptions options;
  options.half = settings.half;
  options.parts = settings.multi_part;
  options.tiles = settings.tiled;
  options.space = settings.working_space;
  if (const auto& camera = view.output.camera) {
    options.world_to_camera = camera->world_to_camera;
    options.world_to_ndc = camera->world_to_ndc;
  }
  options.metadata = view.output.metadata;
  options.metadata.emplace_back(kExposure, fmt::format("{}", exposure));
  const render::PartialRenderHeader& header = view.header;
  options.window = {header.crop.x0, header.crop.y0, header.width, header.height};
  return options;
}

/// EXR options with the metadata and channel formats required by the AOVs.
image::ExrOptions layered_options(const PictureView& view, double exposure) {
  image::ExrOptions options = exr_options(view, exposure);
  const render::AovPlan& aovs = view.header.aovs;
  for (const auto& entry : render::crypto_metadata(aovs)) options.metadata.push_back(entry);
  options.full_channels.insert(
      options.full_channels.end(),
      {render::kCryptoObject, render::kCryptoMaterial, render::kCryptoElement, render::kMotion});
  for (const render::AovAttribute& attribute : aovs.attributes)
    options.full_channels.push_back("attribute_" + attribute.name);
  return options;
}

image::Image side_by_side(const image::Image& left, const image::Image& right) {
  image::Image out(left.width + right.width, left.height, left.channels);
  const auto line = static_cast<size_t>(left.width) * left.channels.size();
  for (int y = 0; y < left.height; ++y) {
    std::copy_n(&left.pixels[left.index(0, y)], line, &out.pixels[out.index(0, y)]);
    std::copy_n(&right.pixels[right.index(0, y)], line, &out.pixels[out.index(left.width, y)]);
  }
  return out;
}

/// The results of denoising a view; empty if its settings do not request it.
struct DenoisedView {
  std::optional<image::Image> layers, shown;
};

std::vector<DenoisedView> denoise_views(const std::vector<PictureView>& views,
                                        Progress& progress = Progress::none()) {
  std::vector<DenoisedView> out(views.size());
  for (size_t i = 0; i < views.size(); ++i) {
    if (!views[i].output.settings.denoise) continue;
    image::Image smooth = image::denoise(views[i].image, {}, progress);
    out[i].layers = image::joined(views[i].image, smooth);
    out[i].shown = as_colour(std::move(smooth));
  }
  return out;
}

/// The name of a view in files: "left" or "right" for stereo pictures, else empty.
std::string view_name(const std::vector<PictureView>& views, size_t i) {
  return views.size() == 1 ? "" : i == 0 ? "left" : "right";
}

/// The exposure of all views in stops: that of the first one.
double common_exposure(const std::vector<PictureView>& views) {
  return exposure_stops(views.front().output.settings, views.front().image);
}

void write_layers(const std::filesystem::path& exr, const std::vector<PictureView>& views,
                  const std::vector<DenoisedView>& smooth, double exposure) {
  std::vector<image::ExrView> parts;
  for (size_t i = 0; i < views.size(); ++i)
    parts.push_back({view_name(views, i), smooth[i].layers ? *smooth[i].layers : views[i].image,
                     layered_options(views[i], exposure)});
  image::write_exr(exr, parts);
}

void write_png_views(const std::filesystem::path& png, const std::vector<PictureView>& views,
                     const std::vector<DenoisedView>& smooth, double exposure) {
  const PictureOutput& output = views.front().output;
  const auto shown = [&](size_t i) -> const image::Image& {
    return smooth[i].shown ? *smooth[i].shown : views[i].image;
  };
  if (views.size() == 1) return write_png(png, shown(0), output, exposure);
  write_png(png, side_by_side(shown(0), shown(1)), output, exposure);
}

bool has_deep(const std::vector<PictureView>& views) { return views.front().deep != nullptr; }

void write_deep(const std::filesystem::path& file, const std::vector<PictureView>& views,
                double exposure) {
  std::vector<image::DeepView> deep;
  for (size_t i = 0; i < views.size(); ++i)
    deep.push_back({view_name(views, i), *views[i].deep, exr_options(views[i], exposure)});
  image::write_deep_exr(file, deep);
}

}  // namespace

std::filesystem::path png_path(const std::filesystem::path& exr) {
  return std::filesystem::path(exr).replace_extension(".png");
}

std::filesystem::path deep_path(const std::filesystem::path& exr) {
  return std::filesystem::path(exr).replace_extension(".deep.exr");
}

std::vector<std::filesystem::path> write_picture(const std::filesystem::path& exr,
                                                 const std::vector<PictureView>& views,
                                                 Progress& progress) {
  const std::vector<DenoisedView> smooth = denoise_views(views, progress);
  progress.begin("writing the picture");
  const double exposure = common_exposure(views);
  write_layers(exr, views, smooth, exposure);
  write_png_views(png_path(exr), views, smooth, exposure);
  std::vector<std::filesystem::path> files{exr, png_path(exr)};
  if (has_deep(views)) write_deep(files.emplace_back(deep_path(exr)), views, exposure);
  progress.end();
  return files;
}

void write_picture_file(const std::filesystem::path& file, const std::vector<PictureView>& views) {
  const std::string name = file.filename().string(), extension = extension_of(file);
  const double exposure = common_exposure(views);
  if (extension == ".png") return write_png_views(file, views, denoise_views(views), exposure);
  if (extension != ".exr")
    throw Error(ErrorCode::bad_input, fmt::format("invalid picture name '{}'", file.string()), {},
                "use the extension .exr for all layers, or .png for the displayed picture");
  constexpr std::string_view kDeep = ".deep.exr";
  if (name.size() < kDeep.size() || name.substr(name.size() - kDeep.size()) != kDeep)
    return write_layers(file, views, denoise_views(views), exposure);
  if (!has_deep(views))
    throw Error(ErrorCode::bad_input, "the picture has no deep image", {},
                "request a deep picture when rendering it");
  write_deep(file, views, exposure);
}

void write_preview(const std::filesystem::path& png, const image::Image& image,
                   const PictureOutput& output) {
  write_png(png, output.settings.denoise ? as_colour(image::denoise(image)) : image, output,
            exposure_stops(output.settings, image));
}

}  // namespace vug::picture
