// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/svx/stations.h>

#include <vug/base/diagnostics.h>

namespace vug::survey::svx {
namespace {

char in_case(char c, LetterCase letter_case) {
  if (letter_case == LetterCase::lower && c >= 'A' && c <= 'Z') return static_cast<char>(c + 32);
  if (letter_case == LetterCase::upper && c >= 'a' && c <= 'z') return static_cast<char>(c - 32);
  return c;
}

struct FullName {
  std::string text;
  bool below = false;  ///< Names a survey below the current one.
};

FullName read_full_name(Line& line, const Settings& settings, Diagnostics& warnings,
                        const char* what) {
  const char first = line.peek();
  const size_t start = line.position();
  FullName name{settings.survey, false};
  if (line.is(first, kRoot)) {
    name.text.clear();
    line.skip(1);
    if (line.is(line.at(0), kSeparator)) line.skip(1);
  }
  for (int parts = 0;; ++parts) {
    if (!line.is(line.at(0), kName)) {
      line.set_position(start);
      line.fail_expected(what, "names consist of letters, digits, '_' and '-'");
    }
    if (!name.text.empty()) name.text += '.';
    for (size_t bytes = 0; line.is(line.at(0), kName); ++bytes, line.skip(1))
      if (bytes < settings.truncate) name.text += in_case(line.at(0), settings.letter_case);
    if (!line.is(line.at(0), kSeparator)) {
      name.below = parts > 0 && !line.is(first, kRoot);
      break;
    }
    line.skip(1);
  }
  if (line.is(first, kRoot))
    warnings.warning(line.range(start), "names that begin at the root are deprecated",
                     "write the name relative to its survey, and *equate it there");
  return name;
}

}  // namespace

NameIndex::Found NameIndex::find(std::string_view name,
                                 const std::vector<Station>& stations) const {
  const auto hash = static_cast<uint32_t>(std::hash<std::string_view>()(name));
  const size_t mask = slots_.size() - 1;
  for (size_t slot = hash & mask;; slot = (slot + 1) & mask) {
    const Slot& each = slots_[slot];
    if (each.station < 0) return {-1, slot, hash};
    if (each.hash == hash && stations[static_cast<size_t>(each.station)].name == name)
      return {each.station, slot, hash};
  }
}

void NameIndex::insert(const Found& place, int station) {
  slots_[place.slot] = {place.hash, station};
  if (++used_ * 2 > slots_.size()) grow();
}

void NameIndex::grow() {
  std::vector<Slot> larger(slots_.size() * 2);
  const size_t mask = larger.size() - 1;
  for (const Slot& each : slots_) {
    if (each.station < 0) continue;
    size_t slot = each.hash & mask;
    while (larger[slot].station >= 0) slot = (slot + 1) & mask;
    larger[slot] = each;
  }
  slots_ = std::move(larger);
}

int StationTable::add(std::string name, SourceLocation where) {
  const int number = static_cast<int>(stations_.size());
  Station& station = stations_.emplace_back();
  station.name = std::move(name);
  station.where = std::move(where);
  used_.push_back(false);
  exported_.push_back(false);
  return number;
}

StationName StationTable::read(Line& line, const Settings& settings, Diagnostics& warnings,
                               bool anonymous) {
  const char first = line.peek();
  const size_t start = line.position();
  size_t dots = 0;
  while (line.is(line.at(dots), kSeparator)) ++dots;
  const bool hyphen = settings.hyphen_is_wall && line.is(first, kOmit) &&
                      !line.is(line.at(1), kName) && !line.is(line.at(1), kSeparator);
  if (dots > 0 || hyphen) {
    if (dots > 3 || !anonymous || (dots > 0 && line.is(line.at(dots), kName)))
      line.fail_expected("a station", anonymous ? "anonymous stations are '.', '..' and '...'"
                                                : "anonymous stations cannot be named again");
    line.skip(hyphen ? 1 : dots);
    const int station = add("", line.range(start));
    stations_.back().wall = hyphen || dots == 2;
    return {station, dots != 3, true, start};
  }
  FullName name = read_full_name(line, settings, warnings, "a station");
  const NameIndex::Found found = index_.find(name.text, stations_);
  int station = found.station;
  if (station < 0) {
    station = add(std::move(name.text), line.range(start));
    index_.insert(found, station);
  }
  if (settings.infer_exports) exported_[static_cast<size_t>(station)] = true;
  if (name.below) names_in_surveys_.push_back({settings.survey, station, line.range(start)});
  return {station, false, false, start};
}

std::string StationTable::read_survey(Line& line, const Settings& settings, Diagnostics& warnings) {
  return read_full_name(line, settings, warnings, "a survey").text;
}

}  // namespace vug::survey::svx
