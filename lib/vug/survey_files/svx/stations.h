// SPDX-License-Identifier: Apache-2.0
// The stations of a survey while it is read: names and their first mention.
#pragma once

#include <vug/survey_files/svx/settings.h>

#include <string>
#include <string_view>
#include <vector>

namespace vug::survey::svx {

/// A station on a data line or in a command.
struct StationName {
  int station = -1;
  bool splay = false;  ///< An anonymous station other than "...".
  bool anonymous = false;
  size_t start = 0;  ///< Position on its line.
};

/// A name that reaches into a survey below the current one, for the check of *export.
struct NameInSurvey {
  std::string survey;  ///< The current survey.
  int station = -1;
  SourceLocation where;
};

/// The numbers of stations by name: a hash table with linear probing. It refers to the names in the
/// vector of stations instead of copying them, so that a station costs no allocation here.
class NameIndex {
 public:
  /// The station with this name, or -1 and the place at which `insert` adds it.
  struct Found {
    int station = -1;
    size_t slot = 0;
    uint32_t hash = 0;
  };
  Found find(std::string_view name, const std::vector<Station>& stations) const;
  void insert(const Found& place, int station);

 private:
  struct Slot {
    uint32_t hash = 0;
    int station = -1;
  };
  void grow();

  std::vector<Slot> slots_ = std::vector<Slot>(64);  ///< A power of two, at most half full.
  size_t used_ = 0;
};

class StationTable {
 public:
  /// Reads a name in the current survey and adds the station if it is new. The separators ".", ".."
  /// and "..." are anonymous stations if `anonymous` is set.
  StationName read(Line& line, const Settings& settings, Diagnostics& warnings, bool anonymous);
  /// Reads the name of a survey below the current one and returns its full name.
  static std::string read_survey(Line& line, const Settings& settings, Diagnostics& warnings);

  void reserve(size_t stations) { stations_.reserve(stations); }
  std::vector<Station>& stations() { return stations_; }
  Station& operator[](int station) { return stations_[static_cast<size_t>(station)]; }
  const std::vector<NameInSurvey>& names_in_surveys() const { return names_in_surveys_; }
  /// Marks a station as part of a leg, an equate or a fix.
  void use(int station) { used_[static_cast<size_t>(station)] = true; }
  bool is_used(int station) const { return used_[static_cast<size_t>(station)]; }
  /// Whether the station was named while *infer exports was on: all its surveys export it.
  bool is_exported(int station) const { return exported_[static_cast<size_t>(station)]; }

 private:
  int add(std::string name, SourceLocation where);

  std::vector<Station> stations_;
  std::vector<bool> used_;
  std::vector<bool> exported_;
  NameIndex index_;
  std::vector<NameInSurvey> names_in_surveys_;
};

}  // namespace vug::survey::svx
