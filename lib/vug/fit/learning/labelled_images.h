// Pictures in which people have labelled each pixel with its class.
#pragma once

#include <vug/base/progress.h>
#include <vug/fit/evidence/working_size.h>
#include <vug/fit/model/rules.h>

#include <nlohmann/json_fwd.hpp>

namespace vug::fit {

/// The class of pixels that nobody has labelled.
constexpr uint8_t kUnlabelled = 255;

/// What classes there are: numbers 0.. in labels.
struct Classes {
  std::vector<std::string> names;

  int count() const { return static_cast<int>(names.size()); }
  /// What a class is in a tree: that of its name; anything else is wall.
  RegionType region_type(int number) const;
  /// The class of that look, by name; -1: none.
  int find(RegionType type) const;
  bool operator==(const Classes&) const = default;
};

/// {"0": "door", "1": "shop", ...}, numbered without gaps; one of them is a window.
/// Error(bad_input).
Classes classes_from_json(const nlohmann::json& text);
nlohmann::json to_json(const Classes& classes);
Classes read_classes(const std::filesystem::path& file);

/// Both at the working size.
struct LabelledImage {
  std::string name;
  image::Image photo;           ///< Linear R, G, B.
  std::vector<uint8_t> labels;  ///< A class, or kVoid, of each pixel.
};

/// `labels`: an 8-bit grey picture of class numbers, as large as the photo. Error(bad_input) names
/// the file and the pixel that does not fit, Error(too_large) as read_photo.
LabelledImage read_labelled_image(const std::filesystem::path& photo,
                                  const std::filesystem::path& labels, const Classes& classes,
                                  const WorkingLimits& limits = {}, uint64_t max_memory = 0);

/// All of folder/images and folder/labels, whose files have the same names (but for their endings),
/// in the order of names, with numbers by their values. Error(bad_input) where one lacks the other.
std::vector<LabelledImage> read_labelled_folder(const std::filesystem::path& folder,
                                                const Classes& classes,
                                                const WorkingLimits& limits = {},
                                                uint64_t max_memory = 0,
                                                Progress& progress = Progress::none());

}  // namespace vug::fit
