#include <vug/fit/hints.h>

namespace vug::fit {

Hints Hints::none(int width, int height) {
  const inference::Profile x(std::vector<double>(static_cast<size_t>(width) + 1, 1));
  const inference::Profile y(std::vector<double>(static_cast<size_t>(height) + 1, 1));
  return {x, x, y, y, y};
}

}  // namespace vug::fit
