// One pass of a rule over the cells: its attributes, and the loops that run its kernel.
#pragma once

#include <vug/base/rng.h>
#include <vug/cells/blocks.h>
#include <vug/cells/neighbourhood.h>
#include <vug/cells/network.h>
#include <vug/paint/paint.h>

namespace vug::cells {

template <class T>
struct AttributeReader {
  const T* now;
  const T& operator[](uint32_t cell) const { return now[cell]; }
};

/// Reads what is, writes what will be. A kernel sets every cell that it is given.
template <class T>
struct AttributeWriter {
  const T* now;
  T* next;
  const T& operator[](uint32_t cell) const { return now[cell]; }
  void set(uint32_t cell, const T& value) const { next[cell] = value; }
};

/// A number that somebody may have brought: `otherwise` in every cell where nobody has.
struct OptionalReader {
  const float* now;
  float otherwise;
  float operator[](uint32_t cell) const { return now ? now[cell] : otherwise; }
};

/// Any attribute as numbers, of a vector the mean of its parts; 0 where there is none.
struct NumericReader {
  const Attribute* of;
  float operator[](uint32_t cell) const {
    return !of ? 0
               : std::visit([cell](const auto& column) { return number(column.now[cell]); },
                            of->column);
  }

 private:
  static float number(float value) { return value; }
  static float number(int32_t value) { return static_cast<float>(value); }
  static float number(const Vec3f& value) { return (value.x + value.y + value.z) / 3; }
};

/// Of two attributes.
struct FloatPair {
  float a, b;
};

class Simulation;

class Pass {
 public:
  Pass(Simulation& simulation, RandomKey key, int step, const std::vector<uint8_t>* where);

  const Network& network() const { return *network_; }
  /// Steps since the stage began: 0 in its first.
  int step() const { return step_; }
  /// Of the stage, the same in every step.
  RandomKey key() const { return key_; }
  /// Of one cell in this step.
  RandomStream random(uint32_t cell) const {
    return RandomStream(
        key_.at(position_key(network_->position[cell])).at(static_cast<uint64_t>(step_)));
  }

  /// The attribute of that name; one that is not there starts with `initial` everywhere.
  template <class T>
  AttributeReader<T> reads(const std::string& name, const T& initial = T(0));
  template <class T>
  AttributeWriter<T> writes(const std::string& name, const T& initial = T(0));
  /// The same without bringing it.
  OptionalReader reads_optional(const std::string& name, float otherwise) const;
  /// And so that whoever runs the simulation knows that it had better be there.
  OptionalReader reads_expected(const std::string& name, float otherwise) const;
  bool has(const std::string& name) const;
  /// Of whatever type, for a rule whose text names it.
  NumericReader reads_as_numbers(const std::string& name) const;
  /// What a mask says of a cell.
  double evaluate(const paint::Mask& mask, uint32_t cell) const;
  /// Where cells are now.
  AttributeReader<Vec3f> positions() const;
  /// Where cells have moved to ("P") and how they face ("N"); at first as in the network.
  AttributeWriter<Vec3f> writes_positions();
  AttributeWriter<Vec3f> writes_normals();
  AttributeReader<CellState> states() const { return {states_->data()}; }
  AttributeWriter<CellState> writes_states();

  /// Cells less than `radius` metres apart through the air, whose normals do not oppose: made once
  /// for each radius.
  const Links& within(double radius);

  /// kernel(neighbours, cell) for all cells that receive (and, with a mask, are in it), in
  /// parallel; neighbours.each(cell, f) calls f for the neighbours that distribute. What it has set
  /// becomes what is. A rule that runs several kernels in a step asks for its attributes before
  /// each.
  template <class Kernel>
  void run(const Kernel& kernel);
  /// The same for two numbers that spread: what is next is react(own, sum, count), of the sums over
  /// the `count` neighbours that distribute. Neighbours are fetched once for both, and react is
  /// called for several cells at once where it has no branches.
  template <class React>
  void run_on_sums(const AttributeWriter<float>& a, const AttributeWriter<float>& b,
                   const React& react);
  /// For all cells, whatever their state.
  template <class Kernel>
  void run_everywhere(const Kernel& kernel);

 private:
  const Attributes& attributes() const;
  template <class T>
  AttributeWriter<T> write(Column<T>& column);
  template <class Kernel>
  void run_block(uint32_t block, const Kernel& kernel) const;
  /// Cells of a block in which all receive and hear all their neighbours.
  template <class Kernel>
  void run_distributing(uint32_t block, uint32_t from, uint32_t end, const Kernel& kernel) const;
  /// The cells of a block that are to be given; the others that receive keep what they have.
  uint32_t pick(uint32_t block, uint32_t* picked) const;
  void keep(uint32_t cell) const;
  /// Swaps what was written, and puts cells that fell asleep (or were written in their sleep) to
  /// rest.
  void finish(const std::vector<uint32_t>& blocks, bool everywhere);

  Simulation* simulation_;
  const Network* network_;
  const Blocks* blocks_;
  const std::vector<CellState>* states_;
  RandomKey key_;
  int step_;
  const std::vector<uint8_t>* where_;
  std::vector<std::variant<Column<float>*, Column<Vec3f>*, Column<int32_t>*>> written_;
  bool writes_states_ = false;
};

}  // namespace vug::cells

#include <vug/cells/pass_inl.h>
#include <vug/cells/pass_sums_inl.h>
