// Attributes that are asked for by a name that nobody brings.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>
#include <vug/shot/shot.h>

namespace vug::loading {

/// Warns of each `attribute(name: "stian")` that no mesh of the scene carries, unless it says what
/// holds `otherwise`. Texts that are included may be made for other scenes, too: of theirs only
/// what is nearly the name of one that is there.
void check_attributes(const scene::Document& document, const shot::Shot& shot,
                      Diagnostics& diagnostics);

}  // namespace vug::loading
