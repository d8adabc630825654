#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/inference/choices.h>

#include <array>
#include <limits>

namespace vug::inference {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

/// ln of small whole numbers, which nearly all choices are among.
double ln_of(int count) {
  static const std::array<double, 1024> table = [] {
    std::array<double, 1024> out{};
    for (size_t i = 1; i < out.size(); ++i) out[i] = maths::log(static_cast<double>(i));
    return out;
  }();
  const auto index = static_cast<size_t>(count);
  return index < table.size() ? table[index] : maths::log(count);
}

}  // namespace

void Choices::begin() {
  stream_ = nullptr;
  tape_ = nullptr;
  made_.clear();
  ln_ = 0;
}

void Choices::draw(RandomStream& stream) {
  begin();
  stream_ = &stream;
}

void Choices::replay(const Tape& tape) {
  begin();
  tape_ = &tape;
}

void Choices::tell() { begin(); }

bool Choices::possible() const { return ln_ > kImpossible; }

int Choices::next() {
  if (made_.size() >= tape_->size())
    throw Error(ErrorCode::internal, "a move asks for more choices than its tape holds");
  return (*tape_)[made_.size()];
}

int Choices::below(int count, int told) {
  int made = told;
  if (stream_)
    made = count > 0 ? static_cast<int>(stream_->below(static_cast<uint32_t>(count))) : 0;
  else if (tape_)
    made = next();
  made_.push_back(made);
  ln_ = made >= 0 && made < count ? ln_ - ln_of(count) : kImpossible;
  return made;
}

int Choices::among(const Profile& profile, int low, int high, int told) {
  int made = told;
  if (stream_)
    made = low < high ? profile.find(low, high, stream_->uniform()) : low;
  else if (tape_)
    made = next();
  made_.push_back(made);
  ln_ = low < high ? ln_ + profile.ln_probability(low, high, made) : kImpossible;
  return made;
}

void Choices::append(const Choices& others) {
  made_.insert(made_.end(), others.made_.begin(), others.made_.end());
  ln_ += others.ln_;
}

}  // namespace vug::inference
