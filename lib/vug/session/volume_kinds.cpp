#include <vug/field/kind.h>
#include <vug/session/volume_kinds.h>

namespace vug::session {

const std::vector<const Kind<VolumePtr>*>& volume_kinds() {
#define VUG_KIND(name) &name##_volume(),
  static const std::vector<const Kind<VolumePtr>*> kinds = {
#include <vug/session/volumes_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

Schema<VolumePlan> volume_schema(std::string name, std::string doc) {
  Schema<VolumePlan> s;
  s.info().name = std::move(name);
  s.info().category = "volume";
  s.doc(std::move(doc))
      .param("field", &VolumePlan::field, {.doc = "the solid", .required = true})
      .param("voxel", &VolumePlan::voxel, positive_length("edge of a voxel"))
      .param("half_width", &VolumePlan::half_width,
             {.doc = "voxels kept on each side of the surface", .min = 3, .max = 100})
      .param("half", &VolumePlan::half, {.doc = "store 16-bit floats"})
      .param("from", &VolumePlan::from, any_length("lowest corner of the region that is kept"))
      .param("to", &VolumePlan::to, any_length("highest corner of the region that is kept"));
  return s;
}

namespace {

std::string fault(const VolumePlan& plan) {
  if (plan.from.has_value() != plan.to.has_value()) return "'from' and 'to' are given together";
  if (!plan.from) return {};
  for (int axis = 0; axis < 3; ++axis)
    if ((*plan.from)[axis] >= (*plan.to)[axis]) return "'to' must lie above 'from' on every axis";
  return {};
}

}  // namespace

Kind<VolumePtr> volume_kind(Schema<VolumePlan> schema, bool fog) {
  KindInfo info = schema.info();
  return {std::move(info),
          [schema = std::move(schema), fog](const Arguments& arguments, SourceLocation where,
                                            Diagnostics& diagnostics) -> std::optional<VolumePtr> {
            Diagnostics own;
            VolumePlan plan = schema.bind(arguments, where, own);
            plan.fog = fog;
            if (const std::string wrong = own.has_errors() ? "" : fault(plan); !wrong.empty())
              own.error(where, wrong);
            diagnostics.append(own);
            if (own.has_errors()) return std::nullopt;
            return std::make_shared<const VolumePlan>(std::move(plan));
          }};
}

}  // namespace vug::session
