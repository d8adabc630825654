// SPDX-License-Identifier: Apache-2.0
// Names of edits for the undo menu.
#pragma once

#include <vug/modeller/edit.h>

#include <string>

namespace vug::workbench {

/// "Apply Grid to PartFacade", "Move line 1 of Grid"; `state` is the one before the edit.
std::string step_name(const modeller::FacadeState& state, const modeller::Edit& edit);

}  // namespace vug::workbench
