// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/passage_line.h>

#include <mutex>
#include <tuple>
#include <vector>

namespace vug::shot {
namespace {

/// The networks that are on the axes of passages, for as long as their source exists. A scene asks
/// for many points of one network, and the axes of a large one take ten milliseconds.
class Courses {
 public:
  NetworkPtr of(const PassageLine& line) {
    const std::lock_guard lock(computing_);
    std::erase_if(all_, [](const Course& each) { return each.source.expired(); });
    const Key key{line.width, line.height, line.sinuosity, line.smooth, line.splays};
    for (const Course& each : all_)
      if (each.key == key && each.source.lock() == line.of) return each.network;
    auto made =
        std::make_shared<const network::Network>(passages::on_axes(*line.of, line.options()));
    if (all_.size() == kMost) all_.erase(all_.begin());
    all_.push_back({line.of, key, made});
    return made;
  }

 private:
  static constexpr size_t kMost = 16;
  using Key = std::tuple<double, double, double, bool, bool>;
  struct Course {
    std::weak_ptr<const network::Network> source;
    Key key;
    NetworkPtr network;
  };
  std::mutex computing_;
  std::vector<Course> all_;
};

}  // namespace

NetworkPtr PassageLine::axes() const {
  static Courses courses;
  return courses.of(*this);
}

NetworkPtr PointLine::course() const { return !middle || of->legs.empty() ? of : axes(); }

}  // namespace vug::shot
