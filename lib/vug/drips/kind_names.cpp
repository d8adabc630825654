// SPDX-License-Identifier: Apache-2.0
// The names of nodes, edges and forms.
#include <vug/drips/forms.h>

namespace vug::drips {
namespace {

constexpr const char* kNodes[] = {"seep", "confluence", "bend", "drop", "landing", "pool", "sink"};
constexpr const char* kEdges[] = {"ceiling_film", "wall_film", "fall", "floor_film", "overflow"};
constexpr const char* kNames[] = {"straw", "stalactite", "stalagmite", "column", "broken piece"};

}  // namespace

const char* kind_name(NodeKind kind) { return kNodes[static_cast<size_t>(kind)]; }
const char* kind_name(EdgeKind kind) { return kEdges[static_cast<size_t>(kind)]; }
const char* kind_name(FormKind kind) { return kNames[static_cast<size_t>(kind)]; }

}  // namespace vug::drips
