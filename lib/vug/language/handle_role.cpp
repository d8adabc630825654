// SPDX-License-Identifier: Apache-2.0
#include <vug/language/handle_role.h>
#include <vug/loading/kind_params.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace vug::language {
namespace {

/// Words with which the descriptions of directions begin or which they contain.
constexpr std::array kDirectionWords = {"direction", "normal", "perpendicular", "axis of"};

/// Kinds whose lengths are measured in the scene; those of noises, rules and details are textures.
constexpr std::array kSolidCategories = {"primitive", "light", "medium"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool contains(const std::string& text, const char* word) {
  return text.find(word) != std::string::npos;
}

}  // namespace

std::optional<HandleRole> handle_role(const ParamInfo& param, const std::string& category) {
  const std::string_view type = loading::element_type(param.type);
  const std::string doc = lower(param.doc);
  if (type == "number" && param.dimension == Dimension::length && param.choices.empty() &&
      param.type == "number" &&
      std::find(kSolidCategories.begin(), kSolidCategories.end(), category) !=
          kSolidCategories.end())
    return HandleRole::length;
  if (type != "vector" && type != "places") return std::nullopt;
  if (category == "curve") return std::nullopt;  // curves have coordinates of their own
  if (param.dimension == Dimension::length) {
    // Coordinates of a file are not those of the scene.
    if (contains(doc, "of the file")) return std::nullopt;
    return param.min >= 0 ? HandleRole::extent : HandleRole::point;
  }
  if (type == "vector" && param.dimension == Dimension::none && param.min < 0 &&
      std::any_of(kDirectionWords.begin(), kDirectionWords.end(),
                  [&](const char* word) { return contains(doc, word); }))
    return HandleRole::direction;
  return std::nullopt;
}

double extent_share(const ParamInfo& param) {
  return contains(lower(param.name), "size") || contains(lower(param.doc), "size") ? 0.5 : 1;
}

int length_axis(const ParamInfo& param) {
  for (const char* word : {"height", "top"})
    if (contains(param.name, word)) return 1;
  for (const char* word : {"depth", "length"})
    if (contains(param.name, word)) return 2;
  return 0;
}

}  // namespace vug::language
