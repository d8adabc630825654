// SPDX-License-Identifier: Apache-2.0
// The list of a survey's stations while a file is read: each name is one station.
#pragma once

#include <vug/survey/survey.h>

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vug::survey {

class NamedStations {
 public:
  /// `stations` is the list to which new stations are appended.
  explicit NamedStations(std::vector<Station>& stations) : stations_(stations) {}

  /// The index of the station with this full name, which is new at its first mention.
  int find_or_add(const std::string& name, const SourceLocation& where) {
    const auto [known, is_new] = index_.emplace(name, static_cast<int>(stations_.size()));
    if (is_new) add(name, where);
    return known->second;
  }
  /// The index of the station with this full name, or -1.
  int find(const std::string& name) const {
    const auto known = index_.find(name);
    return known == index_.end() ? -1 : known->second;
  }
  /// A new station without a name; `wall`: it is on the wall of the passage.
  int add_anonymous(bool wall, const SourceLocation& where) {
    add("", where);
    stations_.back().wall = wall;
    return static_cast<int>(stations_.size()) - 1;
  }

 private:
  void add(const std::string& name, const SourceLocation& where) {
    stations_.emplace_back();
    stations_.back().name = name;
    stations_.back().where = where;
  }

  std::vector<Station>& stations_;
  std::unordered_map<std::string, int> index_;
};

}  // namespace vug::survey
