// SPDX-License-Identifier: Apache-2.0
// The keys that are not those of commands: of the window and of the canvas.
#pragma once

#include <QString>
#include <string>

namespace vug::studio {

/// Keys of an action of the window, in Qt's portable text; several are separated by "; ".
QString window_keys(const QString& action);

/// All keys as a Markdown table, for the documentation.
std::string key_table();

}  // namespace vug::studio
