// Views of pictures through OpenColorIO: of a user's configuration, or of one that is built in.
#pragma once

#include <vug/image/view.h>

#include <filesystem>
#include <memory>
#include <string>

namespace vug::image {

/// From the light of a working space to the values of a display.
class OcioView {
 public:
  virtual ~OcioView() = default;
  /// In place: R, G, B of each pixel.
  virtual void apply(float* rgb, size_t pixels) const = 0;
  /// Whether the values are for an sRGB screen.
  virtual bool srgb() const = 0;
};

/// What people choose, by name.
struct ViewSelection {
  /// A view of the configuration, or one of our own: "filmic", "standard"; and without a
  /// configuration "aces": the reference rendering and output transform for video of ACES 1.0, as
  /// OpenColorIO has it (cite aces2016rrt). Empty: the configuration's default, or "filmic".
  std::string view;
  std::string display;           ///< Of the configuration; empty: its default.
  std::filesystem::path config;  ///< An .ocio file; empty: there is none.
};

/// The options that show light of that space so. Error(bad_input): a configuration that cannot be
/// used or that does not know the space, and a view or display that is not there, with those that
/// are.
ViewOptions view_options(const ViewSelection& choice, WorkingSpace space);

/// The file that $OCIO names; empty without.
std::filesystem::path environment_config();

}  // namespace vug::image
