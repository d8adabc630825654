// What a file of a mesh format needs: the macro that opens its one exported definition
// in namespace vug::mesh,
//   VUG_MESH_FORMAT(ply) { return mesh_format("ply", "...", "...", read, write); }
#pragma once

#include <vug/mesh/format.h>

#define VUG_MESH_FORMAT(name)                            \
  static Format make_##name##_format();                  \
  const Format& name##_format() {                        \
    static const Format format = make_##name##_format(); \
    return format;                                       \
  }                                                      \
  static Format make_##name##_format()

namespace vug::mesh {

#define VUG_KIND(name) const Format& name##_format();
#include <vug/mesh/formats_kinds.inc>
#undef VUG_KIND

inline Format mesh_format(std::string name, std::string doc, std::string cite,
                          Mesh (*read)(std::string_view, const std::string&),
                          void (*write)(const Mesh&, const ByteSink&)) {
  return {{std::move(name), "mesh format", std::move(doc), std::move(cite), {}}, read, write};
}

}  // namespace vug::mesh
