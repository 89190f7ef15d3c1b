// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/single_values.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <set>

#include "core/dynamics/rank_share.hpp"
#include "core/output/output_groups.hpp"

namespace contactsim {

namespace {

// One entity of a model and how a name says which.
struct Place {
  EntityRange range;
  std::string ending;  // "node_42"
};

// The position whose point is nearest, of equals the first in the file.
template <class Point, class Place>
std::optional<std::size_t> find_nearest_of(std::size_t n, const Eigen::Vector3d& to, Point point,
                                           Place place) {
  std::optional<std::size_t> nearest;
  double min_distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    const double distance = (point(i) - to).squaredNorm();
    const bool is_before = nearest && distance == min_distance && place(i) < place(*nearest);
    if (!(distance < min_distance) && !is_before) continue;
    min_distance = distance;
    nearest = i;
  }
  return nearest;
}

class ValueMaker {
 public:
  ValueMaker(const OutputVariables& variables, const std::string& separator, Diagnostics& diagnostics)
      : variables_(variables),
        model_(variables.model()),
        mesh_(*model_.mesh),
        separator_(separator),
        diagnostics_(diagnostics) {}

  void add(const VariableRequest& request) {
    const auto selection = find_selection(variables_, request.location, request.variable, diagnostics_);
    if (!selection) return;
    const auto place = find_place(request, *selection);
    if (!place) return;
    std::string name = field_name(request, *selection, separator_);
    if (!names_.insert(fold(name)).second) {
      name += separator_ + place->ending;
      if (place->ending.empty() || !names_.insert(fold(name)).second) {
        warn(request, fmt::format("there is a value {} already: this one is left out", name),
             "an alias gives it another name: AS <alias>");
        return;
      }
    }
    fields_.push_back(make_field(*selection, model_, place->range, name));
    fields_.back().field.location = FieldLocation::global;
    fields_.back().field.block = 0;
    fields_.back().field.separator = separator_;
  }

  std::vector<RequestedFields::Field> take() { return std::move(fields_); }

 private:
  void warn(const VariableRequest& request, std::string text, std::string hint = "") {
    const DeckName& at = request.variable.name;
    diagnostics_.add_warning("output-value-left-out", at.location, std::move(text), std::move(hint),
                             static_cast<int>(at.text.size()));
  }

  std::optional<Place> find_place(const VariableRequest& request, const VariableSelection& selection) {
    if (selection.variable->location == FieldLocation::global) return Place{};
    const bool is_nodal = selection.variable->location == FieldLocation::node;
    if (const auto* single = std::get_if<SingleEntity>(&request.place))
      return is_nodal ? find_node(*single) : find_element(request, selection, *single);
    if (const auto* nearest = std::get_if<NearestEntity>(&request.place))
      return is_nodal ? find_nearest_node(nearest->point)
                      : find_nearest_element(request, selection, *nearest);
    warn(request, fmt::format("{} is asked for without a place", output_name(request)),
         is_nodal ? "AT NODE <id> or NEAREST LOCATION <x> <y> <z>"
                  : "AT ELEMENT <id> or NEAREST LOCATION <x> <y> <z>");
    return std::nullopt;
  }

  std::optional<Place> find_node(const SingleEntity& single) {
    if (const auto node = mesh_.find_node(single.id)) return at_node(node->value);
    diagnostics_.add_error(single.location, fmt::format("the mesh has no node {}", single.id));
    return std::nullopt;
  }

  Place at_node(std::uint32_t node) const {
    return {{0, node, 1, {}}, fmt::format("node{}{}", separator_, mesh_.node_id({node}))};
  }

  std::optional<Place> find_nearest_node(const Eigen::Vector3d& point) {
    const auto nearest = find_nearest_of(
        mesh_.n_nodes(), point,
        [&](std::size_t n) { return Eigen::Vector3d(mesh_.coordinates().col(static_cast<Eigen::Index>(n))); },
        [&](std::size_t n) { return mesh_.node_place({static_cast<std::uint32_t>(n)}); });
    if (!nearest) return std::nullopt;
    return at_node(static_cast<std::uint32_t>(*nearest));
  }

  std::optional<Place> find_element(const VariableRequest& request, const VariableSelection& selection,
                                    const SingleEntity& single) {
    const auto element = mesh_.find_element(single.id);
    if (!element) {
      diagnostics_.add_error(single.location, fmt::format("the mesh has no element {}", single.id));
      return std::nullopt;
    }
    for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
      const ModelBlock& block = model_.blocks[b];
      const std::uint32_t first = block.first_element.value;
      if (element->value < first || element->value - first >= block.n_elements) continue;
      if (selection.is_in_block(model_, b)) return at_element(b, element->value - first);
    }
    warn(request, fmt::format("element {} has no {}", single.id, output_name(request)));
    return std::nullopt;
  }

  Place at_element(std::size_t block, std::size_t element) const {
    const auto index = model_.blocks[block].first_element.value + static_cast<std::uint32_t>(element);
    return {{block, element, 1, {}}, fmt::format("element{}{}", separator_, mesh_.element_id({index}))};
  }

  Eigen::Vector3d centroid(std::size_t block, std::size_t element) const {
    const ElementBlock& own = mesh_.blocks()[model_.blocks[block].mesh_block];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const auto nodes = own.element_nodes(static_cast<std::uint32_t>(element));
    for (const NodeIndex node : nodes) sum += mesh_.coordinates().col(node.value);
    return sum / static_cast<double>(nodes.size());
  }

  std::optional<Place> find_nearest_element(const VariableRequest& request,
                                            const VariableSelection& selection,
                                            const NearestEntity& nearest) {
    std::optional<Place> found;
    double min_distance = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
      if (!selection.is_in_block(model_, b)) continue;
      const std::uint32_t first = model_.blocks[b].first_element.value;
      const auto own = find_nearest_of(
          model_.blocks[b].n_elements, nearest.point, [&](std::size_t e) { return centroid(b, e); },
          [&](std::size_t e) { return mesh_.element_place({first + static_cast<std::uint32_t>(e)}); });
      if (!own) continue;
      const double distance = (centroid(b, *own) - nearest.point).squaredNorm();
      if (distance >= min_distance) continue;
      min_distance = distance;
      found = at_element(b, *own);
    }
    if (!found) warn(request, fmt::format("no element has {}", output_name(request)));
    return found;
  }

  const OutputVariables& variables_;
  const Model& model_;
  const Mesh& mesh_;
  const std::string& separator_;
  Diagnostics& diagnostics_;
  std::set<std::string> names_;  // folded
  std::vector<RequestedFields::Field> fields_;
};

constexpr int every_rank = -1;

int rank_that_knows(const RequestedFields& fields, std::size_t field, const Model& model,
                    const RankShare& share) {
  const EntityRange& range = fields.range(field);
  const auto entity = static_cast<std::uint32_t>(range.first);
  const FieldLocation location = fields.selection(field).variable->location;
  if (location == FieldLocation::node) return share.rank_of(NodeIndex{entity});
  if (location != FieldLocation::element) return every_rank;
  return share.rank_of(ElementIndex{model.blocks[range.block].first_element.value + entity})
      .value_or(every_rank);
}

/// Gives all ranks each value that one of them knows.
void take_from_ranks(std::span<const int> known_by, Ranks& ranks, std::span<double> values) {
  const std::size_t n = values.size();
  std::vector<double> of_all(n * static_cast<std::size_t>(ranks.count()));
  std::vector<std::size_t> begins;
  for (std::size_t rank = 0; rank <= static_cast<std::size_t>(ranks.count()); ++rank)
    begins.push_back(rank * n);
  std::ranges::copy(values, of_all.begin() + static_cast<std::ptrdiff_t>(n) * ranks.rank());
  ranks.gather_items(std::span(of_all), begins);
  for (std::size_t i = 0; i < n; ++i) {
    if (known_by[i] != every_rank) values[i] = of_all[static_cast<std::size_t>(known_by[i]) * n + i];
  }
}

}  // namespace

RequestedFields make_single_values(const OutputVariables& variables,
                                   std::span<const VariableRequest> requests, const std::string& separator,
                                   Diagnostics& diagnostics) {
  ValueMaker maker(variables, separator, diagnostics);
  for (const VariableRequest& request : expand_groups(variables, requests, diagnostics)) maker.add(request);
  return RequestedFields(maker.take());
}

std::vector<std::string> value_names(const RequestedFields& fields) {
  std::vector<std::string> names;
  for (const OutputField& field : fields.fields()) {
    for (int c = 0; c < field.n_components; ++c) names.push_back(component_name(field, c));
  }
  return names;
}

std::vector<std::string> value_dimensions(const RequestedFields& fields) {
  std::vector<std::string> dimensions;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string& known = fields.selection(i).variable->dimension;
    dimensions.insert(dimensions.end(), fields.selection(i).n_components(), known.empty() ? "[?]" : known);
  }
  return dimensions;
}

std::vector<double> evaluate_all(RequestedFields& fields, const OutputContext& context) {
  const RankShare* share = context.share;
  std::vector<double> all;
  std::vector<int> ranks;  // that know them
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::span<const double> values = fields.evaluate(i, context);
    all.insert(all.end(), values.begin(), values.end());
    if (share != nullptr) ranks.resize(all.size(), rank_that_knows(fields, i, context.model, *share));
  }
  if (share != nullptr && std::ranges::any_of(ranks, [](int rank) { return rank != every_rank; }))
    take_from_ranks(ranks, share->ranks(), all);
  return all;
}

}  // namespace contactsim
