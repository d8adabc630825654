#include <vug/session/reader.h>

namespace vug::session {

const DeclarationKind& volume_declaration() {
  static const DeclarationKind kind = {
      family_info("volume", "A grid of the scene's .vdb file: volume NAME = level_set(...).",
                  "volume", "level_set"),
      [](const scene::Declaration& declaration, Reading& reading) -> Value {
        const Value value = read_family("volume", "level_set", declaration, reading);
        const VolumePtr* plan = value.object<VolumePtr>();
        if (!plan) return Value();
        auto named = std::make_shared<VolumePlan>(**plan);
        named->name = declaration.name;
        named->where = declaration.where;
        reading.shot.volumes.push_back(named);
        return Object{"volume", VolumePtr(named)};
      }};
  return kind;
}

}  // namespace vug::session
