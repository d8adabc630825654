// SPDX-License-Identifier: Apache-2.0
// The bar at the top of a window that offers the journal of a killed program.
#pragma once

#include <vug/workbench/journal.h>

#include <functional>

class QWidget;

namespace vug::studio {

/// Fills and shows the bar. `recover` returns whether the journal was used, which hides the bar.
void fill_recovery_bar(QWidget& bar, const workbench::LostJournal& lost,
                       const std::function<bool()>& recover);

}  // namespace vug::studio
