// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/scout/choose.h>

#include <algorithm>
#include <optional>

namespace vug::scout {
namespace {

struct Quota {
  Framing framing;
  size_t count;
};
constexpr Quota kQuotas[] = {
    {Framing::wide, 2}, {Framing::low, 2}, {Framing::close, 2}, {Framing::up, 1}};
constexpr double kGoodEnough = 0.5;  // of the best score
constexpr double kDifferent = 0.7;   // weight of the similarity
constexpr double kApart = 8;         // metres

class Choice {
 public:
  explicit Choice(const std::vector<Rated>& all) : all_(all) {
    for (const Rated& each : all) best_ = std::max(best_, each.score);
  }

  /// The index of the best addition to the shots, among those that `allowed` admits.
  template <class Allowed>
  std::optional<size_t> next(const Allowed& allowed) const {
    std::optional<size_t> found;
    double most = -kInfinity;
    for (size_t i = 0; i < all_.size(); ++i) {
      if (!allowed(i) || std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
      const double value = all_[i].score / best_ - kDifferent * nearest(i);
      if (value > most) most = value, found = i;
    }
    return found;
  }

  size_t count(Framing framing) const {
    return static_cast<size_t>(std::count_if(chosen.begin(), chosen.end(), [&](size_t i) {
      return all_[i].candidate.framing == framing;
    }));
  }
  double best() const { return best_; }

  std::vector<size_t> chosen;

 private:
  double nearest(size_t i) const {
    double most = 0;
    for (const size_t other : chosen) most = std::max(most, similarity(all_[i], all_[other]));
    return most;
  }

  const std::vector<Rated>& all_;
  double best_ = 0;
};

/// The position of the last shot whose framing has more than its quota; none: all are needed.
std::optional<size_t> spare(const Choice& choice, const std::vector<Rated>& all) {
  for (size_t k = choice.chosen.size(); k-- > 1;) {
    const Framing framing = all[choice.chosen[k]].candidate.framing;
    size_t needed = 0;
    for (const Quota& quota : kQuotas)
      if (quota.framing == framing) needed = quota.count;
    if (choice.count(framing) > needed) return k;
  }
  return std::nullopt;
}

}  // namespace

std::map<uint32_t, double> object_shares(const View& view) {
  std::map<uint32_t, double> shares;
  for (const Seen& each : view.pixels) ++shares[each.object];
  for (auto& [object, share] : shares) share /= static_cast<double>(view.pixels.size());
  return shares;
}

double similarity(const Rated& a, const Rated& b) {
  const Pose &p = a.candidate.pose, &q = b.candidate.pose;
  const double away = (p.eye - q.eye).length() / kApart;
  const double turned = azimuth_between(p.azimuth, q.azimuth) / (40 * kDegree);
  double overlap = 0;
  for (const auto& [object, share] : a.shares)
    if (const auto other = b.shares.find(object); other != b.shares.end())
      overlap += std::min(share, other->second);
  return maths::exp(-away * away - turned * turned) * overlap;
}

std::vector<size_t> choose_shots(const std::vector<Rated>& all, size_t wanted) {
  Choice choice(all);
  if (!(choice.best() > 0)) return {};
  while (choice.chosen.size() < wanted) {
    const auto next = choice.next([&](size_t i) { return all[i].score > 0; });
    if (!next) break;
    choice.chosen.push_back(*next);
  }
  for (const Quota& quota : kQuotas)
    while (wanted >= 12 && choice.count(quota.framing) < quota.count) {
      const auto next = choice.next([&](size_t i) {
        return all[i].candidate.framing == quota.framing &&
               all[i].score >= kGoodEnough * choice.best();
      });
      if (!next) break;
      if (choice.chosen.size() < wanted) {
        choice.chosen.push_back(*next);
        continue;
      }
      const auto replaced = spare(choice, all);
      if (!replaced) break;
      choice.chosen.erase(choice.chosen.begin() + static_cast<std::ptrdiff_t>(*replaced));
      choice.chosen.push_back(*next);
    }
  std::stable_sort(choice.chosen.begin(), choice.chosen.end(),
                   [&](size_t a, size_t b) { return all[a].score > all[b].score; });
  return choice.chosen;
}

}  // namespace vug::scout
