// SPDX-License-Identifier: Apache-2.0
// The stations of a survey while it is read: names and their first mention.
#pragma once

#include <vug/survey_files/svx/settings.h>

#include <string>
#include <unordered_map>
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

class StationTable {
 public:
  /// Reads a name in the current survey and adds the station if it is new. The separators ".", ".."
  /// and "..." are anonymous stations if `anonymous` is set.
  StationName read(Line& line, const Settings& settings, Diagnostics& warnings, bool anonymous);
  /// Reads the name of a survey below the current one and returns its full name.
  static std::string read_survey(Line& line, const Settings& settings, Diagnostics& warnings);

  std::vector<Station>& stations() { return stations_; }
  Station& operator[](int station) { return stations_[static_cast<size_t>(station)]; }
  const std::vector<NameInSurvey>& names_in_surveys() const { return names_in_surveys_; }
  /// Marks a station as part of a leg, an equate or a fix.
  void use(int station) { used_[static_cast<size_t>(station)] = true; }
  bool is_used(int station) const { return used_[static_cast<size_t>(station)]; }
  /// Whether the station was named while *infer exports was on: all its surveys export it.
  bool is_exported(int station) const { return exported_[static_cast<size_t>(station)]; }

 private:
  int add(const std::string& name, const SourceLocation& where);

  std::vector<Station> stations_;
  std::vector<bool> used_;
  std::vector<bool> exported_;
  std::unordered_map<std::string, int> index_;
  std::vector<NameInSurvey> names_in_surveys_;
};

}  // namespace vug::survey::svx
