// SPDX-License-Identifier: Apache-2.0
// Lists of labels that a scene computes, such as one for each speleothem.
#pragma once

#include <vug/shot/labels.h>

namespace vug::shot {

/// The kinds listed in CMakeLists.txt.
const Kinds<std::vector<SurfaceLabel>>& label_list_kinds();
using LabelListKind = Kind<std::vector<SurfaceLabel>>;
/// Begins the definition of the function that the source of such a kind exports.
#define VUG_LABEL_LIST_KIND(name) VUG_EXPORT_KIND(vug::shot, LabelListKind, name##_labels)

}  // namespace vug::shot
