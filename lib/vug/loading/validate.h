// SPDX-License-Identifier: Apache-2.0
// Validates a shot for rendering before anything is built.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/render/film/aovs.h>
#include <vug/scene/document.h>
#include <vug/shot/shot.h>

#include <string>

namespace vug::loading {

/// Whether a light can be linked to that name: a shown object, a `place`, or an object in a placed
/// scene ("PLACE/OBJECT"). The number of instances is not known yet; any index is accepted.
bool is_linkable(const shot::Shot& shot, const std::string& name);

/// Whether the shot has no object, `place` or light, as a text written for inclusion; it cannot be
/// rendered.
bool is_empty_scene(const shot::Shot& shot);

/// The AOVs of the plan, with those of all light groups; attributes of meshes are assumed to exist.
/// Error(bad_input), located at the plan's name.
render::AovPlan expected_aovs(const shot::Shot& shot, const shot::RenderPlan& plan);

/// Reports unknown AOVs, crops outside the picture and names in links and selections that no object
/// has, at the entries or declarations that contain them. Names that may be missing only because of
/// a fault that has already been reported are ignored.
void validate(const shot::Shot& shot, const scene::Document& document, Diagnostics& diagnostics);

}  // namespace vug::loading
