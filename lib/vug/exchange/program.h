// SPDX-License-Identifier: Apache-2.0
// Target programs with their preferred formats and units. Each is a kind; docs/guides/export.md
// gives the reasons.
#pragma once

#include <vug/exchange/format.h>

namespace vug::exchange {

struct Program {
  KindInfo info;
  Space space;                       ///< For all formats that do not prescribe their own space.
  std::vector<std::string> formats;  ///< Formats for the scene.
  FormatOptions options;
  /// Mesh format for points, without triangles, for programs that cannot read points in .vdb files;
  /// empty: .vdb.
  std::string points_format;
};

const std::vector<const Program*>& programs();
/// Throws Error(bad_input), listing the known programs, for an unknown name.
const Program& program(const std::string& name);

/// The program with another format of USD layers, "usda" or "usdc". Throws Error(bad_input) if its
/// formats are not USD.
Program with_usd_format(Program program, const std::string& format);

inline Program make_program(std::string name, std::string doc) {
  Program program;
  program.info = {std::move(name), "program", std::move(doc), "", {}};
  return program;
}

}  // namespace vug::exchange

#define VUG_EXCHANGE_PROGRAM(name) VUG_EXPORT_KIND(vug::exchange, Program, name##_program)
