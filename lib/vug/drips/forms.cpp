// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/drips/chemistry.h>
#include <vug/drips/drop.h>
#include <vug/drips/forms.h>
#include <vug/drips/growth.h>

#include <algorithm>
#include <cmath>

namespace vug::drips {
namespace {

/// In radii of the tip: the least length of hanging forms, the length at which they begin to come
/// out of the roof, and the least height of standing forms.
constexpr double kLeastHanging = 6, kFirstHanging = 3, kLeastStanding = 0.05;
/// The share of the gap that a stalactite takes at most without a stalagmite below it.
constexpr double kMostHanging = 0.8;
/// Under drops that follow faster than the first time in seconds, the apex is a cone, whose cosine
/// falls to the last number under the fastest.
constexpr double kCandle = 20, kFastestDrip = 2, kSteepest = 0.75;
constexpr double kThickestTrunk = 0.155;  // Of stalagmites, metres.
/// The greatest coat of columns in metres, and the years in which it reaches 63 % of that, and in
/// which the calcite covers the waist.
constexpr double kCoat = 0.15, kCoatYears = 12000, kCoverYears = 1000;
/// The foot of a stalagmite is aside of its apex where the drip has moved, by an angle in radians
/// with this standard deviation and maximum, and downhill by this share of the floor's slope.
constexpr double kTrunkLean = 0.022, kMostTrunkLean = 0.05, kDownhill = 0.08;
/// The foot is aside by at most this number of radii, and this share of the height.
constexpr double kMostAside = 1.6, kMostTilt = 0.08;
/// On this share of the stumps an end grows again, up to that share of the lost length.
constexpr double kRegrown = 0.55, kMostRegrown = 0.5;
/// Stalactites break at an age of the oldest drips between these shares of the final one.
constexpr double kFirstBreak = 0.5, kLastBreak = 0.95;
/// Ribs form at the wavelength of a film, 2.7 cm, of which 1 to 4 merge; trunks of this radius in
/// metres have them from the first height in radii on, and full ones from the second on.
constexpr double kFluteWave = 0.027, kFlutedRadius = 0.07, kFlutedHeight = 5, kFullFlutes = 9;
constexpr int kFewestFlutes = 6, kMostFlutes = 20;
/// Both parts of a column meet aside of each other by this share of the radius at most.
constexpr double kOffset = 0.4;
/// Domes grow at the feet of stalagmites under drips faster than this in seconds; their scale in
/// radii of the trunk.
constexpr double kDomeInterval = 15, kDomeScale = 0.45;

/// The tangent of a slope's angle, at most 2.
double slope_tangent(const Vec3d& normal) {
  const double level = std::fabs(normal.y);
  return level > 0.45 ? std::sqrt(std::max(0.0, 1 - level * level)) / level : 2;
}

class Grower {
 public:
  Grower(const Graph& graph, const FormOptions& o)
      : graph_(graph), o_(o), curve_(common_curve(o.girth)) {}

  void grow(const Node& drop, const Node& landing, std::vector<Form>& out) const {
    RandomStream random(RandomKey(o_.seed).at("form").at(static_cast<uint64_t>(drop.id)));
    Draws draws;
    const bool chosen = random.uniform() < o_.stalagmites;
    draws.breaks = random.uniform() < o_.broken;
    draws.break_at = random.uniform(0.2, 0.7);
    draws.lean = std::clamp(kTrunkLean * random.normal(), -kMostTrunkLean, kMostTrunkLean);
    draws.heading = random.uniform(0, kPi);
    draws.regrows = random.uniform() < kRegrown;
    draws.regrown = kMostRegrown * random.uniform();
    draws.merged = random.uniform(1, 4);
    draws.offset = kOffset * random.uniform();
    draws.break_age = o_.final_age * random.uniform(kFirstBreak, kLastBreak);
    Form common;
    common.heading = 2 * draws.heading;
    common.drip = drop.id;
    common.interval = graph_.interval(drop);
    common.age = drop.water.age;
    common.plane = drop.plane;
    const double gap = drop.position.y - landing.position.y;
    const bool stands = chosen && landing.growth > 0;
    const double stump = length_of_stump(drop, landing, stands, draws);
    const bool met = stands && landing.met > 0 && stump == 0;
    const double height = met ? landing.met_at : std::min(landing.growth, gap - stump);
    if (stump > 0)
      out.push_back(broken(common, drop, stump, draws));
    else
      hang(common, drop, met ? gap - height : stands ? gap : kMostHanging * gap, out);
    if (stands && height >= kLeastStanding * o_.tip)
      out.push_back(stalagmite(common, drop, landing, height, draws));
    if (met) out.push_back(column(common, drop, landing, draws));
  }

 private:
  /// The random numbers of a drip, which are drawn for each of them.
  struct Draws {
    bool breaks = false, regrows = false;
    double break_at = 0, break_age = 0, regrown = 0;
    double lean = 0, heading = 0, merged = 1, offset = 0;
  };

  double tip_radius(const Node& drop) const {
    return std::max(o_.tip, 0.5 * straw_diameter(drop.water.temperature));
  }

  /// The length of the stalactite when it broke, 0 if it has not broken.
  double length_of_stump(const Node& drop, const Node& landing, bool stands,
                         const Draws& draws) const {
    if (!draws.breaks || drop.straw || o_.age < draws.break_age) return 0;
    const double share = draws.break_age / o_.age;
    if (stands && landing.met > drop.water.age * (1 - share)) return 0;  // A column by then.
    Water then = drop.water;
    then.calcium = drop.arriving;
    then.age *= share;
    const double gap = drop.position.y - landing.position.y;
    const double length = std::min(grow_stalactite(then, graph_.interval(drop), curve_).length,
                                   stands ? gap : kMostHanging * gap);
    return length >= kLeastHanging * tip_radius(drop) ? length : 0;
  }

  Form broken(const Form& common, const Node& drop, double length, const Draws& draws) const {
    Form form = hanging(common, drop, length);
    form.broken = draws.break_at;
    form.since = common.age * (1 - draws.break_age / o_.age);
    if (draws.regrows)
      form.regrown =
          std::min(draws.regrown * draws.break_at * length, std::max(0.0, drop.growth - length));
    return form;
  }

  void hang(const Form& common, const Node& drop, double longest, std::vector<Form>& out) const {
    const double tip = tip_radius(drop), length = std::min(drop.growth, longest);
    const double first = kFirstHanging * tip, least = kLeastHanging * tip;
    if (!(length > first)) return;
    Form form = hanging(common, drop, std::max(length, least));
    if (length < least) {
      const double shown = least * (length - first) / (least - first);
      form.sunk = least - shown;
      form.bottom = form.top + (form.bottom - form.top) * (shown / least);
    }
    out.push_back(form);
  }

  Form stalagmite(const Form& common, const Node& drop, const Node& landing, double height,
                  const Draws& draws) const {
    Form form = standing(common, drop, landing);
    form.top = landing.position + Vec3d(0, height, 0);
    const double aside = height * maths::tan(draws.lean);
    Vec3d foot(aside * maths::cos(draws.heading), 0, aside * maths::sin(draws.heading));
    foot += Vec3d(landing.normal.x, 0, landing.normal.z) * (kDownhill * height);
    const double most = std::min(kMostAside * form.radius, kMostTilt * height);
    if (foot.length() > most) foot *= most / foot.length();
    form.bottom += foot;
    form.root += foot.length() * slope_tangent(landing.normal);
    if (form.radius >= kFlutedRadius) {
      form.flutes = flutes(form.radius, draws.merged);
      form.ribs = std::clamp((height / form.radius - kFlutedHeight) / (kFullFlutes - kFlutedHeight),
                             0.0, 1.0);
    }
    if (form.interval < kDomeInterval)
      form.dome = kDomeScale * form.radius * (1 - form.interval / kDomeInterval);
    return form;
  }

  static int flutes(double radius, double merged) {
    const auto ribs = static_cast<int>(2 * kPi * radius / (kFluteWave * merged));
    return std::clamp(ribs, kFewestFlutes, kMostFlutes);
  }

  Form hanging(Form form, const Node& drop, double length) const {
    const double tip = tip_radius(drop);
    const bool straw = drop.straw && o_.tip <= straw_diameter(drop.water.temperature);
    form.kind = straw ? FormKind::straw : FormKind::stalactite;
    form.radius = straw ? tip : root_radius(curve_, length, tip);
    form.root = form.radius * slope_tangent(drop.normal) + o_.tip;
    form.top = drop.position;
    const Vec3d axis = drop.tip - drop.position;
    form.bottom = drop.position + axis * (length / axis.length());
    return form;
  }

  Form standing(Form form, const Node& drop, const Node& landing) const {
    form.kind = FormKind::stalagmite;
    const double trunk =
        std::min(kThickestTrunk, trunk_radius(graph_.drop, drop.water.temperature, form.interval));
    form.scatter = landing.scatter;
    form.radius = std::max(std::sqrt(trunk * trunk + form.scatter * form.scatter), 1.2 * o_.tip);
    const double hurry = std::clamp((kCandle - form.interval) / (kCandle - kFastestDrip), 0.0, 1.0);
    form.apex_cosine = 1 - hurry * (1 - kSteepest);
    form.bottom = landing.position;
    form.root = 2 * form.radius * slope_tangent(landing.normal) + o_.tip;
    return form;
  }

  /// A film of calcite covers both since they met.
  Form column(const Form& common, const Node& drop, const Node& landing, const Draws& draws) const {
    Form form = standing(common, drop, landing);
    form.kind = FormKind::column;
    form.top = drop.position;
    form.waist = landing.met_at / (drop.position.y - landing.position.y);
    form.since = landing.met;
    form.coat = kCoat * (1 - maths::exp(-form.since / kCoatYears));
    form.cover = 1 - maths::exp(-form.since / kCoverYears);
    form.root = 2 * (form.radius + form.coat) *
                    std::max(slope_tangent(landing.normal), slope_tangent(drop.normal)) +
                o_.tip;
    form.flutes = flutes(form.radius + 0.5 * kCoat, draws.merged);
    form.ribs = form.cover;
    form.offset = draws.offset * form.radius * form.cover;
    return form;
  }

  const Graph& graph_;
  const FormOptions& o_;
  field::StalactiteCurve curve_;
};

}  // namespace

std::vector<Form> forms_of(const Graph& graph, const FormOptions& options) {
  std::vector<Form> forms;
  const Grower grower(graph, options);
  for (const Edge& edge : graph.edges)
    if (edge.kind == EdgeKind::fall)
      grower.grow(graph.nodes[static_cast<size_t>(edge.from)],
                  graph.nodes[static_cast<size_t>(edge.to)], forms);
  std::stable_sort(forms.begin(), forms.end(),
                   [](const Form& a, const Form& b) { return a.drip < b.drip; });
  return forms;
}

}  // namespace vug::drips
