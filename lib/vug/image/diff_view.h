// SPDX-License-Identifier: Apache-2.0
// Comparison of one view; `diff` combines the views.
#pragma once

#include <vug/image/diff.h>

namespace vug::image {

/// `diff` for images with one view, with the given false-alarm rate for the significance test.
Diff diff_view(const ImageUnderTest& reference, const ImageUnderTest& test,
               const DiffOptions& options, double alarm);

}  // namespace vug::image
