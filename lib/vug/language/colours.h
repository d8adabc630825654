// SPDX-License-Identifier: Apache-2.0
// Colours in a text. Scenes contain linear Rec.709 values, editors show sRGB.
#pragma once

#include <vug/base/vec.h>
#include <vug/language/workspace.h>

#include <string>
#include <vector>

namespace vug::language {

struct Swatch {
  SourceLocation range;
  Vec3d srgb;  ///< Encoded, from 0 to 1; brighter colours are divided by their largest component.
  double scale = 1;  ///< The linear colour is `scale` times the decoded one.
};

/// The colours that are written as three numbers for a colour parameter, and as `srgb("#...")`.
std::vector<Swatch> swatches_of(const Analysis& analysis);

/// Texts for another colour in place of a swatch, in the notation of the swatch first: the linear
/// values (times its scale), and srgb("#...").
std::vector<std::string> colour_texts(const Swatch& swatch, const Vec3d& srgb, bool as_code);
/// Whether the text at the range is a call of srgb.
bool is_code(const Analysis& analysis, const SourceLocation& range);

}  // namespace vug::language
