// SPDX-License-Identifier: Apache-2.0
// Reference pictures of image cases and their histories.
#include "image_case.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/image/views.h>

#include <algorithm>

namespace vug::cli {
namespace {

std::string hash_of_file(const std::filesystem::path& file) {
  return digest(read_text(file)).hex();
}

std::string last_line(const std::string& text) {
  const size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return "";
  const size_t start = text.rfind('\n', end);
  return text.substr(start == std::string::npos ? 0 : start + 1, end + 1 - (start + 1));
}

bool kept(const image::Layer& layer, const std::vector<std::string>& compared) {
  return layer.name == image::kVariance || layer.name == "samples" ||
         std::find(compared.begin(), compared.end(), layer.name) != compared.end();
}

/// Writes the compared layers only, because references are kept for years.
void store(const image::ImageUnderTest& subject, const image::FileInfo& info,
           const ImageCase& image_case) {
  std::vector<std::string> channels;
  for (const image::View& view : image::views_of(subject.image.channels)) {
    std::vector<std::string> compared;
    for (const std::string& layer : image_case.diff.layers)
      compared.push_back(image::layer_in(view, layer).value_or(""));
    for (const image::Layer& layer : image::layers_of(view.channels))
      if (kept(layer, compared))
        for (const std::string& channel : layer.channels) channels.push_back(view.full(channel));
  }
  image::ExrOptions options;
  options.half = std::find(info.formats.begin(), info.formats.end(), "half") != info.formats.end();
  for (const auto& entry : subject.metadata)
    if (entry.first.rfind("vug:", 0) == 0) options.metadata.push_back(entry);
  image::write_exr(image_case.reference, subject.image.select(channels), options);
}

}  // namespace

std::filesystem::path history_of(const std::filesystem::path& reference) {
  return std::filesystem::path(reference).replace_extension(".history");
}

void require_recorded(const std::filesystem::path& reference) {
  const std::filesystem::path history = history_of(reference);
  if (!std::filesystem::exists(history)) return;
  if (last_line(read_text(history)).find(hash_of_file(reference)) == std::string::npos)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("'{}' does not match the last entry of its history", reference.string()), {},
        "restore the picture, or create a new one with --update --reason \"...\"");
}

void replace_reference(const ImageCase& image_case, const std::filesystem::path& picture,
                       const std::string& reason) {
  const image::ImageUnderTest subject = image::read_image_under_test(picture);
  for (const std::string& name : image_case.diff.layers) {
    const auto views = image::views_of(subject.image.channels);
    const bool there = std::any_of(views.begin(), views.end(), [&](const image::View& view) {
      const auto layers = image::layers_of(view.channels);
      const auto own = image::layer_in(view, name);
      return std::any_of(layers.begin(), layers.end(),
                         [&](const image::Layer& layer) { return layer.name == own; });
    });
    if (!there)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the picture of '{}' has no layer '{}'", image_case.name, name), {},
                  "list existing layers in case.json");
  }
  if (extension_of(image_case.reference) == ".exr")
    store(subject, image::read_info(picture), image_case);
  else
    write_text(image_case.reference, read_text(picture));
  const std::filesystem::path history = history_of(image_case.reference);
  const std::string before = std::filesystem::exists(history) ? read_text(history) : "";
  write_text(history, fmt::format("{}vug {} {} {}\n", before, VUG_VERSION,
                                  hash_of_file(image_case.reference), reason));
}

}  // namespace vug::cli
