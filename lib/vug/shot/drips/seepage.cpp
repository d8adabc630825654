// SPDX-License-Identifier: Apache-2.0
// Drips where water seeps out of the joints and pores of the rock.
#include <vug/shot/drips_plan.h>

namespace vug::shot {
namespace {

struct Seepage : DripParams {
  static void describe(Schema<Seepage>& s) {
    s.doc(
        "The drips of a cave: where water leaves joints and pores, how it runs, drops, lands and "
        "ponds, and the sizes of the speleothems that grow from it.");
    describe_drips(s);
  }
};

}  // namespace
}  // namespace vug::shot

// Faults of edits are reported at the edits.
VUG_DRIPS_KIND(seepage) {
  Schema<Seepage> schema("seepage", "drips");
  Seepage::describe(schema);
  KindInfo info = schema.info();
  return {std::move(info),
          [schema = std::move(schema)](const Arguments& arguments, const SourceLocation& where,
                                       Diagnostics& diagnostics) -> std::optional<DripsPtr> {
            const std::optional<Seepage> params = schema.bind(arguments, where, diagnostics);
            if (!params) return std::nullopt;
            try {
              return std::make_shared<const DripsPlan>(*params);
            } catch (const Error& error) {
              if (error.code() != ErrorCode::bad_input) throw;
              diagnostics.add(error, where);
              return std::nullopt;
            }
          }};
}
