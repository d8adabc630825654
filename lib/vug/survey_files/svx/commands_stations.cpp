// SPDX-License-Identifier: Apache-2.0
// The commands about stations and their coordinates.
#include <vug/survey/fix_covariance.h>
#include <vug/survey/system_properties.h>
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/svx/commands.h>

#include <fmt/format.h>

#include <array>

namespace vug::survey::svx {
namespace {

/// Standard deviations or variances after the coordinates of *fix; nothing if there are none.
std::optional<Covariance> read_fix_covariance(Line& line) {
  std::array<double, 6> values{};
  size_t count = 0;
  line.peek();
  const size_t start = line.position();
  while (count < values.size() && !line.at_end())
    values[count++] = line.number("a standard deviation");
  if (count == 0) return std::nullopt;
  if (count == 4 || count == 5)
    line.fail(start, fmt::format("a fix has 1, 2, 3 or 6 accuracies, not {}", count),
              "one standard deviation, a horizontal and a vertical one, one for each axis, and the "
              "covariances xy, yz, zx");
  const double x = values[0], y = count < 3 ? values[0] : values[1],
               z = count == 1 ? values[0] : values[std::min<size_t>(count, 3) - 1];
  return fix_covariance({x, y, z}, {values[3], values[4], values[5]}, line.range(start));
}

}  // namespace

void command_cs(Reader& reader, Line& line) {
  line.peek();
  size_t start = line.position();
  const bool out = line.keyword() == "out";
  if (!out) line.set_position(start);
  line.peek();
  start = line.position();
  std::string name = line.word();
  if (name == "custom") name = line.text();
  if (name.empty()) line.fail_expected("a coordinate system", "e.g. EPSG:27700, UTM30N or OSGB:SD");
  if (const std::string fault = reader.north.geodesy().fault_of(name); !fault.empty())
    line.fail(start, fault,
              "known: EPSG:n, ESRI:n, UTM30N, OSGB:SD, S-MERC, long-lat, EUR79Z30, "
              "JTSK, iJTSK, JTSK03, iJTSK03, local, and custom \"PROJ definition\"");
  if (name == "local") name.clear();
  if (const std::string fault = out ? fault_of_survey_system(name) : ""; !fault.empty())
    line.fail(start, fault, "write a projected system in metres, e.g. '*cs out UTM30N'");
  if (out && !reader.out.fixes.empty() && name != reader.out.coordinate_system)
    line.fail(start, "'*cs out' after *fix", "write it above the first *fix");
  if (out)
    reader.out.coordinate_system = name;
  else
    reader.settings.coordinate_system = name;
}

void command_entrance(Reader& reader, Line& line) {
  const StationName name = reader.stations.read(line, reader.settings, reader.warnings, false);
  reader.stations[name.station].entrance = true;
}

void command_equate(Reader& reader, Line& line) {
  const size_t start = line.position();
  const auto read = [&] {
    const int station = reader.stations.read(line, reader.settings, reader.warnings, false).station;
    reader.stations.use(station);
    return station;
  };
  int last = read();
  if (line.at_end())
    line.fail(start, "*equate names one station", "write two or more names of the same point");
  while (!line.at_end()) {
    const size_t at = line.position();
    const int next = read();
    if (next == last)
      reader.warnings.warning(
          line.range(at),
          fmt::format("the station '{}' is equated to itself", reader.stations[next].name),
          "remove one of the two names");
    else
      reader.out.add(Equate{last, next, line.range(at)});
    last = next;
  }
  reader.repetitions = 0;
}

void command_export(Reader& reader, Line& line) {
  if (reader.settings.survey.empty())
    line.fail(0, "*export outside of a survey", "write it below '*begin' with a name");
  do {
    const StationName name = reader.stations.read(line, reader.settings, reader.warnings, false);
    reader.stations[name.station].exported = true;
    reader.exports.insert({reader.settings.survey, name.station});
  } while (!line.at_end());
  reader.exporting.insert(reader.settings.survey);
}

void command_fix(Reader& reader, Line& line) {
  const StationName name = reader.stations.read(line, reader.settings, reader.warnings, false);
  Fix fix{name.station, Vec3d(0), {}, line.range(name.start)};
  line.peek();
  const size_t start = line.position();
  if (line.keyword() != "reference") line.set_position(start);
  if (line.at_end()) {
    reader.warnings.warning(fix.where,
                            "*fix without coordinates; the station is fixed at (0, 0, 0)",
                            "write the easting, the northing and the altitude");
  } else {
    fix.position.x = line.number("the easting");
    fix.position.y = line.number("the northing");
    fix.position.z = line.number("the altitude");
    const size_t end = line.position();
    fix.covariance = read_fix_covariance(line);
    const std::string &from = reader.settings.coordinate_system, &to = reader.out.coordinate_system;
    if (!from.empty() && to.empty())
      line.fail(start, "*fix after '*cs' but before '*cs out'",
                "write '*cs out' with the coordinate system of the survey above it");
    if (from != to && !from.empty()) {
      try {
        fix.position = reader.north.geodesy().transform(from, to, fix.position);
      } catch (const Error& error) {
        line.set_position(end);
        throw error.at(line.range(start));
      }
    }
  }
  require_plausible(fix.position, fix.where);
  reader.stations.use(fix.station);
  reader.stations[fix.station].fixed = true;
  reader.out.add(fix);
}

}  // namespace vug::survey::svx
