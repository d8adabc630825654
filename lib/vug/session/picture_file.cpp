#include <vug/session/picture_file.h>

#include <fmt/format.h>

#include <cstdlib>

namespace vug::session {
namespace {

constexpr const char* kExposure = "exposure";
constexpr const char* kHalf = "half";
constexpr const char* kMetadata = "metadata:";

}  // namespace

std::vector<std::pair<std::string, std::string>> to_notes(const PictureLook& look) {
  std::vector<std::pair<std::string, std::string>> notes = {
      {kExposure, fmt::format("{}", look.exposure)}, {kHalf, look.half ? "true" : "false"}};
  for (const auto& [name, text] : look.metadata) notes.emplace_back(kMetadata + name, text);
  return notes;
}

PictureLook from_notes(const std::vector<std::pair<std::string, std::string>>& notes) {
  PictureLook look;
  for (const auto& [name, text] : notes) {
    if (name == kExposure) look.exposure = std::strtod(text.c_str(), nullptr);
    if (name == kHalf) look.half = text == "true";
    if (name.rfind(kMetadata, 0) == 0)
      look.metadata.emplace_back(name.substr(std::string(kMetadata).size()), text);
  }
  return look;
}

std::filesystem::path png_beside(const std::filesystem::path& exr) {
  return std::filesystem::path(exr).replace_extension(".png");
}

std::vector<std::filesystem::path> write_picture(const std::filesystem::path& exr,
                                                 const image::Image& image,
                                                 const render::PartHeader& header) {
  const PictureLook look = from_notes(header.notes);
  image::ExrOptions options;
  options.half = look.half;
  options.metadata = look.metadata;
  options.window = {header.crop.x0, header.crop.y0, header.width, header.height};
  image::write_exr(exr, image, options);
  write_preview(png_beside(exr), image, header);
  return {exr, png_beside(exr)};
}

void write_preview(const std::filesystem::path& png, const image::Image& image,
                   const render::PartHeader& header) {
  image::ViewOptions view;
  view.exposure = from_notes(header.notes).exposure;
  image::write_png(png, image, view);
}

}  // namespace vug::session
