// SPDX-License-Identifier: Apache-2.0
#include <vug/base/require_kind.h>
#include <vug/exchange/program.h>

#include <fmt/format.h>

namespace vug::exchange {

const Program& program(const std::string& name) {
  return require_kind(programs(), name, fmt::format("unknown program '{}'", name));
}

}  // namespace vug::exchange
