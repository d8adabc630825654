// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/scout/scout.h>
#include <vug/scout/trace_view.h>

#include <algorithm>
#include <array>

namespace vug::scout {
namespace {

constexpr size_t kRefined = 24;    // candidates that are refined
constexpr int kSteps = 20;         // of the coordinate search
constexpr double kPenalty = 0.25;  // for a view that fails one gate
constexpr size_t kSpare = 4;       // shots that get lamps, of which the worst are left out
constexpr int kLitWidth = 32, kLitHeight = 18;

/// A view with all that is known about it.
struct Trial {
  Rated rated;
  ScoreTerms terms;
  std::vector<Gate> failed;
};

class Search {
 public:
  Search(const Location& location, const ScoutOptions& options, Progress& progress)
      : location_(location), options_(options), progress_(progress), key_(options.seed) {}

  ScoutResult run() {
    const std::vector<Stand> floor = places_to_stand(location_);
    std::vector<Candidate> poses = candidates(*location_.world, floor, {}, key_);
    landmarks_ = find_landmarks(location_, views_of(poses));
    const std::vector<Subject> subjects = find_subjects(location_, landmarks_);
    if (!subjects.empty()) poses = candidates(*location_.world, floor, subjects, key_);
    std::vector<Trial> trials = rate_all(poses);
    ScoutResult result;
    result.candidates = trials.size();
    for (const Trial& each : trials) result.passed += each.failed.empty() && each.rated.score > 0;
    if (result.passed < options_.shots) result.strictest = strictest(trials);
    refine(trials);
    const size_t wanted = options_.shots + (needs_lamps() ? kSpare : 0);
    for (const size_t i : choose_shots(rated(trials), wanted))
      result.shots.push_back(
          {trials[i].rated.candidate, trials[i].terms, trials[i].rated.score, {}});
    if (needs_lamps()) light(result.shots);
    if (result.shots.empty())
      throw Error(ErrorCode::bad_input, "no view of the scene is fit for a picture", {},
                  result.strictest ? "most views fail because it is required that " +
                                         gate_text(*result.strictest)
                                   : "the lamps of the scene leave all views dark");
    return result;
  }

 private:
  bool needs_lamps() const { return !location_.lit && !options_.data_folders.empty(); }

  /// Gives each shot its lamps, and keeps the shots that are the best with them.
  void light(std::vector<ScoutedShot>& shots) const {
    progress_.begin("choosing lamps", shots.size());
    for (size_t i = 0; i < shots.size(); ++i) {
      ScoutedShot& shot = shots[i];
      const auto camera = camera_of(shot.candidate.pose);
      shot.lamps = choose_lamps(location_, *camera, options_.data_folders, landmarks_,
                                key_.at("lamps").at(i), options_.key_ratio);
      std::vector<render::LightPtr> lights = lights_of(shot.lamps, options_.data_folders);
      lights.insert(lights.end(), location_.scene.lights.begin(), location_.scene.lights.end());
      const View view = trace_view(*location_.world, *camera, kLitWidth, kLitHeight);
      const auto luminance = illuminate(*location_.world, lights, view, key_.at("light"));
      shot.score *= light_terms(luminance, view).total();
      progress_.check();
      progress_.advance();
    }
    progress_.end();
    std::erase_if(shots, [](const ScoutedShot& shot) { return !(shot.score > 0); });
    std::stable_sort(shots.begin(), shots.end(),
                     [](const auto& a, const auto& b) { return a.score > b.score; });
    if (shots.size() > options_.shots) shots.resize(options_.shots);
  }

  std::vector<View> views_of(const std::vector<Candidate>& poses) const {
    std::vector<View> views(poses.size());
    parallel_for(poses.size(), [&](size_t i) {
      views[i] = trace_view(*location_.world, *camera_of(poses[i].pose), kLitWidth, kLitHeight);
    });
    return views;
  }

  Trial rate(const Candidate& candidate) const {
    Trial trial;
    trial.rated.candidate = candidate;
    const double free = clearance(*location_.world, candidate.pose.eye);
    if (!(free > 0)) return trial;
    const auto camera = camera_of(candidate.pose);
    const View view = trace_view(*location_.world, *camera);
    GateLimits limits = limits_of(candidate.framing);
    limits.sky_shines = location_.sky_shines;
    trial.failed = failed_gates(view, free, limits);
    trial.rated.shares = object_shares(view);
    if (trial.failed.size() > 1 || std::any_of(trial.failed.begin(), trial.failed.end(), is_strict))
      return trial;
    trial.terms = score(view, landmarks_);
    trial.rated.score = trial.terms.total() * (trial.failed.empty() ? 1 : kPenalty);
    if (location_.lit && options_.judge_light && trial.rated.score > 0) {
      const View small = trace_view(*location_.world, *camera, kLitWidth, kLitHeight);
      const auto light =
          illuminate(*location_.world, location_.scene.lights, small, key_.at("light"));
      trial.rated.score *= light_terms(light, small).total();
    }
    return trial;
  }

  std::vector<Trial> rate_all(const std::vector<Candidate>& poses) const {
    std::vector<Trial> trials(poses.size());
    progress_.begin("scoring views", poses.size());
    parallel_for(poses.size(), [&](size_t i) {
      progress_.check();
      trials[i] = rate({rounded(poses[i].pose), poses[i].framing});
      progress_.advance();
    });
    progress_.end();
    return trials;
  }

  /// Replaces the best and most different candidates by the best poses around them, which
  /// coordinate search finds.
  void refine(std::vector<Trial>& trials) const {
    const std::vector<size_t> best = choose_shots(rated(trials), kRefined);
    std::vector<Trial> refined(best.size());
    progress_.begin("refining views", best.size());
    parallel_for(best.size(), [&](size_t i) {
      progress_.check();
      refined[i] = refined_around(trials[best[i]]);
      progress_.advance();
    });
    progress_.end();
    for (size_t i = 0; i < best.size(); ++i) trials[best[i]] = std::move(refined[i]);
  }

  Trial refined_around(Trial trial) const {
    std::array<double, 5> steps = {0.2, 0.2, 3 * kDegree, 2 * kDegree, 3 * kDegree};
    for (int k = 0; k < kSteps; ++k) {
      const auto axis = static_cast<size_t>(k) % steps.size();
      bool better = false;
      for (const double sign : {1.0, -1.0}) {
        Candidate next = trial.rated.candidate;
        const double by = sign * steps[axis];
        (axis == 0   ? next.pose.eye.x
         : axis == 1 ? next.pose.eye.z
         : axis == 2 ? next.pose.azimuth
         : axis == 3 ? next.pose.pitch
                     : next.pose.fov) += by;
        if (axis < 2 && !stand_up(trial.rated.candidate.pose.eye, next.pose.eye)) continue;
        next.pose.fov = std::clamp(next.pose.fov, 35 * kDegree, 80 * kDegree);
        next.pose = rounded(next.pose);
        Trial tried = rate(next);
        if (tried.rated.score <= trial.rated.score) continue;
        trial = std::move(tried);
        better = true;
        break;
      }
      if (!better) steps[axis] *= 0.5;
    }
    return trial;
  }

  /// Lifts the eye to its height above the floor of its new place; false if it has none.
  bool stand_up(const Vec3d& from, Vec3d& eye) const {
    const auto old = floor_below(*location_.world, from, 2.5);
    const auto now = floor_below(*location_.world, eye, 2.5);
    if (!old || !now) return false;
    eye.y = now->y + from.y - old->y;
    return true;
  }

  static std::vector<Rated> rated(const std::vector<Trial>& trials) {
    std::vector<Rated> out;
    for (const Trial& each : trials) out.push_back(each.rated);
    return out;
  }

  static std::optional<Gate> strictest(const std::vector<Trial>& trials) {
    std::array<size_t, kGates> counts{};
    for (const Trial& each : trials)
      for (const Gate gate : each.failed) ++counts[static_cast<size_t>(gate)];
    const auto most = std::max_element(counts.begin(), counts.end());
    if (*most == 0) return std::nullopt;
    return static_cast<Gate>(most - counts.begin());
  }

  const Location& location_;
  const ScoutOptions& options_;
  Progress& progress_;
  RandomKey key_;
  Landmarks landmarks_;
};

}  // namespace

ScoutResult find_shots(const Location& location, const ScoutOptions& options, Progress& progress) {
  return Search(location, options, progress).run();
}

}  // namespace vug::scout
