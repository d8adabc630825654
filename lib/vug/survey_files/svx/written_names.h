// SPDX-License-Identifier: Apache-2.0
// The names of stations and surveys as a .svx file can contain them.
#pragma once

#include <vug/survey/survey.h>

#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace vug::survey::svx {

/// The levels of a name, from the outermost.
using Path = std::vector<std::string>;

class WrittenNames {
 public:
  /// `named`: the stations without a name that need one.
  WrittenNames(const Survey& survey, const std::vector<bool>& named);

  /// The levels of a station's name; empty for an anonymous station. No two are the same, and none
  /// is the name of a survey.
  const Path& station(int index) const { return stations_[static_cast<size_t>(index)]; }
  /// The levels of a survey's name. Characters with a meaning in .svx files become '_'.
  Path survey(const std::string& name);
  /// The characters of all names that are not letters, digits, '_' or '-'.
  std::string unusual() const;

 private:
  void add_surveys(Path path);
  Path unique(Path path);

  std::vector<Path> stations_;
  std::set<std::string> unusual_;
  std::unordered_set<std::string> surveys_;     ///< The full names of surveys with stations.
  std::unordered_set<std::string> wanted_;      ///< The full names of stations without numbers.
  std::unordered_map<std::string, int> taken_;  ///< The number of stations with each name.
};

}  // namespace vug::survey::svx
