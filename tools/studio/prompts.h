// SPDX-License-Identifier: Apache-2.0
// Dialogs that ask for the arguments of commands.
#pragma once

#include "studio.h"

#include <string>

class QWidget;

namespace vug::studio {

/// The complete line of a command; empty if the user cancels.
std::string prompt(QWidget& parent, Studio& studio, const std::string& command);
std::string save_as_line(QWidget& parent, Studio& studio);

}  // namespace vug::studio
