// SPDX-License-Identifier: Apache-2.0
#include <vug/base/require_kind.h>
#include <vug/exchange/program.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::exchange {

const Program& program(const std::string& name) {
  return require_kind(programs(), name, fmt::format("unknown program '{}'", name));
}

Program with_usd_format(Program program, const std::string& format) {
  const auto is_usd = [](const std::string& name) { return name == "usda" || name == "usdc"; };
  if (!is_usd(format))
    throw Error(ErrorCode::bad_input, fmt::format("unknown format of USD files '{}'", format), {},
                "known: usda, usdc");
  if (std::none_of(program.formats.begin(), program.formats.end(), is_usd))
    throw Error(ErrorCode::bad_input,
                fmt::format("files for {} are not USD and have no USD format", program.info.name),
                {}, "export with --for usd, houdini, maya or unreal");
  std::replace_if(program.formats.begin(), program.formats.end(), is_usd, format);
  return program;
}

}  // namespace vug::exchange
