// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/production_step.h>

namespace vug::sgm {

std::string to_string(Operation operation) {
  constexpr const char* kWords[] = {"union", "difference", "intersection", "morph"};
  return kWords[static_cast<size_t>(operation)];
}

std::string sign_of(Operation operation) {
  constexpr const char* kSigns[] = {"+", "-", "&", "~"};
  return kSigns[static_cast<size_t>(operation)];
}

}  // namespace vug::sgm
