#include <vug/grammar/rewriting.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::grammar {
namespace {

std::string koch(int steps) {
  // The quadratic Koch island, axiom F-F-F-F (prusinkiewicz1990, figure 1.6).
  std::vector<char> word{'F', '-', 'F', '-', 'F', '-', 'F'};
  const std::string successor = "F-F+F+FF-F-F+F";
  for (int i = 0; i < steps; ++i)
    word = rewrite_step(
        word,
        [&](const std::vector<char>& w, size_t at, std::vector<char>& out) {
          if (w[at] == 'F')
            out.insert(out.end(), successor.begin(), successor.end());
          else
            out.push_back(w[at]);
        },
        1 << 20, 64);
  return {word.begin(), word.end()};
}

TEST(RewriteStep, GrowsAKnownSystem) {
  // Every step turns one F into eight and adds six turns: F = 4 * 8^n, turns = 3 + 6 * 4 (8^n-1)/7.
  const std::string word = koch(4);
  EXPECT_EQ(std::count(word.begin(), word.end(), 'F'), 4 * 4096);
  EXPECT_EQ(word.size(), 4u * 4096 + 3 + 6 * 4 * (4096 - 1) / 7);
}

TEST(RewriteStep, IsTheSameForAnyNumberOfThreads) {
  std::string first;
  for (const int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    const std::string word = koch(4);
    if (first.empty()) first = word;
    EXPECT_EQ(word, first);
  }
}

TEST(RewriteStep, SeesTheOldWordAsContext) {
  // A signal 1 moves right through zeros: every cell copies its left neighbour.
  std::vector<int> cells{1, 0, 0, 0, 0};
  for (int step = 0; step < 3; ++step)
    cells = rewrite_step(
        cells,
        [](const std::vector<int>& old, size_t i, std::vector<int>& out) {
          out.push_back(i == 0 ? 0 : old[i - 1]);
        },
        100, 2);
  EXPECT_EQ(cells, (std::vector<int>{0, 0, 0, 1, 0}));
}

TEST(RewriteStep, StopsAtTheLimit) {
  const std::vector<int> word(1000, 0);
  const auto copy = [](const std::vector<int>&, size_t, std::vector<int>& out) {
    out.push_back(0);
    out.push_back(0);
  };
  EXPECT_EQ(rewrite_step(word, copy, 2000, 100).size(), 2000u);
  EXPECT_THROW(rewrite_step(word, copy, 1999, 100), Error);
}

}  // namespace
}  // namespace vug::grammar
