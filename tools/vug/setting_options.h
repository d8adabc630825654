// SPDX-License-Identifier: Apache-2.0
// Options for the settings of a picture.
#pragma once

#include "verb.h"

#include <vug/shot/render_settings.h>

#include <string>

namespace vug::cli {

/// One option for each setting of the render schema that is a text, a name, a number or a truth
/// value: `working_space` becomes --working-space. `size`, `crop` and `half` have a syntax of their
/// own, and --quality belongs to SceneOptions.
class SettingOptions {
 public:
  /// This object must outlive the parsing of the command line.
  void add_to(CLI::App& app);
  /// The settings that were given, for picture::PictureOptions. Error(bad_input) for an invalid
  /// size or crop.
  NamedValues values() const;

 private:
  void add(CLI::App& app, const ParamInfo& info);

  NamedValues given_;
  std::string size_, crop_;
  bool full_float_ = false;
};

}  // namespace vug::cli
