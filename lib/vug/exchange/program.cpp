// SPDX-License-Identifier: Apache-2.0
#include <vug/base/require_kind.h>
#include <vug/exchange/program.h>

#include <fmt/format.h>

namespace vug::exchange {

#define VUG_KIND(name) const Program& name##_program();
#include <vug/exchange/programs_kinds.inc>
#undef VUG_KIND

const std::vector<const Program*>& programs() {
  static const std::vector<const Program*> all = {
#define VUG_KIND(name) &name##_program(),
#include <vug/exchange/programs_kinds.inc>
#undef VUG_KIND
  };
  return all;
}

const Program& program(const std::string& name) {
  return require_kind(programs(), name, fmt::format("unknown program '{}'", name));
}

}  // namespace vug::exchange
