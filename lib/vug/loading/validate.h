// Faults of a shot that a picture would meet, as far as they show before anything is built.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/render/film/aovs.h>
#include <vug/scene/document.h>
#include <vug/shot/shot.h>

#include <string>

namespace vug::loading {

/// Whether a light can be linked to that name: it is an object that shows, or a place, or something
/// in one ("PLACE/OBJECT"). How many a place has is not known yet; any number is taken to be there.
bool is_linkable(const shot::Shot& shot, const std::string& name);

/// No object, place or light: then there is no picture. A text for others to include may be so.
bool is_empty_scene(const shot::Shot& shot);

/// The layers of a picture of the plan, with its lights' groups; any attribute of a mesh is taken
/// to be there. Error(bad_input) at the plan's name.
render::AovPlan expected_aovs(const shot::Shot& shot, const shot::RenderPlan& plan);

/// Error(bad_input) at the plan's name for a crop that lies outside, a deep picture down to a
/// noise, layers that there are none of.
void require_valid(const shot::Shot& shot, const shot::RenderPlan& plan);

/// All such faults, at what declares them. Says nothing of what may be missing only because of a
/// fault that was told already.
void validate(const shot::Shot& shot, const scene::Document& document, Diagnostics& diagnostics);

}  // namespace vug::loading
