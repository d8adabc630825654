// How one view of a picture compares; `diff` puts the views together.
#pragma once

#include <vug/image/diff.h>

namespace vug::image {

/// `diff` of pictures of one view, with this rate of false alarms where significance is tested.
Diff diff_view(const ImageUnderTest& reference, const ImageUnderTest& test,
               const DiffOptions& options, double alarm);

}  // namespace vug::image
