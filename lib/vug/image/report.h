// SPDX-License-Identifier: Apache-2.0
// Reports on a comparison of two images, for people and programs. The same verdict gives the same
// bytes, without times or machine names.
#pragma once

#include <vug/image/diff.h>

#include <string>
#include <vector>

namespace vug::image {

/// "identical", "the same: ...", "different: red is 8 % brighter, most at the lower right", in one
/// line without statistics.
std::string verdict_text(const Diff& diff);

/// Sentences that qualify the verdict: unknown noise, layers without a criterion, values that are
/// not finite.
std::vector<std::string> remarks(const Diff& diff);

/// The verdict and the remarks in words; then a table of the measures with one line per layer and
/// measure, the significance test, and the reasons.
std::string to_table(const Diff& diff);

/// The verdict as JSON; infinite numbers are null.
std::string to_json(const Diff& diff, const std::string& reference, const std::string& test);

/// A self-contained page with both images under a slider, the heat map, the z-scores of the
/// blocks and the table. `title` and names are plain text.
std::string to_html(const Diff& diff, const std::string& title, const std::string& reference,
                    const std::string& test);

/// The heat map of the verdict as linear R, G, B, to be written with ViewTransform::srgb.
Image heat_picture(const Diff& diff);

}  // namespace vug::image
