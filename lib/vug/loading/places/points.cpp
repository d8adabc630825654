// SPDX-License-Identifier: Apache-2.0
// Instances from a table: a .csv with one line per instance, as written by other programs.
#include <vug/base/atomic_file.h>
#include <vug/loading/instance_source_kinds.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

namespace vug::loading {
namespace {

struct Points {
  std::filesystem::path file;
  double unit = 1;
  double scale = 1;

  static void describe(Schema<Points>& s) {
    s.doc(
         "Instances from a .csv whose first line names its columns: x, y, z; yaw, pitch, roll in "
         "degrees; scale, sx, sy, sz; model, counted from 0. All but x, y and z may be missing.")
        .param("file", &Points::file, {.doc = "the table", .required = true})
        .param("unit", &Points::unit, positive_length("unit of x, y and z"))
        .param("scale", &Points::scale,
               {.doc = "factor of the size of each", .min = 0, .above_min = true});
  }
};

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (size_t begin = 0; begin <= line.size();) {
    const size_t end = std::min(line.find(',', begin), line.size());
    std::string_view cell = line.substr(begin, end - begin);
    while (!cell.empty() && std::string_view(" \t\r\"").find(cell.front()) != cell.npos)
      cell.remove_prefix(1);
    while (!cell.empty() && std::string_view(" \t\r\"").find(cell.back()) != cell.npos)
      cell.remove_suffix(1);
    cells.push_back(cell);
    begin = end + 1;
  }
  return cells;
}

std::vector<building::Instance> read_points(const Points& p) {
  const std::vector<std::string> known = {"x",     "y",  "z",  "yaw", "pitch", "roll",
                                          "scale", "sx", "sy", "sz",  "model"};
  const std::string text = read_text(p.file);
  std::map<std::string, size_t> column;
  std::vector<building::Instance> places;
  int number = 0;
  const auto refuse = [&](const std::string& what, const std::string& hint = {}) {
    throw Error(ErrorCode::bad_input, fmt::format("{}:{}: {}", p.file.string(), number, what), {},
                hint);
  };
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") == line.npos || line.front() == '#') continue;
    const std::vector<std::string_view> cells = cells_of(line);
    if (column.empty()) {
      for (size_t i = 0; i < cells.size(); ++i)
        if (std::find(known.begin(), known.end(), cells[i]) != known.end())
          column[std::string(cells[i])] = i;
      for (const char* needed : {"x", "y", "z"})
        if (!column.count(needed))
          refuse(fmt::format("the table has no column '{}'", needed),
                 "its first line names the columns, for instance: x,y,z,yaw,scale");
      continue;
    }
    const auto value = [&](const char* name, double otherwise) {
      const auto at = column.find(name);
      if (at == column.end()) return otherwise;
      double read = 0;
      const std::string_view cell = at->second < cells.size() ? cells[at->second] : "";
      const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), read);
      if (result.ec != std::errc() || result.ptr != cell.data() + cell.size() ||
          !(std::fabs(read) < 1e12))
        refuse(fmt::format("invalid number '{}' for {}", cell, name));
      return read;
    };
    const Vec3d size =
        Vec3d(value("sx", 1), value("sy", 1), value("sz", 1)) * (value("scale", 1) * p.scale);
    if (size.x == 0 || size.y == 0 || size.z == 0) refuse("a model of size 0 cannot be placed");
    const double degree = kPi / 180;
    const Vec3d at(value("x", 0), value("y", 0), value("z", 0));
    places.push_back(
        {building::pose_transform(at * p.unit, value("yaw", 0) * degree, value("pitch", 0) * degree,
                                  value("roll", 0) * degree, size),
         RandomKey(0), static_cast<int>(value("model", -1))});
  }
  return places;
}

}  // namespace
}  // namespace vug::loading

VUG_INSTANCE_SOURCE_KIND(points) {
  return make_kind<shot::InstanceSource, Points>(
      "points", "places", [](const Points& p) -> shot::InstanceSource {
        // Read now, so that a faulty table is reported with its location in the scene text.
        std::vector<building::Instance> places = read_points(p);
        int last = -1;
        for (const building::Instance& place : places) last = std::max(last, place.model);
        const auto make = [places = std::move(places)](building::Builder&, RandomKey key) {
          std::vector<building::Instance> keyed = places;
          for (size_t i = 0; i < keyed.size(); ++i) keyed[i].key = key.at(i);
          return keyed;
        };
        return std::make_shared<const building::InstanceFunction>(
            building::IndexedInstanceSource{.make = make, .last_model = last, .is_given = true});
      });
}
