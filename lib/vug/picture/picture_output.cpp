// SPDX-License-Identifier: Apache-2.0
#include <vug/picture/picture_output.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>

namespace vug::picture {
namespace {

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

}  // namespace

shot::NamedTexts to_header_attributes(const PictureOutput& output) {
  shot::NamedTexts attributes = shot::to_texts(output.settings);
  attributes.emplace_back(kConfig, output.config.string());
  if (output.camera) {
    attributes.emplace_back(kToCamera, matrix_text(output.camera->world_to_camera));
    if (output.camera->world_to_ndc)
      attributes.emplace_back(kToNdc, matrix_text(*output.camera->world_to_ndc));
  }
  for (const auto& [name, text] : output.metadata) attributes.emplace_back(kMetadata + name, text);
  return attributes;
}

PictureOutput from_header_attributes(const shot::NamedTexts& attributes) {
  PictureOutput output;
  output.settings = shot::from_texts(attributes);
  for (const auto& [name, text] : attributes) {
    if (name == kConfig) output.config = text;
    if ((name == kToCamera || name == kToNdc) && !output.camera) output.camera.emplace();
    if (name == kToCamera) output.camera->world_to_camera = read_matrix(text);
    if (name == kToNdc) output.camera->world_to_ndc = read_matrix(text);
    if (name.rfind(kMetadata, 0) == 0)
      output.metadata.emplace_back(name.substr(std::string(kMetadata).size()), text);
  }
  return output;
}

}  // namespace vug::picture
