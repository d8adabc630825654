// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/survey_files/svx/written_names.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey::svx {
namespace {

/// Blanks, comment, keyword, plus and root.
constexpr std::string_view kReserved = " \t,;*+\\";

bool is_usual(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}
bool is_reserved(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7f || kReserved.find(c) != std::string_view::npos;
}

std::string joined(const Path& path) { return fmt::format("{}", fmt::join(path, ".")); }

/// For each station without a name the survey of its first leg.
std::vector<std::string> surveys_of_legs(const Survey& survey) {
  std::vector<std::string> all(survey.stations.size());
  for (auto leg = survey.legs.rbegin(); leg != survey.legs.rend(); ++leg)
    for (const int end : {leg->from, leg->to})
      if (survey.stations[static_cast<size_t>(end)].anonymous())
        all[static_cast<size_t>(end)] = leg->survey;
  return all;
}

}  // namespace

WrittenNames::WrittenNames(const Survey& survey, const std::vector<bool>& named)
    : stations_(survey.stations.size()) {
  const std::vector<std::string> surveys = surveys_of_legs(survey);
  for (size_t i = 0; i < stations_.size(); ++i) {
    if (!survey.stations[i].anonymous()) {
      stations_[i] = this->survey(survey.stations[i].name);
    } else if (named[i]) {
      stations_[i] = this->survey(surveys[i]);
      stations_[i].emplace_back("anonymous");
    }
    if (stations_[i].empty()) continue;
    add_surveys(stations_[i]);
    wanted_.insert(joined(stations_[i]));
  }
  // Names of the survey come before invented ones, which must differ from them.
  for (const bool invented : {false, true})
    for (size_t i = 0; i < stations_.size(); ++i)
      if (!stations_[i].empty() && survey.stations[i].anonymous() == invented)
        stations_[i] = unique(std::move(stations_[i]));
}

std::string WrittenNames::unusual() const { return fmt::format("{}", fmt::join(unusual_, "")); }

Path WrittenNames::survey(const std::string& name) {
  Path path;
  if (name.empty()) return path;
  path.emplace_back();
  for (size_t at = 0; at < name.size();) {
    const size_t length = std::max<size_t>(utf8_length(std::string_view(name).substr(at)), 1);
    std::string character = name.substr(at, length);
    at += length;
    if (character == ".") {
      path.emplace_back();
      continue;
    }
    if (is_reserved(character[0])) character = "_";
    if (!is_usual(character[0])) unusual_.insert(character);
    path.back() += character;
  }
  for (std::string& part : path)
    if (part.empty()) part = "_";
  return path;
}

/// Adds the surveys that contain a station.
void WrittenNames::add_surveys(Path path) {
  for (path.pop_back(); !path.empty(); path.pop_back())
    if (!surveys_.insert(joined(path)).second) return;
}

Path WrittenNames::unique(Path path) {
  const std::string plain = path.back();
  int& count = taken_[joined(path)];
  if (count++ == 0 && surveys_.count(joined(path)) == 0) return path;
  for (std::string name;; ++count) {
    path.back() = fmt::format("{}_{}", plain, std::max(count, 2));
    name = joined(path);
    if (surveys_.count(name) + wanted_.count(name) + taken_.count(name) == 0) {
      taken_.emplace(name, 1);
      return path;
    }
  }
}

}  // namespace vug::survey::svx
