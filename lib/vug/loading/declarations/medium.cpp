// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>

namespace vug::loading {
namespace {

/// The fog after `on`, which is the density of the medium; null, with a diagnostic, if it is not a
/// fog.
shot::VolumePtr read_density(const scene::Declaration& declaration, ReadContext& context) {
  const shot::VolumePtr volume = read_target<shot::VolumePtr>(declaration, context);
  if (volume && !volume->fog) {
    context.diagnostics.error(declaration.target->where,
                              "a medium takes its density from a fog, not from a level set",
                              "volume NAME = fog(...)");
    return nullptr;
  }
  return volume;
}

}  // namespace

const DeclarationKind& medium_declaration() {
  static const DeclarationKind kind = {
      kind_declaration_info(
          "medium",
          "A participating medium, which fills the scene: medium NAME = haze(...), "
          "or with the density of a fog medium NAME on VOLUME { kind cloud }.",
          "medium", ""),
      [](const scene::Declaration& declaration, ReadContext& context) {
        const Value value = read_kind_declaration("medium", "", declaration, context);
        const shot::VolumePtr volume =
            declaration.target ? read_density(declaration, context) : nullptr;
        if (const auto* medium = value.object<render::MediumPtr>()) {
          if ((*medium)->needs_density() && !declaration.target)
            context.diagnostics.error(declaration.where, "this medium needs a density",
                                      "medium NAME on VOLUME { kind cloud }, or a 'file'");
          if (volume && !(*medium)->needs_density())
            context.diagnostics.error(declaration.target->where, "this medium has its own density",
                                      "leave out 'on'");
          context.shot.media.push_back({declaration.name, *medium, volume, declaration.where});
        }
        return value;
      },
      "volume"};
  return kind;
}

}  // namespace vug::loading
