// SPDX-License-Identifier: Apache-2.0
// The stations of a .3d file as Survex's dump3d prints them.
#pragma once

#include <vug/base/vec.h>

#include <map>
#include <sstream>
#include <string>

namespace vug::survey {

/// The positions of stations with names.
inline std::map<std::string, Vec3d> dumped_stations(const std::string& dump) {
  std::map<std::string, Vec3d> out;
  std::istringstream lines(dump);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("NODE ")) continue;
    std::istringstream words(line.substr(5));
    Vec3d p;
    std::string name;
    words >> p.x >> p.y >> p.z >> name;
    if (name != "[]") out[name.substr(1, name.size() - 2)] = p;
  }
  return out;
}

}  // namespace vug::survey
