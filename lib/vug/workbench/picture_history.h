// SPDX-License-Identifier: Apache-2.0
// Pictures that the user keeps with their recipes, and the comparison of two of them. The models
// are the snapshots of Houdini and the reference image of tev.
#pragma once

#include <vug/viewport/preview_renderer.h>
#include <vug/workbench/scene_text.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::workbench {

/// A picture as displayed. Immutable.
struct ShownPicture {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;  ///< Row by row from the top.
};

/// A picture with all that is needed to render it again.
struct KeptPicture {
  int number = 0;  ///< From 1; never used again.
  SceneText text;
  viewport::View view;
  viewport::Mode mode = viewport::Mode::clay;
  viewport::DisplayChoice display;
  int samples = 0;  ///< Per pixel.
  ShownPicture shown;
  image::Image light;  ///< R, G and B of the rendered region.

  /// "path, 320 x 180, 16 samples, exposure +1.5, denoised".
  std::string settings() const;
  size_t bytes() const;
};
using KeptPicturePtr = std::shared_ptr<const KeptPicture>;

enum class ComparisonMode {
  off,         ///< The shown picture alone.
  wipe,        ///< The shown picture left of an edge, the reference right of it.
  difference,  ///< The absolute difference of the display values.
};
/// "off", "wipe" and "difference", in the order of the enumeration.
const std::vector<std::string>& comparison_names();
/// Error(bad_input) with the known names.
ComparisonMode comparison_of(const std::string& name);

/// `a` left of the edge, from 0 to 1, and `b` right of it, at the size of `a`.
ShownPicture wiped(const ShownPicture& a, const ShownPicture& b, double edge);
/// At the size of `a`; `b` is scaled to the nearest pixel.
ShownPicture difference_of(const ShownPicture& a, const ShownPicture& b);

/// The kept pictures, and the choice of two of them; number 0 is the picture of the viewport.
class PictureHistory {
 public:
  static constexpr size_t kMostBytes = size_t{256} << 20;

  /// The oldest pictures are forgotten when all take more bytes, except for the newest one.
  explicit PictureHistory(size_t most_bytes = kMostBytes) : most_bytes_(most_bytes) {}

  const std::vector<KeptPicturePtr>& all() const { return all_; }
  /// Error(bad_input) for an unknown number.
  const KeptPicturePtr& find(int number) const;
  /// Keeps the picture and returns its number. Error(bad_input) if its text is unknown.
  int keep(const viewport::Preview& picture);
  void forget(int number);
  void clear();

  int shown() const { return shown_; }
  int reference() const { return reference_; }
  ComparisonMode comparison() const { return comparison_; }
  double edge() const { return edge_; }
  /// Error(bad_input) for an unknown number.
  void show(int number);
  void set_reference(int number);
  void compare(ComparisonMode mode);
  void set_edge(double edge);
  /// Increases with each change.
  uint64_t revision() const { return revision_; }

  /// What the viewport displays; nothing: its own picture. `live`: that picture; null: none yet.
  std::shared_ptr<const ShownPicture> displayed(const viewport::PreviewPtr& live) const;
  /// The root mean square of the differences of the light, as `vug diff` computes it for the
  /// beauty. Error(bad_input) for pictures of different sizes.
  double difference(const viewport::PreviewPtr& live) const;

 private:
  std::shared_ptr<const ShownPicture> picture(int number, const viewport::PreviewPtr& live) const;
  image::Image light(int number, const viewport::PreviewPtr& live) const;

  size_t most_bytes_;
  std::vector<KeptPicturePtr> all_;
  int last_ = 0;
  int shown_ = 0, reference_ = 0;
  ComparisonMode comparison_ = ComparisonMode::off;
  double edge_ = 0.5;
  uint64_t revision_ = 0;
};

}  // namespace vug::workbench
