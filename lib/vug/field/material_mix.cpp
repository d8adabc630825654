// SPDX-License-Identifier: Apache-2.0
#include <vug/field/material_mix.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace vug::field {

std::string name_fault(const RockMaterial& material) {
  const std::string& name = material.name;
  const auto is_word = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  if (!name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])) &&
      std::all_of(name.begin(), name.end(), is_word))
    return {};
  return fmt::format(
      "invalid name '{}' of a material: it must consist of letters, digits and '_', and must not "
      "start with a digit, e.g. \"limestone\"",
      name);
}

double MaterialMix::weight(std::string_view name) const {
  for (const Part& part : parts())
    if (part.material->name == name) return part.weight;
  return 0;
}

const RockMaterial* MaterialMix::dominant() const {
  const Part* most = nullptr;
  for (const Part& part : parts())
    if (!most || part.weight > most->weight) most = &part;
  return most ? most->material : nullptr;
}

double MaterialMix::hardness() const {
  double sum = 0;
  for (const Part& part : parts()) sum += part.weight * part.material->hardness;
  return std::min(1.0, sum);
}

MaterialMix mixed(const MaterialMix& a, const MaterialMix& b, double share) {
  using Part = MaterialMix::Part;
  if (a.empty() || share >= 1) return b.empty() ? a : b;
  if (b.empty() || share <= 0) return a;
  std::array<Part, 2 * MaterialMix::kMost> all{};
  size_t count = 0;
  const auto add = [&](const RockMaterial* material, double weight) {
    if (weight > 0) all[count++] = {material, weight};
  };
  auto x = a.parts().begin(), y = b.parts().begin();
  while (x != a.parts().end() || y != b.parts().end()) {
    const int order = x == a.parts().end()         ? 1
                      : y == b.parts().end()       ? -1
                      : x->material == y->material ? 0
                                                   : x->material->name.compare(y->material->name);
    const double of_a = order <= 0 ? (1 - share) * x->weight : 0;
    const double of_b = order >= 0 ? share * y->weight : 0;
    add(order <= 0 ? x->material : y->material, of_a + of_b);
    if (order <= 0) ++x;
    if (order >= 0) ++y;
  }
  MaterialMix out;
  double total = 1;
  if (count > MaterialMix::kMost) {
    std::array<size_t, 2 * MaterialMix::kMost> rank{};
    for (size_t i = 0; i < count; ++i) rank[i] = i;
    const auto end = rank.begin() + static_cast<std::ptrdiff_t>(count);
    std::stable_sort(rank.begin(), end,
                     [&](size_t i, size_t j) { return all[i].weight > all[j].weight; });
    std::sort(rank.begin(), rank.begin() + MaterialMix::kMost);  // by name again
    total = 0;
    for (size_t i = 0; i < MaterialMix::kMost; ++i) {
      out.parts_[i] = all[rank[i]];
      total += out.parts_[i].weight;
    }
    count = MaterialMix::kMost;
  } else {
    std::copy_n(all.begin(), count, out.parts_.begin());
  }
  out.count_ = count;
  if (total != 1)
    for (size_t i = 0; i < count; ++i) out.parts_[i].weight /= total;
  return out;
}

}  // namespace vug::field
