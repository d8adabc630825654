#include <vug/base/error.h>
#include <vug/image/compare.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::image {
namespace {

struct Sums {
  double a = 0, b = 0, magnitude = 0, error = 0, squares = 0, largest = 0;
  size_t count = 0;

  void add(double x, double y) {
    ++count;
    if (x == y || (std::isnan(x) && std::isnan(y))) {
      if (!std::isfinite(x)) return;
    }
    double difference = std::fabs(x - y);
    if (std::isnan(difference)) difference = std::numeric_limits<double>::infinity();
    a += x;
    b += y;
    magnitude += std::fabs(x);
    error += difference;
    squares += difference * difference;
    largest = std::max(largest, difference);
  }

  ChannelDifference finish(std::string name) const {
    const double n = count > 0 ? static_cast<double>(count) : 1;
    ChannelDifference d;
    d.channel = std::move(name);
    d.mean_a = a / n;
    d.mean_b = b / n;
    d.rmse = std::sqrt(squares / n);
    if (d.rmse > 0)
      d.relative_rmse =
          magnitude > 0 ? d.rmse / (magnitude / n) : std::numeric_limits<double>::infinity();
    d.mean_error = error / n;
    d.max_error = largest;
    return d;
  }
};

}  // namespace

std::vector<ChannelDifference> compare(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height)
    throw Error(ErrorCode::bad_input,
                fmt::format("pictures of different size cannot be compared: {} x {} and {} x {}",
                            a.width, a.height, b.width, b.height));
  if (a.channels != b.channels)
    throw Error(ErrorCode::bad_input,
                fmt::format("pictures with different channels cannot be compared: {} and {}",
                            fmt::join(a.channels, " "), fmt::join(b.channels, " ")));
  std::vector<Sums> sums(a.channels.size());
  Sums all;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    sums[i % sums.size()].add(static_cast<double>(a.pixels[i]), static_cast<double>(b.pixels[i]));
    all.add(static_cast<double>(a.pixels[i]), static_cast<double>(b.pixels[i]));
  }
  std::vector<ChannelDifference> out;
  for (size_t c = 0; c < sums.size(); ++c) out.push_back(sums[c].finish(a.channels[c]));
  out.push_back(all.finish("all"));
  return out;
}

}  // namespace vug::image
