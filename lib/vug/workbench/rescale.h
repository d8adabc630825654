// SPDX-License-Identifier: Apache-2.0
// Another scale for a facade over a photo.
#pragma once

#include <vug/workbench/facade_document.h>

namespace vug::workbench {

/// The document with all lengths multiplied, so that everything stays at its place on the photo:
/// the size of the facade, the scale of the photo, and the lengths of all edits; counts remain.
/// Error(bad_input) unless the factor is above 0, and if an edit is not possible at the new size.
FacadeDocument rescaled(const FacadeDocument& document, double factor);

}  // namespace vug::workbench
