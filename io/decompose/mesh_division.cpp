// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/mesh_division.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "io/decompose/bisect_points.hpp"
#include "io/pieces/side_factors.hpp"

namespace contactsim {

namespace {

/// The means of the nodes of all elements: 3 x n_elements [length].
Eigen::Matrix3Xd find_centres(const Mesh& mesh) {
  Eigen::Matrix3Xd centres = Eigen::Matrix3Xd::Zero(3, mesh.n_elements());
  for (const ElementBlock& block : mesh.blocks()) {
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      auto centre = centres.col(block.first_element.value + e);
      for (const NodeIndex node : block.element_nodes(e)) centre += mesh.coordinates().col(node.value);
      centre /= static_cast<double>(block.nodes_per_element);
    }
  }
  return centres;
}

/// Sides as they are compared across pieces.
struct SideOfPiece {
  std::array<NodeIndex, 4> corners;  ///< sorted
  std::uint32_t piece = 0, element = 0;
  int side = 0;

  auto key() const {
    return std::tuple(corners[0].value, corners[1].value, corners[2].value, corners[3].value);
  }
};

class MeshDivider {
 public:
  MeshDivider(const Mesh& mesh, const ExodusFile& file, std::vector<std::uint32_t> piece_of,
              std::uint32_t n_pieces)
      : mesh_(mesh),
        file_(file),
        n_pieces_(n_pieces),
        layout_(file.layout()),
        piece_of_(std::move(piece_of)) {}

  MeshDivision divide() {
    divide_elements();
    divide_nodes();
    share_sides();
    find_positions_of_sets();
    return std::move(made_);
  }

 private:
  void divide_elements() {
    DividedAxis& all = add_axis("num_elem", mesh_.n_elements());
    local_.resize(mesh_.n_elements());
    for (std::uint32_t e = 0; e < mesh_.n_elements(); ++e) {
      local_[e] = static_cast<std::uint32_t>(all.positions[piece_of_[e]].size());
      all.positions[piece_of_[e]].push_back(e);
    }
    std::uint32_t first = 0;
    for (std::size_t number = 1; number <= layout_.length("num_el_blk"); ++number) {
      const std::string dimension = fmt::format("num_el_in_blk{}", number);
      const auto n = static_cast<std::uint32_t>(layout_.length(dimension));
      if (n == 0) continue;
      DividedAxis& axis = add_axis(dimension, n);
      for (std::uint32_t e = 0; e < n; ++e) axis.positions[piece_of_[first + e]].push_back(e);
      first += n;
    }
  }

  /// Calls visit(node) once for each node of a piece's elements.
  template <class Visit>
  void visit_nodes(std::uint32_t piece, std::vector<std::uint32_t>& last_pieces, const Visit& visit) const {
    for (const std::uint32_t e : made_.division.at("num_elem").positions[piece]) {
      for (const NodeIndex node : mesh_.element_nodes({e})) {
        if (std::exchange(last_pieces[node.value], piece) != piece) visit(node.value);
      }
    }
  }

  void find_pieces_of_nodes() {
    constexpr std::uint32_t none = 0xffffffffu;
    first_piece_.assign(mesh_.n_nodes() + std::size_t{1}, 0);
    std::vector<std::uint32_t> last_pieces(mesh_.n_nodes(), none);
    for (std::uint32_t piece = 0; piece < n_pieces_; ++piece)
      visit_nodes(piece, last_pieces, [&](std::uint32_t node) { ++first_piece_[node + 1]; });
    for (std::uint32_t node = 0; node < mesh_.n_nodes(); ++node)
      first_piece_[node + 1] = first_piece_[node] + std::max(first_piece_[node + 1], 1u);
    pieces_of_nodes_.assign(first_piece_.back(), 0);
    std::vector<std::uint32_t> next(first_piece_.begin(), first_piece_.end() - 1);
    std::ranges::fill(last_pieces, none);
    for (std::uint32_t piece = 0; piece < n_pieces_; ++piece)
      visit_nodes(piece, last_pieces, [&](std::uint32_t node) { pieces_of_nodes_[next[node]++] = piece; });
  }

  /// Ascending; of a node without elements the first piece.
  std::span<const std::uint32_t> pieces_of(std::uint32_t node) const {
    return std::span(pieces_of_nodes_)
        .subspan(first_piece_[node], first_piece_[node + 1] - first_piece_[node]);
  }

  void divide_nodes() {
    find_pieces_of_nodes();
    DividedAxis& axis = add_axis("num_nodes", mesh_.n_nodes());
    made_.nodes.resize(n_pieces_);
    for (std::uint32_t node = 0; node < mesh_.n_nodes(); ++node) {
      for (const std::uint32_t piece : pieces_of(node)) {
        const auto position = static_cast<std::uint32_t>(axis.positions[piece].size());
        for (const std::uint32_t other : pieces_of(node)) {
          if (other != piece) made_.nodes[piece].push_back({position, other});
        }
        axis.positions[piece].push_back(node);
      }
    }
  }

  bool is_shared(std::span<const NodeIndex> nodes) const {
    return std::ranges::all_of(nodes, [&](NodeIndex node) { return pieces_of(node.value).size() > 1; });
  }

  void share_sides() {
    std::vector<SideOfPiece> sides;
    for (const ElementBlock& block : mesh_.blocks()) {
      const auto n_sides = static_cast<int>(topology(block.shape).sides.size());
      for (std::uint32_t e = 0; e < block.n_elements; ++e) {
        const std::uint32_t element = block.first_element.value + e;
        for (int side = 1; side <= n_sides; ++side) {
          std::array<NodeIndex, 4> corners = mesh_.side_nodes(ElementSide({element}, side));
          if (!is_shared(corners)) continue;
          std::ranges::sort(corners, {}, &NodeIndex::value);
          sides.push_back({corners, piece_of_[element], local_[element], side});
        }
      }
    }
    std::ranges::stable_sort(sides, {}, &SideOfPiece::key);
    made_.sides.resize(n_pieces_);
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      while (end < sides.size() && sides[end].key() == sides[begin].key()) ++end;
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t j = begin; j < end; ++j) {
          if (sides[i].piece != sides[j].piece)
            made_.sides[sides[i].piece].push_back({sides[i].element, sides[i].side, sides[j].piece});
        }
      }
    }
    for (std::vector<SharedSide>& of_piece : made_.sides) {
      const auto key = [](const SharedSide& shared) {
        return std::tuple(shared.element, shared.side, shared.piece);
      };
      std::ranges::sort(of_piece, {}, key);
      const auto is_same = [&](const SharedSide& a, const SharedSide& b) { return key(a) == key(b); };
      of_piece.erase(std::unique(of_piece.begin(), of_piece.end(), is_same), of_piece.end());
    }
  }

  void find_positions_of_sets() {
    for (const NetcdfDimension& dimension : layout_.dimensions) {
      const auto divided = find_divided(dimension.name);
      if (!divided || dimension.length == 0 || made_.division.contains(dimension.name)) continue;
      if (divided->kind == DividedKind::node_set) divide_nodes_of_set(dimension, divided->number);
      if (divided->kind == DividedKind::side_set) divide_sides_of_set(dimension, divided->number);
      if (divided->kind == DividedKind::element_set) divide_elements_of_set(dimension, divided->number);
    }
  }

  std::vector<std::int64_t> read_numbers(const std::string& name, std::size_t n, std::size_t limit) const {
    const auto variable = file_.find_variable(name);
    if (!variable || variable->shape != std::vector{n})
      file_.fail(fmt::format("variable {} should have {} values", name, n));
    std::vector<std::int64_t> numbers(n);
    file_.read_int64(*variable, numbers);
    for (const std::int64_t number : numbers) {
      if (number < 1 || static_cast<std::uint64_t>(number) > limit)
        file_.fail(fmt::format("variable {} holds {}, which is not in 1 to {}", name, number, limit));
    }
    return numbers;
  }

  void divide_nodes_of_set(const NetcdfDimension& dimension, std::size_t number) {
    const auto nodes = read_numbers(fmt::format("node_ns{}", number), dimension.length, mesh_.n_nodes());
    DividedAxis& axis = add_axis(dimension.name, dimension.length);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      for (const std::uint32_t piece : pieces_of(static_cast<std::uint32_t>(nodes[i] - 1)))
        axis.positions[piece].push_back(i);
    }
    const bool rises = std::ranges::adjacent_find(nodes, std::greater_equal<>()) == nodes.end();
    if (!rises && dimension.name.starts_with("num_nod")) made_.ordered_sets.push_back(dimension.name);
  }

  /// The entries of a set of elements, each in the piece of its element.
  DividedAxis& divide_by_elements(const NetcdfDimension& dimension, std::span<const std::int64_t> elements) {
    DividedAxis& axis = add_axis(dimension.name, dimension.length);
    for (std::uint32_t i = 0; i < elements.size(); ++i)
      axis.positions[piece_of_[static_cast<std::size_t>(elements[i]) - 1]].push_back(i);
    return axis;
  }

  void divide_elements_of_set(const NetcdfDimension& dimension, std::size_t number) {
    const auto elements =
        read_numbers(fmt::format("elem_els{}", number), dimension.length, mesh_.n_elements());
    divide_by_elements(dimension, elements);
    if (!std::ranges::is_sorted(elements) && dimension.name.starts_with("num_ele"))
      made_.ordered_sets.push_back(dimension.name);
  }

  void divide_sides_of_set(const NetcdfDimension& dimension, std::size_t number) {
    const auto elements =
        read_numbers(fmt::format("elem_ss{}", number), dimension.length, mesh_.n_elements());
    const auto sides = read_numbers(fmt::format("side_ss{}", number), dimension.length, 0x7fffffff);
    const DividedAxis& axis = divide_by_elements(dimension, elements);
    std::vector<std::pair<std::int64_t, std::int64_t>> keys;
    for (std::size_t i = 0; i < sides.size(); ++i) keys.emplace_back(elements[i], sides[i]);
    if (!std::ranges::is_sorted(keys)) made_.ordered_sets.push_back(dimension.name);
    divide_factors_of_set(axis, elements, sides, number);
  }

  void divide_factors_of_set(const DividedAxis& of_sides, std::span<const std::int64_t> elements,
                             std::span<const std::int64_t> sides, std::size_t number) {
    const std::string name = fmt::format("num_df_ss{}", number);
    const std::size_t n = layout_.length(name);
    if (n == 0) return;
    std::vector<ShapedSide> shaped;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const auto element = ElementIndex{static_cast<std::uint32_t>(elements[i] - 1)};
      shaped.push_back({mesh_.blocks()[mesh_.block_of(element)].shape, sides[i]});
    }
    const auto counts = contactsim::divide_factors(shaped, n);
    if (!counts)
      file_.fail(fmt::format("side set number {}: {} distribution factors cannot be divided among {} sides",
                             number, n, sides.size()));
    std::vector<std::uint32_t> begins{0};
    for (const std::size_t count : *counts)
      begins.push_back(begins.back() + static_cast<std::uint32_t>(count));
    DividedAxis& axis = add_axis(name, n);
    for (std::uint32_t piece = 0; piece < n_pieces_; ++piece) {
      for (const std::uint32_t side : of_sides.positions[piece]) {
        for (std::uint32_t f = begins[side]; f < begins[side + 1]; ++f) axis.positions[piece].push_back(f);
      }
    }
  }

  DividedAxis& add_axis(const std::string& dimension, std::size_t length) {
    DividedAxis& axis = made_.division[dimension];
    axis.length = length;
    axis.positions.assign(n_pieces_, {});
    return axis;
  }

  const Mesh& mesh_;
  const ExodusFile& file_;
  std::uint32_t n_pieces_;
  NetcdfLayout layout_;
  MeshDivision made_;
  std::vector<std::uint32_t> piece_of_, local_;               // of each element, its position in the piece
  std::vector<std::uint32_t> first_piece_, pieces_of_nodes_;  // [n_nodes + 1] where those of each node begin
};

}  // namespace

std::vector<std::uint32_t> bisect_elements(const Mesh& mesh, std::uint32_t n_pieces) {
  return bisect_points(find_centres(mesh), n_pieces);
}

MeshDivision divide_mesh(const Mesh& mesh, const ExodusFile& file, std::vector<std::uint32_t> piece_of,
                         std::uint32_t n_pieces) {
  return MeshDivider(mesh, file, std::move(piece_of), n_pieces).divide();
}

}  // namespace contactsim
