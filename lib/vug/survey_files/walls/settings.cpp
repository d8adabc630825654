// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/survey_files/walls/settings.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace vug::survey::walls {
namespace {

constexpr double kFoot = 0.3048;
constexpr double kDegree = kPi / 180;

std::optional<double> length_unit(const std::string& value) {
  if (value == "m" || value == "meters" || value == "metres") return 1;
  if (value == "f" || value == "feet") return kFoot;
  return std::nullopt;
}

std::optional<AngleUnit> angle_unit(const std::string& value, bool vertical) {
  if (value.empty()) return std::nullopt;
  if (value[0] == 'd') return AngleUnit{kDegree};
  if (value[0] == 'g') return AngleUnit{0.9 * kDegree};
  if (value[0] == 'm') return AngleUnit{2 * kPi / 6400};
  if (value[0] == 'p' && vertical) return AngleUnit{1, true};
  return std::nullopt;
}

bool is_order(const std::string& value, std::string letters) {
  std::string sorted = value;
  std::sort(sorted.begin(), sorted.end());
  std::sort(letters.begin(), letters.end());
  return sorted == letters;
}

/// Sets the result and returns true if the value is valid.
template <class T>
bool assign(T& target, const std::optional<T>& value) {
  if (value) target = *value;
  return value.has_value();
}

bool set_order(const std::string& value, Settings& s) {
  if (is_order(value, "dav") || is_order(value, "da")) return s.order = value, true;
  if (is_order(value, "enu") || is_order(value, "en")) return s.rect_order = value, true;
  return false;
}

bool set_case(const std::string& value, Settings& s) {
  if (value.empty() || std::string_view("mul").find(value[0]) == std::string_view::npos)
    return false;
  s.letters = value[0] == 'u'   ? Settings::Case::upper
              : value[0] == 'l' ? Settings::Case::lower
                                : Settings::Case::mixed;
  return true;
}

/// "N" or "C", and a tolerance that does not matter here.
bool set_type(const std::string& value, bool& corrected) {
  if (value.empty() || (value[0] != 'n' && value[0] != 'c')) return false;
  corrected = value[0] == 'c';
  return true;
}

/// Settings with a value; the functions return false for invalid ones.
using Setter = std::function<bool(const std::string&, Settings&)>;
const std::map<std::string, Setter>& setters() {
  static const auto angle = [](double Settings::*member) {
    return [member](const std::string& v, Settings& s) {
      const auto value = parse_angle(v, {});
      return value && std::fabs(*value) <= 2 * kPi && assign(s.*member, value);
    };
  };
  static const auto unit = [](AngleUnit Settings::*member, bool vertical) {
    return [member, vertical](const std::string& v, Settings& s) {
      return assign(s.*member, angle_unit(v, vertical));
    };
  };
  static const std::map<std::string, Setter> all = {
      {"d", [](auto& v, Settings& s) { return assign(s.distance_unit, length_unit(v)); }},
      {"s", [](auto& v, Settings& s) { return assign(s.wall_unit, length_unit(v)); }},
      {"a", unit(&Settings::azimuth, false)},
      {"ab", unit(&Settings::back_azimuth, false)},
      {"v", unit(&Settings::vertical, true)},
      {"vb", unit(&Settings::back_vertical, true)},
      {"order", set_order},
      {"o", set_order},
      {"decl", angle(&Settings::declination)},
      {"grid", angle(&Settings::grid)},
      {"incd",
       [](auto& v, Settings& s) {
         return assign(s.add_distance, parse_distance(v, s.distance_unit));
       }},
      {"inca", angle(&Settings::add_azimuth)},
      {"incab", angle(&Settings::add_back_azimuth)},
      {"incv", angle(&Settings::add_vertical)},
      {"incvb", angle(&Settings::add_back_vertical)},
      {"typeab", [](auto& v, Settings& s) { return set_type(v, s.corrected_back_azimuth); }},
      {"typevb", [](auto& v, Settings& s) { return set_type(v, s.corrected_back_vertical); }},
      {"case", set_case},
      {"lrud",
       [](auto& v, Settings& s) {
         if (v != "f" && v != "t" && v != "from" && v != "to") return false;
         s.walls_at_to = v[0] == 't';
         return true;
       }},
      {"uv", [](auto& v, Settings&) { return parse_number(v).has_value(); }},
      {"uvh", [](auto& v, Settings&) { return parse_number(v).has_value(); }},
      {"uvv", [](auto& v, Settings&) { return parse_number(v).has_value(); }},
      {"tape", [](auto& v, Settings&) { return v == "it" || v == "st"; }},
  };
  return all;
}

/// "known: A, AB, ...", in alphabetical order.
std::string known_settings() {
  std::string out = "known: ";
  for (const auto& each : setters()) {
    for (const char c : each.first) out += static_cast<char>(c - 'a' + 'A');
    out += ", ";
  }
  return out + "PREFIX";
}

}  // namespace

void read_units(const TextLines& lines, const std::vector<Word>& words, size_t first,
                Settings& settings) {
  for (size_t i = first; i < words.size(); ++i) {
    const std::string word = lower_case(words[i].text);
    const size_t equals = std::min(word.find('='), word.size());
    const std::string key = word.substr(0, equals);
    const std::string value = word.substr(std::min(equals + 1, word.size()));
    if (equals == word.size()) {
      if (word == "reset")
        settings = {};
      else if (word == "rect" || word == "ct")
        settings.rectangular = word == "rect";
      else if (const auto unit = length_unit(word))
        settings.distance_unit = settings.wall_unit = *unit;
      else
        lines.fail(fmt::format("unknown setting {}", quote_text(words[i].text)), words[i],
                   "known: METERS, FEET, CT, RECT, SAVE, RESTORE, RESET, and settings with '='");
    } else if (key == "prefix") {
      settings.prefixes[0] = words[i].text.substr(equals + 1);
    } else {
      const auto setter = setters().find(key);
      if (setter == setters().end())
        lines.fail(fmt::format("the setting {} is not supported", quote_text(words[i].text)),
                   words[i], known_settings());
      if (!setter->second(value, settings))
        lines.fail(fmt::format("invalid value of {}", quote_text(words[i].text)), words[i],
                   "check the unit, the number or the order of the setting");
    }
  }
}

std::optional<double> parse_distance(std::string_view text, double unit) {
  if (text.empty()) return std::nullopt;
  const std::string lower = lower_case(text);
  if (lower.back() == 'm' || lower.back() == 'f') {
    const auto value = parse_number(text.substr(0, text.size() - 1));
    return value ? std::optional(*value * (lower.back() == 'm' ? 1 : kFoot)) : std::nullopt;
  }
  if (const size_t inches = lower.find('i'); inches != std::string::npos) {
    const auto feet = inches == 0 ? 0 : parse_number(text.substr(0, inches));
    const auto rest = parse_number(text.substr(inches + 1));
    if (!feet || !rest || *rest < 0) return std::nullopt;
    return kFoot * (*feet + std::copysign(*rest / 12, *feet));
  }
  const auto value = parse_number(text);
  return value ? std::optional(*value * unit) : std::nullopt;
}

std::optional<double> parse_angle(std::string_view text, const AngleUnit& unit) {
  if (text.empty()) return std::nullopt;
  const std::string lower = lower_case(text);
  // Quadrants such as N45E.
  if ((lower[0] == 'n' || lower[0] == 's') && (lower.back() == 'e' || lower.back() == 'w') &&
      lower.size() > 2) {
    const auto inner = parse_angle(text.substr(1, text.size() - 2), {});
    if (!inner || *inner < 0 || *inner > kPi / 2) return std::nullopt;
    const double side = lower.back() == 'e' ? *inner : -*inner;
    const double azimuth = lower[0] == 'n' ? side : kPi - side;
    return azimuth < 0 ? azimuth + 2 * kPi : azimuth;
  }
  AngleUnit own = unit;
  if (const auto given = angle_unit(lower.substr(lower.size() - 1), true)) {
    own = *given;
    text.remove_suffix(1);
  }
  std::optional<double> value;
  if (const size_t colon = text.find(':'); colon != std::string_view::npos) {
    const auto whole = colon == 0 ? 0 : parse_number(text.substr(0, colon));
    const auto minutes = parse_number(text.substr(colon + 1));
    if (!whole || !minutes || *minutes < 0 || *minutes >= 60) return std::nullopt;
    value = *whole + (text[0] == '-' ? -1 : 1) * *minutes / 60;
    own = {};
  } else {
    value = parse_number(text);
  }
  if (!value) return std::nullopt;
  return own.percent ? maths::atan2(*value, 100) : *value * own.factor;
}

}  // namespace vug::survey::walls
