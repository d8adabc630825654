// SPDX-License-Identifier: Apache-2.0
#include <vug/image/backend.h>

#include <cstdlib>

namespace vug::image {
namespace {

std::optional<ViewTransform> builtin_view(const std::string& name) {
  if (name == "filmic") return ViewTransform::filmic;
  if (name == "standard") return ViewTransform::srgb;
  return std::nullopt;
}

}  // namespace

ViewOptions view_options(const ViewSelection& choice, WorkingSpace space) {
  const std::optional<ViewTransform> builtin =
      builtin_view(choice.view.empty() ? "filmic" : choice.view);
  if (!builtin || !choice.config.empty() || !choice.display.empty())
    return backend().ocio_view(choice, space, builtin);
  ViewOptions options;
  options.space = space;
  options.transform = *builtin;
  return options;
}

std::filesystem::path environment_config() {
  const char* file = std::getenv("OCIO");
  return file ? file : "";
}

}  // namespace vug::image
