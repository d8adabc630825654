// SPDX-License-Identifier: Apache-2.0
// Display views through OpenColorIO, from a user's configuration or a built-in one.
#pragma once

#include <vug/image/view.h>

#include <filesystem>
#include <memory>
#include <string>

namespace vug::image {

/// Converts from a working space to display values.
class OcioView {
 public:
  virtual ~OcioView() = default;
  /// Converts R, G, B of each pixel in place.
  virtual void apply(float* rgb, size_t pixels) const = 0;
  /// Whether the result is for an sRGB display.
  virtual bool srgb() const = 0;
};

/// View, display and configuration by name.
struct ViewSelection {
  /// A view of the configuration, or a built-in one: "filmic", "standard"; and without a
  /// configuration "aces": the reference rendering and output transform for video of ACES 1.0 as
  /// implemented in OpenColorIO (cite aces2016rrt). Empty: the configuration's default, or
  /// "filmic".
  std::string view;
  std::string display;           ///< Display of the configuration; empty: its default.
  std::filesystem::path config;  ///< An .ocio file; empty: no configuration.
};

/// Returns the options that display light of this space with the selection. Throws Error(bad_input)
/// for a configuration that cannot be used or does not contain the space, and for an unknown
/// view or display, listing the known ones.
ViewOptions view_options(const ViewSelection& choice, WorkingSpace space);

/// The file that $OCIO names, or empty.
std::filesystem::path environment_config();

}  // namespace vug::image
