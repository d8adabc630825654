// SPDX-License-Identifier: Apache-2.0
// One pass of a rule over the cells: access to attributes, and the loops that run its kernel.
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

/// Reads current values and writes next values. A kernel sets every cell that it is called for.
template <class T>
struct AttributeWriter {
  const T* now;
  T* next;
  const T& operator[](uint32_t cell) const { return now[cell]; }
  void set(uint32_t cell, const T& value) const { next[cell] = value; }
};

/// A number that may not exist: `otherwise` in every cell if it does not.
struct OptionalReader {
  const float* now;
  float otherwise;
  float operator[](uint32_t cell) const { return now ? now[cell] : otherwise; }
};

/// Any attribute as numbers (the mean of the components of a vector); 0 if it does not exist.
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

/// Values of two attributes.
struct FloatPair {
  float a, b;
};

class Simulation;

class Pass {
 public:
  Pass(Simulation& simulation, RandomKey key, int step, const std::vector<uint8_t>* where);

  const Network& network() const { return *network_; }
  /// Steps since the stage began: 0 in the first.
  int step() const { return step_; }
  /// The key of the stage, constant over all steps.
  RandomKey key() const { return key_; }
  /// A random stream for one cell in this step.
  RandomStream random(uint32_t cell) const {
    return RandomStream(
        key_.at(position_key(network_->position[cell])).at(static_cast<uint64_t>(step_)));
  }

  /// The attribute of this name; a new one starts with `initial` everywhere.
  template <class T>
  AttributeReader<T> reads(const std::string& name, const T& initial = T(0));
  template <class T>
  AttributeWriter<T> writes(const std::string& name, const T& initial = T(0));
  /// Reads an attribute without creating it.
  OptionalReader reads_optional(const std::string& name, float otherwise) const;
  /// Like `reads_optional`, and records that the simulation's owner should provide the attribute.
  OptionalReader reads_expected(const std::string& name, float otherwise) const;
  bool has(const std::string& name) const;
  /// Reads an attribute of any type that the rule's parameters name.
  NumericReader reads_as_numbers(const std::string& name) const;
  /// Whether the pass updates a cell: it receives and lies in the mask.
  bool updates(uint32_t cell) const {
    return receives((*states_)[cell]) && (!where_ || (*where_)[cell]);
  }
  /// Whether only the attributes matter that rules create; values are not checked.
  bool is_trial() const;
  /// Evaluates a mask at a cell.
  double evaluate(const paint::Mask& mask, uint32_t cell) const;
  /// Current positions of the cells.
  AttributeReader<Vec3f> positions() const;
  /// Current positions ("P") and normals ("N") of the cells, initially those of the network.
  AttributeWriter<Vec3f> writes_positions();
  AttributeWriter<Vec3f> writes_normals();
  AttributeReader<CellState> states() const { return {states_->data()}; }
  AttributeWriter<CellState> writes_states();

  /// Links between cells less than `radius` metres apart (straight-line distance) whose normals are
  /// not opposite; computed once per radius.
  const Links& within(double radius);

  /// Calls kernel(neighbours, cell) in parallel for all receiving cells (inside the mask, if any);
  /// neighbours.each(cell, f) calls f for the distributing neighbours. The written values then
  /// become current. A rule that runs several kernels per step requests its attributes before each.
  template <class Kernel>
  void run(const Kernel& kernel);
  /// Runs a kernel on two numbers that spread: the next values are react(own, sum, count), with
  /// sums over the `count` distributing neighbours. Neighbours are fetched once for both numbers,
  /// and `react` is vectorised if it has no branches.
  template <class React>
  void run_on_sums(const AttributeWriter<float>& a, const AttributeWriter<float>& b,
                   const React& react);
  /// For all cells in any state.
  template <class Kernel>
  void run_everywhere(const Kernel& kernel);

 private:
  const Attributes& attributes() const;
  template <class T>
  AttributeWriter<T> write(Column<T>& column);
  template <class Kernel>
  void run_block(uint32_t block, const Kernel& kernel) const;
  /// For cells of a block in which all cells receive and all neighbours distribute.
  template <class Kernel>
  void run_distributing(uint32_t block, uint32_t from, uint32_t end, const Kernel& kernel) const;
  /// Selects the cells of a block to process; the other receiving cells keep their values.
  uint32_t pick(uint32_t block, uint32_t* picked) const;
  void keep(uint32_t cell) const;
  /// Swaps the written columns and copies the values of cells that became inactive (or were written
  /// while inactive).
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
