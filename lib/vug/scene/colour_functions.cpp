// SPDX-License-Identifier: Apache-2.0
#include <vug/base/blackbody.h>
#include <vug/base/srgb.h>
#include <vug/scene/colour_functions.h>
#include <vug/scene/function_arguments.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace vug::scene {

namespace {

using ColourResult = std::optional<Value>;

Value linear_colour(const Vec3d& encoded) {
  return Vec3d(srgb_decode(encoded.x), srgb_decode(encoded.y), srgb_decode(encoded.z));
}

/// "#c0a080" or "#ca8", with one digit per channel.
ColourResult colour_of_code(const std::string& code, const FaultSite& site) {
  const auto is_hex = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
  const bool valid = (code.size() == 4 || code.size() == 7) && code[0] == '#' &&
                     std::all_of(code.begin() + 1, code.end(), is_hex);
  if (!valid)
    return site.fault(fmt::format("invalid colour {}: expected '#' and 3 or 6 hexadecimal digits",
                                  to_string(Value(code))),
                      "e.g. srgb(\"#c0a080\")");
  const size_t digits = code.size() / 3;
  Vec3d encoded;
  for (int channel = 0; channel < 3; ++channel) {
    const std::string part = code.substr(1 + static_cast<size_t>(channel) * digits, digits);
    encoded[channel] = std::stoi(part, nullptr, 16) / (digits == 1 ? 15.0 : 255.0);
  }
  return linear_colour(encoded);
}

ColourResult srgb(const Arguments& arguments, const FaultSite& site) {
  if (arguments.size() == 1 && arguments[0].name.empty())
    if (const auto* code = arguments[0].value.get<std::string>())
      return colour_of_code(*code, site);
  const auto n = numbers_of(arguments);
  if (n.size() != 3) return std::nullopt;
  for (const Number& code : n) {
    if (code.dimension != Dimension::none) return std::nullopt;
    if (code.value < 0 || code.value > 255)
      return site.fault(
          fmt::format("the codes of 'srgb' are from 0 to 255, not {}", to_string(Value(code))));
  }
  return linear_colour(Vec3d(n[0].value, n[1].value, n[2].value) / 255);
}

/// The hexcone model: Smith 1978, "Color gamut transform pairs" (smith1978hsv).
Vec3d encoded_hsv(double hue, double saturation, double value) {
  const double sector = hue / (kPi / 3);
  Vec3d rgb;
  for (int channel = 0; channel < 3; ++channel) {
    // Red, green and blue have their maximum at hues of 0, 120 and 240 degrees.
    const double turned = sector - 2 * channel;
    const double away = std::fabs(turned - 6 * std::floor(turned / 6 + 0.5));
    rgb[channel] = value * (1 - saturation * std::clamp(away - 1, 0.0, 1.0));
  }
  return rgb;
}

ColourResult hsv(const Arguments& arguments, const FaultSite& site) {
  const auto n = numbers_of(arguments);
  if (n.size() != 3 || !is_angle(n[0]) || !is_plain(n[1]) || !is_plain(n[2])) return std::nullopt;
  for (size_t i = 1; i < 3; ++i)
    if (n[i].value < 0 || n[i].value > 1)
      return site.fault(fmt::format("the {} of 'hsv' is from 0% to 100%, not {}",
                                    i == 1 ? "saturation" : "value",
                                    quantity_text(n[i].value, Dimension::ratio)));
  return linear_colour(encoded_hsv(n[0].value, n[1].value, n[2].value));
}

ColourResult blackbody_colour(const Arguments& arguments, const FaultSite& site) {
  const auto n = numbers_of(arguments);
  if (n.size() != 1 ||
      (n[0].dimension != Dimension::none && n[0].dimension != Dimension::temperature))
    return std::nullopt;
  if (n[0].value < kCoolestBlackbody || n[0].value > kHottestBlackbody)
    return site.fault(fmt::format("the temperature of 'blackbody' is from {}K to {}K, not {}K",
                                  kCoolestBlackbody, kHottestBlackbody, n[0].value));
  return Value(blackbody(n[0].value));
}

}  // namespace

std::vector<Function> colour_functions() {
  return {
      {"srgb", "a text such as \"#c0a080\" or three numbers from 0 to 255",
       "the linear colour of these sRGB codes", srgb},
      {"hsv", "an angle and two ratios",
       "the linear colour of this hue, saturation and value of sRGB codes", hsv},
      {"blackbody", "a temperature", "the linear colour of a black body, of luminance 1",
       blackbody_colour},
  };
}

}  // namespace vug::scene
