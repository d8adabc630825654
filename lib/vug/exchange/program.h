// Other programs: what each reads best. Each is a kind; docs/guides/export.md gives the reasons.
#pragma once

#include <vug/exchange/format.h>

namespace vug::exchange {

struct Program {
  KindInfo info;
  Space space;                       ///< Of everything but formats that have one of their own.
  std::vector<std::string> formats;  ///< Of the scene.
  FormatOptions options;
  /// Points as a mesh file without triangles, for programs that cannot read those of .vdb files;
  /// empty: as .vdb.
  std::string points_format;
};

const std::vector<const Program*>& programs();
/// Error(bad_input), with those that there are, where there is none of that name.
const Program& program(const std::string& name);

inline Program make_program(std::string name, std::string doc) {
  Program made;
  made.info = {std::move(name), "program", std::move(doc), "", {}};
  return made;
}

}  // namespace vug::exchange

#define VUG_EXCHANGE_PROGRAM(name) VUG_EXPORT_KIND(vug::exchange, Program, name##_program)
