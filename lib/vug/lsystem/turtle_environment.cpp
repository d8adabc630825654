// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/lsystem/turtle_environment.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vug::lsystem {
namespace {

struct Answer {
  std::array<double, 4> values{};
  size_t count = 0;

  Answer(const Vec3d& v) : values{v.x, v.y, v.z}, count(3) {}  // NOLINT
  Answer(double d, const Vec3d& v) : values{d, v.x, v.y, v.z}, count(4) {}
};

Answer answer_to(const std::string& query, const TurtlePose& pose,
                 const std::optional<field::Field>& field) {
  constexpr double kFree = 1e6;
  if (query == "?P") return pose.position;
  if (query == "?H") return pose.frame.tangent;
  if (query == "?L") return pose.frame.normal;
  if (query == "?U") return pose.frame.binormal;
  if (query != "?D")
    throw Error(ErrorCode::bad_input, fmt::format("unknown query '{}'", query), {},
                "known: ?P, ?H, ?L, ?U, ?D");
  if (!field || field->bounds().isEmpty()) return {kFree, Vec3d(0)};
  const field::Gradient here = field->gradient(pose.position);
  return {here.value, here.gradient};
}

}  // namespace

const std::vector<TurtleQuery>& turtle_queries() {
  static const std::vector<TurtleQuery> all = {
      {"?P", "(x, y, z): the position"},
      {"?H", "(x, y, z): the heading"},
      {"?L", "(x, y, z): the left vector"},
      {"?U", "(x, y, z): the up vector"},
      {"?D", "(d, x, y, z): the signed distance to the field, and its gradient"}};
  return all;
}

void TurtleEnvironment::answer(const System& system, Word& drawn) const {
  std::vector<SymbolId> queries;
  for (size_t id = 0; id < system.query.size(); ++id)
    if (system.query[id]) queries.push_back(static_cast<SymbolId>(id));
  visit_poses(drawn, system.alphabet, options_, queries, [&](size_t at, const TurtlePose& pose) {
    const std::string& query = system.alphabet.name(drawn.symbol(at));
    const Answer given = answer_to(query, pose, field_);
    const std::span<double> values = drawn.parameters(at);
    std::copy_n(given.values.begin(), std::min(values.size(), given.count), values.begin());
  });
}

}  // namespace vug::lsystem
