// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/json_file.h>
#include <vug/base/memory.h>
#include <vug/fit/learning/labelled_images.h>
#include <vug/image/io.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace vug::fit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHint = "write {\"0\": \"door\", \"1\": \"shop\", \"2\": \"window\", ...}";
/// In the order of RegionType.
constexpr const char* kRegionTypeNames[kRegionTypes] = {"wall", "window", "door", "shop"};

Error refused(const std::string& reason, const char* hint = kHint) {
  return Error(ErrorCode::bad_input, reason, {}, hint);
}

/// The files of a folder by their names without extension.
std::map<std::string, fs::path> stems(const fs::path& folder) {
  std::error_code failed;
  std::map<std::string, fs::path> out;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    const fs::path& path = entry.path();
    if (!entry.is_regular_file() || path.filename().string().front() == '.') continue;
    if (!out.emplace(path.stem().string(), path).second)
      throw refused(
          fmt::format("'{}' has two files named {}", folder.string(), path.stem().string()),
          "keep one of them");
  }
  if (failed)
    throw Error(ErrorCode::bad_input,
                fmt::format("cannot read folder '{}': {}", folder.string(), failed.message()), {},
                "put pictures into images/ and their labels into labels/");
  return out;
}

/// Natural order: facade_9 before facade_10.
bool by_number(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto number_at = [&](const std::string& text) {
    size_t at = text.size();
    while (at > 0 && digit(text[at - 1])) --at;
    return at;
  };
  const size_t at_a = number_at(a), at_b = number_at(b);
  const std::string number_a = a.substr(at_a), number_b = b.substr(at_b);
  const auto key = [](const std::string& text, size_t at, const std::string& number) {
    return std::tuple(text.substr(0, at), number.size(), number);
  };
  return key(a, at_a, number_a) < key(b, at_b, number_b);
}

std::vector<uint8_t> read_labels(const fs::path& path, const Classes& classes,
                                 uint64_t max_memory) {
  constexpr const char* kWhat = "labels must be an 8-bit grey picture of class numbers";
  const image::FileInfo info = image::read_info(path);
  const size_t channels = info.channels.size();
  if (info.formats[0] != "uint8")
    throw refused(
        fmt::format("'{}' has {} values instead of labels", path.string(), info.formats[0]), kWhat);
  require_memory(
      read_memory(info.width, info.height, channels), max_memory ? max_memory : available_memory(),
      fmt::format("reading {} x {} labels", info.width, info.height), "use a smaller picture");
  const image::Image picture = image::read(path);
  std::vector<uint8_t> out;
  out.reserve(picture.pixel_count());
  for (size_t i = 0; i < picture.pixels.size(); i += channels) {
    // Grey may be stored as three equal channels.
    for (size_t c = 1; c < std::min<size_t>(3, channels); ++c)
      if (picture.pixels[i + c] != picture.pixels[i])
        throw refused(fmt::format("'{}' has colours instead of labels", path.string()), kWhat);
    const auto label = static_cast<uint8_t>(std::lround(255 * picture.pixels[i]));
    if (label >= classes.count() && label != kUnlabelled) {
      const auto at = static_cast<int>(out.size());
      throw refused(fmt::format("'{}' has the unnamed class {} in column {}, row {}", path.string(),
                                label, at % picture.width, at / picture.width),
                    "name all classes except 255, which marks unlabelled pixels");
    }
    out.push_back(label);
  }
  return out;
}

}  // namespace

RegionType Classes::region_type(int number) const {
  for (int type = 0; type < kRegionTypes; ++type)
    if (names[static_cast<size_t>(number)] == kRegionTypeNames[type])
      return static_cast<RegionType>(type);
  return RegionType::wall;
}

int Classes::find(RegionType type) const {
  const auto at =
      std::find(names.begin(), names.end(), kRegionTypeNames[static_cast<size_t>(type)]);
  return at == names.end() ? -1 : static_cast<int>(at - names.begin());
}

Classes classes_from_json(const nlohmann::json& text) {
  if (!text.is_object() || text.empty() || text.size() > kUnlabelled)
    throw refused("classes must be an object that maps numbers to names");
  Classes out;
  for (size_t i = 0; i < text.size(); ++i) {
    const auto found = text.find(std::to_string(i));
    if (found == text.end())
      throw refused(fmt::format("{} classes must be numbered from 0 to {}: {} is missing",
                                text.size(), text.size() - 1, i));
    if (!found->is_string() || found->get<std::string>().empty())
      throw refused(fmt::format("class {} has no name", i));
    const auto name = found->get<std::string>();
    if (std::find(out.names.begin(), out.names.end(), name) != out.names.end())
      throw refused(fmt::format("two classes are named '{}'", name));
    out.names.push_back(name);
  }
  if (out.find(RegionType::window) < 0) throw refused("no class is named 'window'");
  return out;
}

nlohmann::json to_json(const Classes& classes) {
  nlohmann::json out = nlohmann::json::object();
  for (size_t i = 0; i < classes.names.size(); ++i) out[std::to_string(i)] = classes.names[i];
  return out;
}

Classes read_classes(const fs::path& file) {
  try {
    return classes_from_json(read_json<nlohmann::json>(file));
  } catch (Error& error) {
    throw error.within(fmt::format("reading '{}'", file.string()));
  }
}

LabelledImage read_labelled_image(const fs::path& photo, const fs::path& labels,
                                  const Classes& classes, const WorkingLimits& limits,
                                  uint64_t max_memory) {
  LabelledImage out;
  out.name = photo.stem().string();
  const image::Image picture = read_photo(photo, max_memory);
  const image::FileInfo info = image::read_info(labels);
  if (info.width != picture.width || info.height != picture.height)
    throw refused(
        fmt::format("'{}' has {} x {} pixels, but its labels have {} x {}", photo.string(),
                    picture.width, picture.height, info.width, info.height),
        "labels must have the size of the picture");
  const WorkingSize size = working_size(picture.width, picture.height, limits);
  out.labels =
      resampled(read_labels(labels, classes, max_memory), {picture.width, picture.height}, size);
  out.photo = downsampled(picture, size);
  return out;
}

std::vector<LabelledImage> read_labelled_folder(const fs::path& folder, const Classes& classes,
                                                const WorkingLimits& limits, uint64_t max_memory,
                                                Progress& progress) {
  const auto photos = stems(folder / "images"), labels = stems(folder / "labels");
  std::vector<std::string> names;
  for (const auto& [name, path] : photos) {
    if (!labels.contains(name))
      throw refused(fmt::format("'{}' has no labels", path.string()),
                    "labels must have the same names as their pictures");
    names.push_back(name);
  }
  for (const auto& [name, path] : labels)
    if (!photos.contains(name))
      throw refused(fmt::format("no picture for the labels '{}'", path.string()),
                    "labels must have the same names as their pictures");
  if (names.empty())
    throw refused(fmt::format("no pictures in '{}'", (folder / "images").string()),
                  "put pictures into images/ and their labels into labels/");
  std::stable_sort(names.begin(), names.end(), by_number);
  progress.begin("reading pictures", names.size());
  std::vector<LabelledImage> out;
  for (const std::string& name : names) {
    progress.check();
    out.push_back(
        read_labelled_image(photos.at(name), labels.at(name), classes, limits, max_memory));
    progress.advance();
  }
  progress.end();
  return out;
}

}  // namespace vug::fit
