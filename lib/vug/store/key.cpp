// SPDX-License-Identifier: Apache-2.0
#include <vug/store/key.h>

#include <algorithm>

namespace vug::store {

std::vector<std::string> changed_parts(const std::vector<Key::Part>& before, const Key& now) {
  std::vector<std::string> out;
  for (const Key::Part& part : now.parts())
    if (std::find(before.begin(), before.end(), part) == before.end()) out.push_back(part.name);
  return out;
}

}  // namespace vug::store
