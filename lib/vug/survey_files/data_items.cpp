// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/data_items.h>

namespace vug::survey {

Style leg_style(DataStyle style) {
  switch (style) {
    case DataStyle::normal:
      return Style::normal;
    case DataStyle::diving:
      return Style::diving;
    case DataStyle::cartesian:
      return Style::cartesian;
    case DataStyle::cylpolar:
      return Style::cylpolar;
    case DataStyle::nosurvey:
      return Style::nosurvey;
    case DataStyle::none:
    case DataStyle::passage:
    case DataStyle::ignore:
      break;
  }
  return Style::unknown;
}

const std::map<std::string, Item>& item_names() {
  static const std::map<std::string, Item> all = {
      {"altitude", Item::altitude},
      {"backbearing", Item::back_compass},
      {"backclino", Item::back_clino},
      {"backcompass", Item::back_compass},
      {"backgradient", Item::back_clino},
      {"backlength", Item::back_tape},
      {"backtape", Item::back_tape},
      {"bearing", Item::compass},
      {"ceiling", Item::up},
      {"clino", Item::clino},
      {"compass", Item::compass},
      {"count", Item::count},
      {"counter", Item::count},
      {"depth", Item::depth},
      {"depthchange", Item::depth_change},
      {"direction", Item::direction},
      {"down", Item::down},
      {"dx", Item::easting},
      {"dy", Item::northing},
      {"dz", Item::altitude},
      {"easting", Item::easting},
      {"floor", Item::down},
      {"from", Item::from},
      {"fromcount", Item::from_count},
      {"fromdepth", Item::from_depth},
      {"gradient", Item::clino},
      {"ignore", Item::ignore},
      {"ignoreall", Item::ignore_all},
      {"left", Item::left},
      {"length", Item::tape},
      {"newline", Item::newline},
      {"northing", Item::northing},
      {"right", Item::right},
      {"station", Item::station},
      {"tape", Item::tape},
      {"to", Item::to},
      {"tocount", Item::to_count},
      {"todepth", Item::to_depth},
      {"up", Item::up},
  };
  return all;
}

}  // namespace vug::survey
