// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/svx/north.h>

#include <vug/base/diagnostics.h>
#include <vug/survey/dates.h>
#include <vug/survey/geomagnetism.h>

namespace vug::survey::svx {

double North::correction(const Settings& settings, const std::string& grid, const Line& line,
                         size_t start, Diagnostics& warnings) {
  const Declination& declination = settings.declination;
  if (!declination.automatic) return declination.value;
  if (!settings.date)
    warnings.warning(line.range(start),
                     "the leg has no date; its magnetic declination is taken as 0",
                     "write the date of the measurements with *date");
  const int day = settings.date ? (settings.date->first + settings.date->last) / 2 : INT_MIN;
  const auto key = std::tuple(declination.coordinate_system, grid, declination.place.x,
                              declination.place.y, declination.place.z, day);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  double angle = 0;
  try {
    const Geographic place = geodesy_.geographic(declination.coordinate_system, declination.place);
    angle = geodesy_.true_north(grid, place);
    if (settings.date) angle += magnetic_declination(place, year_of(day));
  } catch (const Error& error) {
    throw error.at(line.range(start));
  }
  return known_.emplace(key, angle).first->second;
}

double North::cartesian_correction(const Settings& settings, const std::string& grid,
                                   const Line& line, size_t start, Diagnostics& warnings) {
  if (settings.cartesian == CartesianNorth::output) return 0;
  if (settings.cartesian == CartesianNorth::magnetic)
    return correction(settings, grid, line, start, warnings);
  const Declination& declination = settings.declination;
  const bool geographic = settings.cartesian == CartesianNorth::geographic;
  const std::string& system = settings.coordinate_system;
  if (grid.empty() || (!geographic && (system.empty() || system == grid))) return 0;
  if (!declination.automatic)
    throw Error(
        ErrorCode::bad_input, "the north of '*cartesian' depends on the place, which is not known",
        line.range(start), "write '*declination auto' with a place of the survey above the data");
  const Geographic place = geodesy_.geographic(declination.coordinate_system, declination.place);
  const double angle = geodesy_.true_north(grid, place);
  return geographic ? angle : angle - geodesy_.true_north(system, place);
}

}  // namespace vug::survey::svx
