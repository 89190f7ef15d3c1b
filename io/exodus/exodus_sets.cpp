// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "io/exodus/exodus_entities.hpp"
#include "io/exodus/index_arrays.hpp"
#include "io/pieces/side_factors.hpp"

namespace contactsim {

namespace {

// Side numbers of shapes that are not known; ElementSide holds no larger ones.
constexpr int n_sides_unknown = 8;

[[noreturn]] void fail(const ExodusFile& file, EntityKind kind, const EntityRow& row,
                       const std::string& what) {
  file.fail(fmt::format("{}: {}", describe(kind, row.id, row.name), what));
}

// The numbers 1..limit of a set's variable as positions; empty when the set has none.
std::vector<std::uint32_t> read_numbers(const ExodusFile& file, EntityKind kind, const EntityRow& row,
                                        const std::string& variable_name, std::uint32_t limit) {
  if (row.is_null) return {};
  const auto variable = file.find_variable(variable_name);
  if (!variable) return {};
  if (variable->shape.size() != 1) fail(file, kind, row, "variable " + variable_name + " is not a list");
  std::vector<std::uint32_t> positions;
  const IndexArray found = read_positions(file, *variable, limit, positions);
  if (!found.bad) return positions;
  fail(file, kind, row,
       fmt::format("entry {}: {} holds {}, which is not in 1 to {}", found.bad->position + 1, variable_name,
                   found.bad->value, limit));
}

std::vector<double> read_factors(const ExodusFile& file, const EntityRow& row,
                                 const std::string& variable_name) {
  if (row.is_null) return {};
  const auto variable = file.find_variable(variable_name);
  if (!variable) return {};
  std::vector<double> factors(variable->size());
  file.read_double(*variable, factors);
  return factors;
}

void warn_of_factors(Diagnostics& warnings, const ExodusFile& file, EntityKind kind, const EntityRow& row,
                     std::size_t found, std::size_t expected) {
  warn(warnings, file, "mesh-distribution-factors",
       fmt::format("{}: {} distribution factors where {} belong; they are left out",
                   describe(kind, row.id, row.name), found, expected));
}

/// Finds the block of an element position and checks side numbers against its shape.
class SideChecker {
 public:
  explicit SideChecker(std::span<const ElementBlock> blocks) : blocks_(blocks) {
    for (const ElementBlock& block : blocks_) ends_.push_back(n_elements() + block.n_elements);
  }

  std::uint32_t n_elements() const { return ends_.empty() ? 0 : ends_.back(); }

  const ElementBlock& block_of(std::uint32_t element) {
    // Neighbours in a list are mostly of one block.
    if (last_ >= ends_.size() || element >= ends_[last_] ||
        element < ends_[last_] - blocks_[last_].n_elements) {
      last_ = static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), element) - ends_.begin());
    }
    return blocks_[last_];
  }

 private:
  std::span<const ElementBlock> blocks_;
  std::vector<std::uint32_t> ends_;  ///< position after the last element of each block
  std::size_t last_ = 0;
};

int count_sides(Shape shape) {
  return shape == Shape::unknown ? n_sides_unknown : static_cast<int>(topology(shape).sides.size());
}

std::vector<ElementSide> join_sides(const ExodusFile& file, const EntityRow& row, SideChecker& checker,
                                    std::span<const std::uint32_t> elements,
                                    std::span<const std::uint32_t> sides) {
  if (elements.size() != sides.size()) {
    fail(file, EntityKind::side_set, row,
         fmt::format("{} elements but {} sides", elements.size(), sides.size()));
  }
  std::vector<ElementSide> joined(elements.size());
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const ElementBlock& block = checker.block_of(elements[i]);
    const std::int64_t side = std::int64_t{sides[i]} + 1;
    if (side > count_sides(block.shape)) {
      fail(file, EntityKind::side_set, row,
           fmt::format("entry {}: element {} of {} has no side {} (type '{}', sides 1 to {})", i + 1,
                       elements[i] + 1, describe(EntityKind::block, block.id, block.name), side,
                       block.type_name, count_sides(block.shape)));
    }
    joined[i] = ElementSide({elements[i]}, static_cast<int>(side));
  }
  return joined;
}

// How many factors belong to the set by the manual: one for each node of each side.
std::optional<std::size_t> count_factors(const SideSet& set, SideChecker& checker) {
  std::size_t sum = 0;
  for (const ElementSide& side : set.sides) {
    const auto n_nodes = count_side_nodes(checker.block_of(side.element().value).shape, side.side());
    if (!n_nodes) return std::nullopt;
    sum += *n_nodes;
  }
  return sum;
}

}  // namespace

std::vector<NodeSet> read_node_sets(const ExodusFile& file, std::uint32_t n_nodes, Diagnostics& warnings) {
  std::vector<NodeSet> sets;
  for (const EntityRow& row : read_entity_rows(file, EntityKind::node_set, warnings)) {
    NodeSet& set = sets.emplace_back();
    set.id = row.id;
    set.name = row.name;
    const std::string suffix = fmt::to_string(row.number);
    for (std::uint32_t node : read_numbers(file, EntityKind::node_set, row, "node_ns" + suffix, n_nodes)) {
      set.nodes.push_back({node});
    }
    set.distribution_factors = read_factors(file, row, "dist_fact_ns" + suffix);
    const std::size_t n_factors = set.distribution_factors.size();
    if (n_factors == 0 || n_factors == set.nodes.size()) continue;
    warn_of_factors(warnings, file, EntityKind::node_set, row, n_factors, set.nodes.size());
    set.distribution_factors.clear();
  }
  return sets;
}

std::vector<SideSet> read_side_sets(const ExodusFile& file, std::span<const ElementBlock> blocks,
                                    Diagnostics& warnings) {
  constexpr std::uint32_t any_side = 0x7fffffff;
  SideChecker checker(blocks);
  std::vector<SideSet> sets;
  for (const EntityRow& row : read_entity_rows(file, EntityKind::side_set, warnings)) {
    SideSet& set = sets.emplace_back();
    set.id = row.id;
    set.name = row.name;
    const std::string suffix = fmt::to_string(row.number);
    const auto elements =
        read_numbers(file, EntityKind::side_set, row, "elem_ss" + suffix, checker.n_elements());
    const auto sides = read_numbers(file, EntityKind::side_set, row, "side_ss" + suffix, any_side);
    set.sides = join_sides(file, row, checker, elements, sides);
    set.distribution_factors = read_factors(file, row, "dist_fact_ss" + suffix);
    const std::size_t n_factors = set.distribution_factors.size();
    const std::size_t expected = count_factors(set, checker).value_or(n_factors);
    if (n_factors == 0 || n_factors == expected || n_factors == set.sides.size()) continue;
    warn_of_factors(warnings, file, EntityKind::side_set, row, n_factors, expected);
    set.distribution_factors.clear();
  }
  return sets;
}

}  // namespace contactsim
