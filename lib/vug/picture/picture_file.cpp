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

/// The denoised layer as a picture of its own.
image::Image as_colour(image::Image smooth) {
  smooth.channels = {"R", "G", "B"};
  return smooth;
}

void write_png(const std::filesystem::path& png, const image::Image& image,
               const PictureLook& look) {
  image::ViewOptions view = image::view_options(look.view, look.space);
  view.exposure = look.exposure;
  image::write_png(png, image, view);
}

image::ExrOptions exr_options(const PictureLook& look, const render::PartHeader& header) {
  image::ExrOptions options;
  options.half = look.half;
  options.parts = look.multi_part;
  options.tiles = look.tiled;
  options.space = look.space;
  if (look.camera) {
    options.world_to_camera = look.camera->world_to_camera;
    options.world_to_ndc = look.camera->world_to_ndc;
  }
  options.metadata = look.metadata;
  options.window = {header.crop.x0, header.crop.y0, header.width, header.height};
  return options;
}

/// With what the layers ask for.
image::ExrOptions layered_options(const PictureLook& look, const render::PartHeader& header) {
  image::ExrOptions options = exr_options(look, header);
  for (const auto& entry : render::crypto_metadata(header.layers))
    options.metadata.push_back(entry);
  options.full_channels.insert(
      options.full_channels.end(),
      {render::kCryptoObject, render::kCryptoMaterial, render::kCryptoElement, render::kMotion});
  for (const render::LayerAttribute& attribute : header.layers.attributes)
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

/// What denoising a view makes of it; nothing where its look does not ask for it.
struct Denoised {
  std::optional<image::Image> layers, shown;
};

std::vector<Denoised> denoised(const std::vector<PictureView>& views) {
  std::vector<Denoised> out(views.size());
  for (size_t i = 0; i < views.size(); ++i) {
    if (!from_notes(views[i].header.notes).denoise) continue;
    image::Image smooth = image::denoise(views[i].image);
    out[i].layers = image::joined(views[i].image, smooth);
    out[i].shown = as_colour(std::move(smooth));
  }
  return out;
}

/// Of each view: its name in files, "left" and "right" of two.
std::string view_name(const std::vector<PictureView>& views, size_t i) {
  return views.size() == 1 ? "" : i == 0 ? "left" : "right";
}

void write_layers(const std::filesystem::path& exr, const std::vector<PictureView>& views,
                  const std::vector<Denoised>& smooth) {
  std::vector<image::ExrView> parts;
  for (size_t i = 0; i < views.size(); ++i)
    parts.push_back({view_name(views, i), smooth[i].layers ? *smooth[i].layers : views[i].image,
                     layered_options(from_notes(views[i].header.notes), views[i].header)});
  image::write_exr(exr, parts);
}

void write_shown(const std::filesystem::path& png, const std::vector<PictureView>& views,
                 const std::vector<Denoised>& smooth) {
  const auto shown = [&](size_t i) -> const image::Image& {
    return smooth[i].shown ? *smooth[i].shown : views[i].image;
  };
  const PictureLook look = from_notes(views.front().header.notes);
  if (views.size() == 1) return write_png(png, shown(0), look);
  write_png(png, side_by_side(shown(0), shown(1)), look);
}

bool has_deep(const std::vector<PictureView>& views) { return views.front().deep != nullptr; }

void write_deep(const std::filesystem::path& file, const std::vector<PictureView>& views) {
  std::vector<image::DeepView> deep;
  for (size_t i = 0; i < views.size(); ++i)
    deep.push_back({view_name(views, i), *views[i].deep,
                    exr_options(from_notes(views[i].header.notes), views[i].header)});
  image::write_deep_exr(file, deep);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> to_notes(const PictureLook& look) {
  std::vector<std::pair<std::string, std::string>> notes = {
      {kExposure, fmt::format("{}", look.exposure)},
      {kHalf, look.half ? "true" : "false"},
      {kMultiPart, look.multi_part ? "true" : "false"},
      {kTiled, look.tiled ? "true" : "false"}};
  notes.emplace_back(kDenoise, look.denoise ? "true" : "false");
  notes.emplace_back(kSpace, image::info(look.space).name);
  notes.emplace_back(kView, look.view.view);
  notes.emplace_back(kDisplay, look.view.display);
  notes.emplace_back(kConfig, look.view.config.string());
  if (look.camera) {
    notes.emplace_back(kToCamera, matrix_text(look.camera->world_to_camera));
    if (look.camera->world_to_ndc)
      notes.emplace_back(kToNdc, matrix_text(*look.camera->world_to_ndc));
  }
  for (const auto& [name, text] : look.metadata) notes.emplace_back(kMetadata + name, text);
  return notes;
}

PictureLook from_notes(const std::vector<std::pair<std::string, std::string>>& notes) {
  PictureLook look;
  for (const auto& [name, text] : notes) {
    if (name == kExposure) look.exposure = std::strtod(text.c_str(), nullptr);
    if (name == kHalf) look.half = text == "true";
    if (name == kMultiPart) look.multi_part = text == "true";
    if (name == kTiled) look.tiled = text == "true";
    if (name == kDenoise) look.denoise = text == "true";
    if (name == kSpace)
      for (const image::WorkingSpaceInfo& each : image::working_spaces())
        if (each.name == text) look.space = each.space;
    if (name == kView) look.view.view = text;
    if (name == kDisplay) look.view.display = text;
    if (name == kConfig) look.view.config = text;
    if ((name == kToCamera || name == kToNdc) && !look.camera) look.camera.emplace();
    if (name == kToCamera) look.camera->world_to_camera = read_matrix(text);
    if (name == kToNdc) look.camera->world_to_ndc = read_matrix(text);
    if (name.rfind(kMetadata, 0) == 0)
      look.metadata.emplace_back(name.substr(std::string(kMetadata).size()), text);
  }
  return look;
}

std::filesystem::path png_beside(const std::filesystem::path& exr) {
  return std::filesystem::path(exr).replace_extension(".png");
}

std::filesystem::path deep_beside(const std::filesystem::path& exr) {
  return std::filesystem::path(exr).replace_extension(".deep.exr");
}

std::vector<std::filesystem::path> write_picture(const std::filesystem::path& exr,
                                                 const std::vector<PictureView>& views) {
  const std::vector<Denoised> smooth = denoised(views);
  write_layers(exr, views, smooth);
  write_shown(png_beside(exr), views, smooth);
  if (!has_deep(views)) return {exr, png_beside(exr)};
  write_deep(deep_beside(exr), views);
  return {exr, png_beside(exr), deep_beside(exr)};
}

void write_picture_file(const std::filesystem::path& file, const std::vector<PictureView>& views) {
  const std::string name = file.filename().string(), extension = extension_of(file);
  if (extension == ".png") return write_shown(file, views, denoised(views));
  if (extension != ".exr")
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is no name for a picture", file.string()),
                {}, "end it in .exr for all layers, or in .png for what an eye sees");
  constexpr std::string_view kDeep = ".deep.exr";
  if (name.size() < kDeep.size() || name.substr(name.size() - kDeep.size()) != kDeep)
    return write_layers(file, views, denoised(views));
  if (!has_deep(views))
    throw Error(ErrorCode::bad_input, "the picture was not rendered deep", {},
                "ask for a deep picture when it is rendered");
  write_deep(file, views);
}

void write_preview(const std::filesystem::path& png, const image::Image& image,
                   const render::PartHeader& header) {
  const PictureLook look = from_notes(header.notes);
  write_png(png, look.denoise ? as_colour(image::denoise(image)) : image, look);
}

}  // namespace vug::picture
