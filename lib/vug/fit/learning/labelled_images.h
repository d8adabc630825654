// SPDX-License-Identifier: Apache-2.0
// Training pictures whose pixels carry class labels.
#pragma once

#include <vug/base/progress.h>
#include <vug/fit/evidence/working_size.h>
#include <vug/fit/model/rules.h>

#include <nlohmann/json_fwd.hpp>

namespace vug::fit {

/// Label of pixels without a class.
constexpr uint8_t kUnlabelled = 255;

/// Class names; the index is the number in the labels.
struct Classes {
  std::vector<std::string> names;

  int count() const { return static_cast<int>(names.size()); }
  /// The region type of the class's name; wall for any other name.
  RegionType region_type(int number) const;
  /// The class named like the region type; -1 without one.
  int find(RegionType type) const;
  bool operator==(const Classes&) const = default;
};

/// Reads {"0": "door", "1": "shop", ...}: numbers without gaps, one of the names being "window".
/// Error(bad_input).
Classes classes_from_json(const nlohmann::json& text);
nlohmann::json to_json(const Classes& classes);
Classes read_classes(const std::filesystem::path& file);

/// Photo and labels at the working size.
struct LabelledImage {
  std::string name;
  image::Image photo;           ///< Linear R, G, B.
  std::vector<uint8_t> labels;  ///< A class or kUnlabelled for each pixel.
};

/// `labels`: an 8-bit grey picture of class numbers with the size of the photo. Error(bad_input)
/// names the file and the offending pixel; Error(too_large) as read_photo.
LabelledImage read_labelled_image(const std::filesystem::path& photo,
                                  const std::filesystem::path& labels, const Classes& classes,
                                  const WorkingLimits& limits = {}, uint64_t max_memory = 0);

/// Reads all files of folder/images and folder/labels, which correspond by name without extension,
/// in natural order of the names. Error(bad_input) if a counterpart is missing.
std::vector<LabelledImage> read_labelled_folder(const std::filesystem::path& folder,
                                                const Classes& classes,
                                                const WorkingLimits& limits = {},
                                                uint64_t max_memory = 0,
                                                Progress& progress = Progress::none());

}  // namespace vug::fit
