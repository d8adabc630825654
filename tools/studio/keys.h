// SPDX-License-Identifier: Apache-2.0
// The keys that are not those of commands: of the windows and of their canvases.
#pragma once

#include <QString>
#include <string>

namespace vug::studio {

/// Keys of an action of the window of facades or of scenes, in Qt's portable text; several are
/// separated by "; ".
QString window_keys(const QString& action);
QString scene_keys(const QString& action);

/// All keys of a window as a Markdown table, for the documentation.
std::string key_table();
std::string scene_key_table();

}  // namespace vug::studio
