// SPDX-License-Identifier: Apache-2.0
// The end of reading: checks of names, and removal of stations that no leg uses.
#include <vug/survey_files/svx/reader.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey::svx {
namespace {

/// Warns about names that reach into a survey that does not export them.
void check_exports(Reader& reader) {
  for (const NameInSurvey& each : reader.stations.names_in_surveys()) {
    const std::string& name = reader.stations[each.station].name;
    reader.stations[each.station].exported = true;
    if (reader.stations.is_exported(each.station)) continue;
    size_t dot = each.survey.empty() ? 0 : each.survey.size() + 1;
    for (dot = name.find('.', dot); dot != std::string::npos; dot = name.find('.', dot + 1)) {
      const std::string survey = name.substr(0, dot);
      if (reader.exporting.count(survey) == 0 || reader.exports.count({survey, each.station}) > 0)
        continue;
      reader.warnings.warning(
          each.where,
          fmt::format("the survey '{}' does not export the station '{}'", survey,
                      name.substr(dot + 1)),
          fmt::format("write '*export {}' below '*begin'", name.substr(dot + 1)));
    }
  }
}

/// The numbers of the stations without those that only *entrance, *export and cross-sections name,
/// which have -1 and a warning.
std::vector<int> number_used(Reader& reader) {
  std::vector<int> numbers;
  numbers.reserve(reader.stations.stations().size());
  int used = 0;
  for (size_t i = 0; i < reader.stations.stations().size(); ++i) {
    const int station = static_cast<int>(i);
    numbers.push_back(reader.stations.is_used(station) ? used++ : -1);
    if (numbers.back() >= 0) continue;
    reader.warnings.warning(reader.stations[station].where,
                            fmt::format("the station '{}' is not part of any leg and is omitted",
                                        reader.stations[station].name),
                            "is the name correct?");
  }
  return numbers;
}

}  // namespace

Observations Reader::finish() {
  check_exports(*this);
  const std::vector<int> numbers = number_used(*this);
  const auto number = [&](int& station) { station = numbers[static_cast<size_t>(station)]; };
  for (ObservedLeg& each : out.legs) number(each.leg.from), number(each.leg.to);
  for (Equate& each : out.equates) number(each.a), number(each.b);
  for (Fix& each : out.fixes) number(each.station);
  for (Tube& tube : out.tubes) {
    for (CrossSection& each : tube) number(each.station);
    std::erase_if(tube, [](const CrossSection& each) { return each.station < 0; });
  }
  std::erase_if(out.tubes, [](const Tube& tube) { return tube.empty(); });
  std::vector<Station>& all = stations.stations();
  size_t kept = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    if (numbers[i] < 0) continue;
    if (kept != i) all[kept] = std::move(all[i]);
    ++kept;
  }
  all.resize(kept);
  out.stations = std::move(all);
  return std::move(out);
}

}  // namespace vug::survey::svx
