// SPDX-License-Identifier: Apache-2.0
// Checks the names of attributes that masks, paints and AOVs read.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>
#include <vug/shot/shot.h>

namespace vug::loading {

/// Warns about each `attribute(name: "stian")` that no mesh of the scene provides, unless it has a
/// default `otherwise`. Included texts may serve other scenes as well: there, only names similar to
/// an existing attribute are reported. Also checks the rocks of materials; see rock_check.h.
void check_attributes(const scene::Document& document, const shot::Shot& shot,
                      Diagnostics& diagnostics);

}  // namespace vug::loading
