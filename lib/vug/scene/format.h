// One way of writing a scene.
#pragma once

#include <string>
#include <string_view>

namespace vug::scene {

/// The text with its spaces, indents and columns put in order. Comments, line breaks and single
/// blank lines stay; nothing else changes: the result parses to an equal document, and
/// formatting it again changes nothing. Meant for texts that parse; others come out readable.
std::string format(std::string_view text);

}  // namespace vug::scene
