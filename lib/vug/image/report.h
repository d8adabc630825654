// A verdict on two pictures as text for people and programs. The same verdict gives the same bytes:
// no times, no machine.
#pragma once

#include <vug/image/diff.h>

#include <string>

namespace vug::image {

/// "identical", "the same: ...", "different: ...", in one line.
std::string verdict_text(const Diff& diff);

/// The measures as a table, one line a layer's measure, then the test of significance, then
/// reasons.
std::string to_table(const Diff& diff);

/// The same for programs; numbers that are infinite are null.
std::string to_json(const Diff& diff, const std::string& reference, const std::string& test);

/// A page that holds all it needs: both pictures under a slider, the heat map, the z-scores of the
/// blocks, and the table. `title` and names are plain text.
std::string to_html(const Diff& diff, const std::string& title, const std::string& reference,
                    const std::string& test);

/// The heat map of the verdict, linear R, G, B: write with ViewTransform::srgb.
Image heat_picture(const Diff& diff);

}  // namespace vug::image
