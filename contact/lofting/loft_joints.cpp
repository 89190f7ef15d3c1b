// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/loft_joints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "contact/lofting/loft_points.hpp"

namespace contactsim {

namespace {

/// Wedges that open by less than this beyond a straight line are none [radians].
constexpr double just_open = -0.02;

/// Skins that are nearer to each other than this share of the thickness meet.
constexpr double just_apart = 1e-6;

/// Sides of joints: no edge of a shell has them.
constexpr std::uint8_t side_of_strip = 7, side_of_end = 8;

/// A shell at one of its edges, seen along the edge from its lower node to its higher one.
struct EdgeOfShell {
  NodeIndex low, high;
  std::uint32_t shell = 0;
  std::array<int, 2> corners{};  ///< of the shell, at the lower node and the higher one
  Eigen::Vector3d inwards;       ///< unit, in the shell and square to the edge [1]
  bool has_top_ahead = false;    ///< its top looks the way in which angles about the edge grow
  double angle = 0.0;            ///< about the edge, from any direction
};

/// Joins bricks along edges that shells share, then closes the ends of what it has put there.
class JointMaker {
 public:
  JointMaker(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates, LoftGeometry& loft)
      : mesh_(mesh), x_(coordinates), loft_(loft), points_(loft, mesh) {
    for (const LoftFacet& facet : loft.facets) {
      if (facet.part == LoftPart::top) tops_.push_back(facet.vertices);
      if (facet.part == LoftPart::bottom) bottoms_.push_back(facet.vertices);
    }
  }

  void join_edges();
  void close_ends();
  void take() {
    std::ranges::stable_sort(made_, {}, [&](const LoftFacet& facet) { return key_of(facet); });
    loft_.facets.insert(loft_.facets.end(), made_.begin(), made_.end());
  }

 private:
  using Corner = std::array<std::uint32_t, 2>;  // vertices of a skin at the two ends of an edge

  std::size_t n_corners(std::uint32_t shell) const { return tops_[shell][2] == tops_[shell][3] ? 3 : 4; }
  /// The vertex of a shell at a corner, of its top or bottom.
  std::uint32_t vertex(std::uint32_t shell, int corner, bool is_top) const;
  NodeIndex node(std::uint32_t shell, int corner) const {
    return loft_.node_of_vertex[vertex(shell, corner, true)];
  }
  Eigen::Vector3d at(std::uint32_t vertex) const { return loft_.vertices.col(vertex); }
  EdgeOfShell make_edge(std::uint32_t shell, int corner) const;
  std::vector<EdgeOfShell> list_edges() const;
  void join_around(std::span<EdgeOfShell> edge);
  void join(const EdgeOfShell& first, const EdgeOfShell& next);
  void close_chain(std::vector<std::uint32_t> chain, ElementIndex element);
  void add_end(ElementIndex element, std::uint32_t a, std::uint32_t b, std::uint32_t c);
  std::uint32_t add_middle(std::uint32_t vertex);
  using FacetKey = std::tuple<ElementIndex, std::uint8_t, std::array<NodeIndex, 4>>;
  FacetKey key_of(const LoftFacet& facet) const;

  /// The end of a joint at a node: from one skin to the next, as the hole that is left there runs.
  struct End {
    std::uint32_t from = 0, to = 0;  ///< vertices
    ElementIndex element;
  };

  const Mesh& mesh_;
  const Eigen::Matrix3Xd& x_;
  LoftGeometry& loft_;
  LoftPoints points_;                                         // of the bricks: which vertices are the same
  std::vector<std::array<std::uint32_t, 4>> tops_, bottoms_;  // [n_shells] vertices, as facets have them
  std::vector<LoftFacet> made_;
  std::map<NodeIndex, std::vector<End>> ends_;
};

std::uint32_t JointMaker::vertex(std::uint32_t shell, int corner, bool is_top) const {
  const auto k = static_cast<std::size_t>(corner), n = n_corners(shell);
  return is_top ? tops_[shell][k] : bottoms_[shell][(n - k) % n];
}

EdgeOfShell JointMaker::make_edge(std::uint32_t shell, int corner) const {
  const int next = (corner + 1) % static_cast<int>(n_corners(shell));
  EdgeOfShell edge{node(shell, corner), node(shell, next), shell, {corner, next}, {}, false, 0.0};
  const bool is_turned = edge.high < edge.low;
  if (is_turned) std::swap(edge.low, edge.high), std::swap(edge.corners[0], edge.corners[1]);
  const Eigen::Vector3d from = x_.col(edge.low.value);
  const Eigen::Vector3d along = (x_.col(edge.high.value) - from).normalized();
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < n_corners(shell); ++k) middle += x_.col(node(shell, static_cast<int>(k)).value);
  const Eigen::Vector3d in = middle / static_cast<double>(n_corners(shell)) - from;
  edge.inwards = (in - along.dot(in) * along).normalized();
  // Round a shell's top its edges run anticlockwise: its normal is along x inwards.
  edge.has_top_ahead = !is_turned;
  return edge;
}

std::vector<EdgeOfShell> JointMaker::list_edges() const {
  std::vector<EdgeOfShell> edges;
  for (std::uint32_t shell = 0; shell < tops_.size(); ++shell) {
    for (int corner = 0; corner < static_cast<int>(n_corners(shell)); ++corner) {
      edges.push_back(make_edge(shell, corner));
      if (edges.back().low == edges.back().high) edges.pop_back();
    }
  }
  std::ranges::stable_sort(edges, {}, [](const EdgeOfShell& edge) { return std::pair(edge.low, edge.high); });
  return edges;
}

void JointMaker::join_edges() {
  std::vector<EdgeOfShell> edges = list_edges();
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].low == edges[first].low &&
           edges[last].high == edges[first].high)
      ++last;
    if (last - first > 1) join_around(std::span(edges).subspan(first, last - first));
  }
}

void JointMaker::join_around(std::span<EdgeOfShell> edge) {
  const Eigen::Vector3d along = (x_.col(edge[0].high.value) - x_.col(edge[0].low.value)).normalized();
  const Eigen::Vector3d u = edge[0].inwards, v = along.cross(u);
  for (EdgeOfShell& one : edge) one.angle = std::atan2(v.dot(one.inwards), u.dot(one.inwards));
  std::ranges::stable_sort(edge, {}, &EdgeOfShell::angle);
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const EdgeOfShell &first = edge[i], &next = edge[(i + 1) % edge.size()];
    const double turn = i + 1 < edge.size() ? 0.0 : 2.0 * std::numbers::pi;
    if (next.angle + turn - first.angle - std::numbers::pi > just_open) join(first, next);
  }
}

/// Spans the wedge between two neighbours around an edge.
void JointMaker::join(const EdgeOfShell& first, const EdgeOfShell& next) {
  Corner a{}, b{};
  for (std::size_t end = 0; end < 2; ++end) {
    a[end] = vertex(first.shell, first.corners[end], first.has_top_ahead);
    b[end] = vertex(next.shell, next.corners[end], !next.has_top_ahead);
  }
  const double thickness = std::min(loft_.offsets[a[0]].thickness, loft_.offsets[b[0]].thickness);
  const Eigen::Vector3d outwards = (first.inwards + next.inwards).stableNormalized();
  const auto are_apart = [&](std::size_t end) {
    const Eigen::Vector3d way = at(b[end]) - at(a[end]);
    // Of skins in one plane, and of one at a step in thickness, nothing is between.
    return points_.of_vertex(a[end]) != points_.of_vertex(b[end]) &&
           (way - outwards.dot(way) * outwards).norm() > just_apart * thickness;
  };
  const bool apart_low = are_apart(0), apart_high = are_apart(1);
  if (!apart_low && !apart_high) return;
  const ElementIndex element = loft_.shells[std::min(first.shell, next.shell)];
  // Round the edge from the first skin to the next one, then along it: anticlockwise from outside.
  std::array<std::uint32_t, 4> corners{a[0], b[0], b[1], a[1]};
  if (!apart_high) corners = {a[0], b[0], a[1], a[1]};
  if (!apart_low) corners = {a[0], b[1], a[1], a[1]};
  made_.push_back({element, LoftPart::joint, side_of_strip, corners});
  if (apart_low) ends_[first.low].push_back({b[0], a[0], element});
  if (apart_high) ends_[first.high].push_back({a[1], b[1], element});
}

void JointMaker::close_ends() {
  for (auto& entry : ends_) {
    auto& ends = entry.second;
    while (!ends.empty()) {
      // A chain starts where nothing ends, or anywhere if it is closed.
      const auto is_same = [&](std::uint32_t a, std::uint32_t b) {
        return points_.of_vertex(a) == points_.of_vertex(b);
      };
      auto start = std::ranges::find_if(ends, [&](const End& one) {
        return std::ranges::none_of(ends, [&](const End& other) { return is_same(other.to, one.from); });
      });
      if (start == ends.end()) start = ends.begin();
      std::vector<std::uint32_t> chain{start->from, start->to};
      ElementIndex element = start->element;
      ends.erase(start);
      for (auto next = ends.begin(); next != ends.end();) {
        if (!is_same(next->from, chain.back())) {
          ++next;
          continue;
        }
        chain.push_back(next->to);
        element = std::min(element, next->element);
        ends.erase(next);
        next = ends.begin();
      }
      close_chain(std::move(chain), element);
    }
  }
}

/// Closes what joints leave open at a node: a ring of three or more skins by triangles among them, an open
/// chain by triangles to the node itself.
void JointMaker::close_chain(std::vector<std::uint32_t> chain, ElementIndex element) {
  const bool is_ring = points_.of_vertex(chain.front()) == points_.of_vertex(chain.back());
  if (is_ring) {
    for (std::size_t i = 1; i + 2 < chain.size(); ++i) add_end(element, chain[0], chain[i], chain[i + 1]);
    return;
  }
  const std::uint32_t middle = add_middle(chain.front());
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) add_end(element, middle, chain[i], chain[i + 1]);
}

void JointMaker::add_end(ElementIndex element, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Eigen::Vector3d area = 0.5 * Eigen::Vector3d(at(b) - at(a)).cross(at(c) - at(a));
  const double thickness = loft_.offsets[b].thickness;
  if (!(area.norm() > just_apart * thickness * thickness)) return;
  made_.push_back({element, LoftPart::joint, side_of_end, {a, b, c, c}});
}

/// A vertex at the node of another one.
std::uint32_t JointMaker::add_middle(std::uint32_t vertex) {
  const NodeIndex node = loft_.node_of_vertex[vertex];
  LoftOffset offset = loft_.offsets[vertex];
  offset.height = 0.0;
  const auto added = static_cast<std::uint32_t>(loft_.offsets.size());
  loft_.node_of_vertex.push_back(node);
  loft_.offsets.push_back(offset);
  loft_.vertices.conservativeResize(Eigen::NoChange, added + 1);
  loft_.vertices.col(added) = x_.col(node.value);
  return added;
}

JointMaker::FacetKey JointMaker::key_of(const LoftFacet& facet) const {
  std::array<NodeIndex, 4> nodes{};
  for (std::size_t k = 0; k < 4; ++k) nodes[k] = loft_.node_of_vertex[facet.vertices[k]];
  return {facet.element, facet.side, nodes};
}

}  // namespace

void add_joints(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates, LoftGeometry& loft) {
  if (loft.shells.empty()) return;
  JointMaker maker(mesh, coordinates, loft);
  maker.join_edges();
  maker.close_ends();
  maker.take();
}

}  // namespace contactsim
