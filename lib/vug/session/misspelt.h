// Attributes that are asked for by a name that nobody brings, but nearly.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>
#include <vug/session/shot.h>

namespace vug::session {

/// Warns of each `attribute(name: "stian")` where cells or files bring no such name but one like
/// it. Others may be meant for what else the material is put on, and are left alone.
void warn_of_misspelt_attributes(const scene::Document& document, const Shot& shot,
                                 Diagnostics& diagnostics);

}  // namespace vug::session
