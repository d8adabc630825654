// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/labels.h>

#include <algorithm>

namespace vug::shot {

std::vector<std::string> label_names(const std::vector<SurfaceLabel>& labels) {
  std::vector<std::string> names;
  for (const SurfaceLabel& label : labels)
    if (std::find(names.begin(), names.end(), label.name) == names.end())
      names.push_back(label.name);
  return names;
}

}  // namespace vug::shot
