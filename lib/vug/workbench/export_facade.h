// SPDX-License-Identifier: Apache-2.0
// Output files of the facade bench.
#pragma once

#include <vug/image/image.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::workbench {

class FacadeBench;

struct ExportKind {
  std::string name;       ///< "svg"
  std::string extension;  ///< ".svg"
  std::string doc;        ///< One noun phrase for a dialog.
  void (*write)(const FacadeBench& bench, const std::filesystem::path& file);
};
/// svg, png, json, theta, scene, carve and session.
const std::vector<ExportKind>& export_kinds();

/// Writes a file. Error(bad_input) for an unknown kind, another extension, or a file that the
/// session reads; Error(io) if it cannot be written.
void export_facade(const FacadeBench& bench, const std::string& kind,
                   const std::filesystem::path& file);

/// The photo (or a grey wall) with the elements and open areas of the tree drawn over it.
image::Image overlay_picture(const FacadeBench& bench);

/// The colour of a kind of element, linear R, G, B.
struct ElementColour {
  float r = 0, g = 0, b = 0;
};
ElementColour element_colour(const std::string& kind);

}  // namespace vug::workbench
