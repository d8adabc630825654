// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/image/denoise.h>
#include <vug/image/views.h>
#include <vug/picture/picture_file.h>
#include <vug/render/film/cryptomatte.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace vug::picture {
namespace {

constexpr const char* kExposure = "exposure";
constexpr const char* kHalf = "half";
constexpr const char* kMultiPart = "multi_part";
constexpr const char* kTiled = "tiled";
constexpr const char* kDenoise = "denoise";
constexpr const char* kSpace = "working_space";
constexpr const char* kView = "view";
constexpr const char* kDisplay = "display";
constexpr const char* kConfig = "colour_config";
constexpr const char* kToCamera = "world_to_camera";
constexpr const char* kToNdc = "world_to_ndc";
constexpr const char* kMetadata = "metadata:";

std::string matrix_text(const std::array<float, 16>& matrix) {
  return fmt::format("{}", fmt::join(matrix, " "));
}

std::array<float, 16> read_matrix(const std::string& text) {
  std::array<float, 16> matrix{};
  const char* at = text.c_str();
  for (float& v : matrix) {
    char* end = nullptr;
    v = std::strtof(at, &end);
    at = end;
  }
  return matrix;
}

/// The denoised AOV as a picture of its own.
image::Image as_colour(image::Image smooth) {
  smooth.channels = {"R", "G", "B"};
  return smooth;
}

void write_png(const std::filesystem::path& png, const image::Image& image,
               const OutputSettings& settings) {
  image::ViewOptions view = image::view_options(settings.view, settings.space);
  view.exposure = settings.exposure;
  image::write_png(png, image, view);
}

image::ExrOptions exr_options(const OutputSettings& settings,
                              const render::PartialRenderHeader& header) {
  image::ExrOptions options;
  options.half = settings.half;
  options.parts = settings.multi_part;
  options.tiles = settings.tiled;
  options.space = settings.space;
  if (settings.camera) {
    options.world_to_camera = settings.camera->world_to_camera;
    options.world_to_ndc = settings.camera->world_to_ndc;
  }
  options.metadata = settings.metadata;
  options.window = {header.crop.x0, header.crop.y0, header.width, header.height};
  return options;
}

/// EXR options with the metadata and channel formats required by the AOVs.
image::ExrOptions layered_options(const OutputSettings& settings,
                                  const render::PartialRenderHeader& header) {
  image::ExrOptions options = exr_options(settings, header);
  for (const auto& entry : render::crypto_metadata(header.aovs)) options.metadata.push_back(entry);
  options.full_channels.insert(
      options.full_channels.end(),
      {render::kCryptoObject, render::kCryptoMaterial, render::kCryptoElement, render::kMotion});
  for (const render::AovAttribute& attribute : header.aovs.attributes)
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

std::vector<DenoisedView> denoise_views(const std::vector<PictureView>& views) {
  std::vector<DenoisedView> out(views.size());
  for (size_t i = 0; i < views.size(); ++i) {
    if (!from_header_attributes(views[i].header.notes).denoise) continue;
    image::Image smooth = image::denoise(views[i].image);
    out[i].layers = image::joined(views[i].image, smooth);
    out[i].shown = as_colour(std::move(smooth));
  }
  return out;
}

/// The name of a view in files: "left" or "right" for stereo pictures, else empty.
std::string view_name(const std::vector<PictureView>& views, size_t i) {
  return views.size() == 1 ? "" : i == 0 ? "left" : "right";
}

void write_layers(const std::filesystem::path& exr, const std::vector<PictureView>& views,
                  const std::vector<DenoisedView>& smooth) {
  std::vector<image::ExrView> parts;
  for (size_t i = 0; i < views.size(); ++i)
    parts.push_back(
        {view_name(views, i), smooth[i].layers ? *smooth[i].layers : views[i].image,
         layered_options(from_header_attributes(views[i].header.notes), views[i].header)});
  image::write_exr(exr, parts);
}

void write_png_views(const std::filesystem::path& png, const std::vector<PictureView>& views,
                     const std::vector<DenoisedView>& smooth) {
  const auto shown = [&](size_t i) -> const image::Image& {
    return smooth[i].shown ? *smooth[i].shown : views[i].image;
  };
  const OutputSettings settings = from_header_attributes(views.front().header.notes);
  if (views.size() == 1) return write_png(png, shown(0), settings);
  write_png(png, side_by_side(shown(0), shown(1)), settings);
}

bool has_deep(const std::vector<PictureView>& views) { return views.front().deep != nullptr; }

void write_deep(const std::filesystem::path& file, const std::vector<PictureView>& views) {
  std::vector<image::DeepView> deep;
  for (size_t i = 0; i < views.size(); ++i)
    deep.push_back({view_name(views, i), *views[i].deep,
                    exr_options(from_header_attributes(views[i].header.notes), views[i].header)});
  image::write_deep_exr(file, deep);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> to_header_attributes(
    const OutputSettings& settings) {
  std::vector<std::pair<std::string, std::string>> notes = {
      {kExposure, fmt::format("{}", settings.exposure)},
      {kHalf, settings.half ? "true" : "false"},
      {kMultiPart, settings.multi_part ? "true" : "false"},
      {kTiled, settings.tiled ? "true" : "false"}};
  notes.emplace_back(kDenoise, settings.denoise ? "true" : "false");
  notes.emplace_back(kSpace, image::info(settings.space).name);
  notes.emplace_back(kView, settings.view.view);
  notes.emplace_back(kDisplay, settings.view.display);
  notes.emplace_back(kConfig, settings.view.config.string());
  if (settings.camera) {
    notes.emplace_back(kToCamera, matrix_text(settings.camera->world_to_camera));
    if (settings.camera->world_to_ndc)
      notes.emplace_back(kToNdc, matrix_text(*settings.camera->world_to_ndc));
  }
  for (const auto& [name, text] : settings.metadata) notes.emplace_back(kMetadata + name, text);
  return notes;
}

OutputSettings from_header_attributes(
    const std::vector<std::pair<std::string, std::string>>& notes) {
  OutputSettings settings;
  for (const auto& [name, text] : notes) {
    if (name == kExposure) settings.exposure = std::strtod(text.c_str(), nullptr);
    if (name == kHalf) settings.half = text == "true";
    if (name == kMultiPart) settings.multi_part = text == "true";
    if (name == kTiled) settings.tiled = text == "true";
    if (name == kDenoise) settings.denoise = text == "true";
    if (name == kSpace)
      for (const image::WorkingSpaceInfo& each : image::working_spaces())
        if (each.name == text) settings.space = each.space;
    if (name == kView) settings.view.view = text;
    if (name == kDisplay) settings.view.display = text;
    if (name == kConfig) settings.view.config = text;
    if ((name == kToCamera || name == kToNdc) && !settings.camera) settings.camera.emplace();
    if (name == kToCamera) settings.camera->world_to_camera = read_matrix(text);
    if (name == kToNdc) settings.camera->world_to_ndc = read_matrix(text);
    if (name.rfind(kMetadata, 0) == 0)
      settings.metadata.emplace_back(name.substr(std::string(kMetadata).size()), text);
  }
  return settings;
}

std::filesystem::path png_path(const std::filesystem::path& exr) {
  return std::filesystem::path(exr).replace_extension(".png");
}

std::filesystem::path deep_path(const std::filesystem::path& exr) {
  return std::filesystem::path(exr).replace_extension(".deep.exr");
}

std::vector<std::filesystem::path> write_picture(const std::filesystem::path& exr,
                                                 const std::vector<PictureView>& views) {
  const std::vector<DenoisedView> smooth = denoise_views(views);
  write_layers(exr, views, smooth);
  write_png_views(png_path(exr), views, smooth);
  if (!has_deep(views)) return {exr, png_path(exr)};
  write_deep(deep_path(exr), views);
  return {exr, png_path(exr), deep_path(exr)};
}

void write_picture_file(const std::filesystem::path& file, const std::vector<PictureView>& views) {
  const std::string name = file.filename().string(), extension = extension_of(file);
  if (extension == ".png") return write_png_views(file, views, denoise_views(views));
  if (extension != ".exr")
    throw Error(ErrorCode::bad_input, fmt::format("invalid picture name '{}'", file.string()), {},
                "use the extension .exr for all layers, or .png for the displayed picture");
  constexpr std::string_view kDeep = ".deep.exr";
  if (name.size() < kDeep.size() || name.substr(name.size() - kDeep.size()) != kDeep)
    return write_layers(file, views, denoise_views(views));
  if (!has_deep(views))
    throw Error(ErrorCode::bad_input, "the picture has no deep image", {},
                "request a deep picture when rendering it");
  write_deep(file, views);
}

void write_preview(const std::filesystem::path& png, const image::Image& image,
                   const render::PartialRenderHeader& header) {
  const OutputSettings settings = from_header_attributes(header.notes);
  write_png(png, settings.denoise ? as_colour(image::denoise(image)) : image, settings);
}

}  // namespace vug::picture
