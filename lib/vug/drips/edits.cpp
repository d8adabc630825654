// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/drips/edits.h>
#include <vug/drips/surface.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vug::drips {
namespace {

/// Points on the roof are in the rock by their rounding.
constexpr double kTouching = 0.01;
/// Water that leaves the roof within this distance of a joint comes out of it.
constexpr double kOfPlane = 0.1;
constexpr double kRoofStep = 0.05;

std::string text(const Vec3d& p) { return fmt::format("({:g}, {:g}, {:g})", p.x, p.y, p.z); }

[[noreturn]] void fail(const SourceLocation& where, const std::string& message,
                       const std::string& hint) {
  throw Error(ErrorCode::bad_input, message, where, hint);
}

/// The point, or the one below it if it is on the roof.
Vec3d point_in_air(const field::Field& rock, const Vec3d& at, const SourceLocation& where) {
  if (rock.value(at) > 0) return at;
  const Vec3d below = at - Vec3d(0, kTouching, 0);
  if (!(rock.value(below) > 0))
    fail(where, fmt::format("a drip at {} is in solid rock", text(at)),
         "give a point in the air; water drips from the roof above it");
  return below;
}

/// The point of the roof above a point in the air.
Vec3d roof_above(const field::Field& rock, const Vec3d& point, const SeepOptions& o,
                 const SourceLocation& where) {
  const Vec3d at = point_in_air(rock, point, where);
  const auto roof = VerticalLine(rock, at, kRoofStep).crossing(at.y, o.to.y);
  if (!roof)
    fail(where, fmt::format("the drip at {} has no roof above it", text(point)),
         fmt::format("move it below the roof, or extend the box of the drips, which ends at a "
                     "height of {:g} m, upwards",
                     o.to.y));
  return Vec3d(at.x, *roof, at.z);
}

class Editor {
 public:
  Editor(std::vector<Seep> seeps, const field::Field& rock, const SeepOptions& o)
      : rock_(rock), o_(o) {
    for (const Seep& seep : seeps) seeps_.emplace(seep.id, seep);
  }

  /// The edits refer to the drips that the budget leaves, which are those that users see.
  std::vector<Seep> apply(const DripEdits& edits) && {
    if (edits.budget) keep_wettest(*edits.budget);
    for (const DripEdits::Move& move : edits.moved)
      place(find(move.drip, "moved", move.where), move.to, move.where);
    for (const DripEdits::Removal& each : edits.removed) find(each.drip, "removed", each.where);
    for (const DripEdits::Removal& each : edits.removed) seeps_.erase(each.drip);
    for (const DripEdits::Addition& each : edits.added) add(each);
    std::vector<Seep> out;
    for (const auto& [id, seep] : seeps_) out.push_back(seep);
    return out;
  }

 private:
  void keep_wettest(size_t budget) {
    std::vector<std::pair<double, int64_t>> order;
    for (const auto& [id, seep] : seeps_) order.emplace_back(seep.interval, id);
    std::sort(order.begin(), order.end());
    for (size_t i = budget; i < order.size(); ++i) seeps_.erase(order[i].second);
  }

  Seep& find(int64_t drip, const char* verb, const SourceLocation& where) {
    const auto found = seeps_.find(drip);
    if (found == seeps_.end())
      fail(where, fmt::format("drip {} is {}, but the roof has no such drip", drip, verb),
           "'vug drips' lists the numbers; they depend on the seed, the box and the spacing");
    return found->second;
  }

  void add(const DripEdits::Addition& from) {
    Seep seep;
    seep.id = -++added_;
    seep.interval = from.interval;
    seep.age = from.age * (o_.oldest / o_.last_age());
    place(seep, from.at, from.where);
    seeps_.emplace(seep.id, seep);
  }

  /// Moves a seep to the roof above a point.
  void place(Seep& seep, const Vec3d& point, const SourceLocation& where) const {
    seep.position = roof_above(rock_, point, o_, where);
    seep.normal = normal_at(rock_, seep.position);
    seep.plane.reset();
    if (!o_.planes) return;
    const auto plane = o_.planes->nearest(seep.position);
    if (plane && std::fabs(plane->distance) < kOfPlane) seep.plane = plane;
  }

  std::map<int64_t, Seep> seeps_;
  const field::Field& rock_;
  const SeepOptions& o_;
  int64_t added_ = 0;
};

void require_inside(const Vec3d& at, const SeepOptions& o, const SourceLocation& where) {
  if (!Box3d(o.from, o.to).intersects(at))
    fail(where, fmt::format("a drip at {} is outside the box of the drips", text(at)),
         fmt::format("the box reaches from {} to {}", text(o.from), text(o.to)));
}

void require_valid(const DripEdits::Addition& added, const SeepOptions& o) {
  require_inside(added.at, o, added.where);
  if (!(added.interval > 0 && std::isfinite(added.interval)))
    fail(added.where,
         fmt::format("the interval of a drip is {:g} s, but water must flow", added.interval),
         "use 1 s to 1 h");
  if (!(added.age > 0))
    fail(added.where, fmt::format("the age of a drip is {:g} years", added.age),
         "use a positive age");
  if (added.age > o.last_age())
    fail(added.where,
         fmt::format("a drip is {:g} years old, but the oldest ones are {:g}", added.age,
                     o.last_age()),
         "increase the age of the oldest drips; if 'age' has keys, give their last age as "
         "'final_age'");
}

}  // namespace

void DripEdits::add_to(Digester& digester) const {
  std::vector<int64_t> drips;
  for (const Removal& each : removed) drips.push_back(each.drip);
  digester(budget, drips, moved, added);
}

void require_valid(const DripEdits& edits, const SeepOptions& options) {
  std::set<int64_t> named;
  const auto name_once = [&](int64_t drip, const SourceLocation& where) {
    if (!named.insert(drip).second)
      fail(where, fmt::format("drip {} is moved or removed twice", drip), "name each drip once");
  };
  for (const DripEdits::Removal& each : edits.removed) name_once(each.drip, each.where);
  for (const DripEdits::Move& move : edits.moved) {
    name_once(move.drip, move.where);
    require_inside(move.to, options, move.where);
  }
  for (const DripEdits::Addition& added : edits.added) require_valid(added, options);
}

void require_below_roof(const DripEdits& edits, const field::Field& rock,
                        const SeepOptions& options) {
  for (const DripEdits::Move& move : edits.moved) roof_above(rock, move.to, options, move.where);
  for (const DripEdits::Addition& added : edits.added)
    roof_above(rock, added.at, options, added.where);
}

std::vector<Seep> edited(std::vector<Seep> seeps, const field::Field& rock,
                         const SeepOptions& options, const DripEdits& edits) {
  require_valid(edits, options);
  return Editor(std::move(seeps), rock, options).apply(edits);
}

}  // namespace vug::drips
