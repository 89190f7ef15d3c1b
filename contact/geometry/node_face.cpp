// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/node_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace contactsim {

namespace {

// One set of formulas for a number of one pair, a double, and for those of eight, Lanes.

using std::abs;
using std::sqrt;
Lanes abs(const Lanes& a) { return a.abs(); }
Lanes sqrt(const Lanes& a) { return a.sqrt(); }
bool any(bool holds) { return holds; }
bool any(const LaneMask& holds) { return holds.any(); }
double select(bool holds, double where_it_holds, double elsewhere) {
  return holds ? where_it_holds : elsewhere;
}
using contactsim::select;

template <class Number>
using Truth = decltype(Number() < Number());

template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Number inner_product(const Vector<Number>& a, const Vector<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Vector<Number> difference(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The map of a face by components.
template <class Number>
struct ComponentMap {
  Vector<std::array<Number, 4>> c;

  Vector<Number> at(const Number& xi, const Number& eta) const {
    const Number xi_eta = xi * eta;
    const auto component = [&](std::size_t i) {
      return c[i][0] + xi * c[i][1] + eta * c[i][2] + xi_eta * c[i][3];
    };
    return {component(0), component(1), component(2)};
  }
  /// The tangents at a point: derivatives by xi and by eta.
  Vector<Number> tangent_xi(const Number& eta) const { return sum_of<1>(eta); }
  Vector<Number> tangent_eta(const Number& xi) const { return sum_of<2>(xi); }
  Vector<Number> twist() const { return {c[0][3], c[1][3], c[2][3]}; }

 private:
  template <std::size_t k>
  Vector<Number> sum_of(const Number& other) const {
    return {c[0][k] + other * c[0][3], c[1][k] + other * c[1][3], c[2][k] + other * c[2][3]};
  }
};

/// The map that takes the values of corners [component][corner].
template <class Number>
ComponentMap<Number> make_map(const Vector<std::array<Number, 4>>& x, const Truth<Number>& is_triangle) {
  ComponentMap<Number> map;
  for (std::size_t i = 0; i < 3; ++i) map.c[i] = quadrilateral_map(x[i][0], x[i][1], x[i][2], x[i][3]);
  if (!any(is_triangle)) return map;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto of_triangle = triangle_map<Number>(x[i][0], x[i][1], x[i][2], 0.0);
    for (std::size_t k = 0; k < 4; ++k) map.c[i][k] = select(is_triangle, of_triangle[k], map.c[i][k]);
  }
  return map;
}

/// The coordinates at which the vector to the point stands upright on the face; returns whether there are
/// such. Lanes that have converged, or have nothing to converge to, wait for the others.
template <class Number>
Truth<Number> find_closest_point(const ComponentMap<Number>& map, const Vector<Number>& point, Number& xi,
                                 Number& eta) {
  constexpr int max_iterations = 20;
  constexpr double accuracy =
      1e-8;  // of the coordinates, which are of order one: the next step would be its square
  constexpr double far_away = 10.0;  // such points project inside other faces
  Truth<Number> found(true), goes_on(true);
  for (int i = 0; i < max_iterations && any(goes_on); ++i) {
    const Vector<Number> a = map.tangent_xi(eta), b = map.tangent_eta(xi),
                         away = difference(point, map.at(xi, eta));
    const Number aa = inner_product(a, a), bb = inner_product(b, b),
                 ab = inner_product(a, b) - inner_product(away, map.twist());
    const Number ra = inner_product(away, a), rb = inner_product(away, b), det = aa * bb - ab * ab;
    const Number d_xi = (ra * bb - rb * ab) / det, d_eta = (rb * aa - ra * ab) / det;
    xi = select(goes_on, xi + d_xi, xi);
    eta = select(goes_on, eta + d_eta, eta);
    const Truth<Number> is_near = det > 0.0 && abs(xi) < far_away && abs(eta) < far_away;
    found = found && (is_near || !goes_on);
    goes_on = goes_on && is_near && !(abs(d_xi) + abs(d_eta) < accuracy);
  }
  return found;
}

/// The largest of some numbers and which it is, the first of equal ones.
template <class Number, std::size_t n>
std::array<Number, 2> find_largest(const std::array<Number, n>& numbers) {
  Number most = numbers[0], which = 0.0;
  for (std::size_t k = 1; k < n; ++k) {
    const Truth<Number> is_more = numbers[k] > most;
    which = select(is_more, static_cast<double>(k), which);
    most = select(is_more, numbers[k], most);
  }
  return {most, which};
}

template <class Number>
Number clamp(const Number& a, double lowest, double highest) {
  const Number above = select(a < lowest, lowest, a);
  return select(above > highest, highest, above);
}

/// Moves coordinates into a face; returns the number of the edge that they were furthest beyond, -1 if none.
template <class Number>
Number move_inside_quadrilateral(Number& xi, Number& eta) {
  const auto [most, edge] = find_largest<Number, 4>({-1.0 - eta, xi - 1.0, eta - 1.0, -1.0 - xi});
  xi = clamp(xi, -1.0, 1.0);
  eta = clamp(eta, -1.0, 1.0);
  return select(most > 0.0, edge, -1.0);
}

template <class Number>
Number move_inside_triangle(Number& xi, Number& eta) {
  const auto [most, edge] = find_largest<Number, 3>({-eta, xi + eta - 1.0, -xi});
  xi = select(xi < 0.0, 0.0, xi);
  eta = select(eta < 0.0, 0.0, eta);
  // Along the normal of the third edge in these coordinates, then onto its ends.
  const Number sum = xi + eta, on_edge = clamp(Number(xi - 0.5 * (sum - 1.0)), 0.0, 1.0);
  const Truth<Number> is_beyond = sum > 1.0;
  xi = select(is_beyond, on_edge, xi);
  eta = select(is_beyond, 1.0 - on_edge, eta);
  return select(most > 0.0, edge, -1.0);
}

template <class Number>
Number move_inside_face(const Truth<Number>& is_triangle, Number& xi, Number& eta) {
  if (!any(is_triangle)) return move_inside_quadrilateral(xi, eta);
  if (!any(!is_triangle)) return move_inside_triangle(xi, eta);
  Number x = xi, y = eta;
  const Number edge = move_inside_quadrilateral(xi, eta);
  const Number of_triangle = move_inside_triangle(x, y);
  xi = select(is_triangle, x, xi);
  eta = select(is_triangle, y, eta);
  return select(is_triangle, of_triangle, edge);
}

OptionalIndex<std::uint32_t> edge_of(double number) {
  if (number < 0.0) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

/// ClosestPoints by numbers.
template <class Number>
struct Found {
  Truth<Number> exists;
  Number xi, eta;
  Vector<Number> normal;
  Number gap, beyond, edge;

  /// One of them.
  ///   get  of a number, or of the truth, that of this point
  template <class Get>
  std::optional<ClosestPoint> closest_point(const Get& get) const {
    if (!get(exists)) return std::nullopt;
    return ClosestPoint{get(xi),  get(eta),    {get(normal[0]), get(normal[1]), get(normal[2])},
                        get(gap), get(beyond), edge_of(get(edge))};
  }
};

template <class Number>
Found<Number> project_onto(const Vector<std::array<Number, 4>>& x, const Truth<Number>& is_triangle,
                           const Vector<Number>& point) {
  const ComponentMap<Number> map = make_map<Number>(x, is_triangle);
  Number xi = 0.0, eta = 0.0;
  const Truth<Number> exists = find_closest_point(map, point, xi, eta);
  const Vector<Number> closest = map.at(xi, eta), a = map.tangent_xi(eta), b = map.tangent_eta(xi);
  const Vector<Number> area{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const Number square = inner_product(area, area), length = select(square > 0.0, sqrt(square), 1.0);
  const Vector<Number> normal{area[0] / length, area[1] / length, area[2] / length};
  Number xi_inside = xi, eta_inside = eta;
  const Number edge = move_inside_face<Number>(is_triangle, xi_inside, eta_inside);
  const Vector<Number> way = difference(closest, map.at(xi_inside, eta_inside));
  const Number beyond = select(edge < 0.0, 0.0, sqrt(inner_product(way, way)));
  return {exists, xi, eta, normal, inner_product(difference(point, closest), normal), beyond, edge};
}

}  // namespace

OptionalIndex<std::uint32_t> move_inside(bool is_triangle, double& xi, double& eta) {
  return edge_of(move_inside_face(is_triangle, xi, eta));
}

std::optional<ClosestPoint> project_onto_face(const FaceCorners& x, bool is_triangle,
                                              const Eigen::Vector3d& point) {
  Vector<std::array<double, 4>> corners;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index k = 0; k < 4; ++k)
      corners[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = x(i, k);
  }
  const auto found = project_onto<double>(corners, is_triangle, {point[0], point[1], point[2]});
  return found.closest_point([](auto number) { return number; });
}

void ProjectionLanes::add(const FaceCorners& x, bool is_triangle, const Eigen::Vector3d& point) {
  const bool is_first = n_ == 0;
  const auto lane = static_cast<Eigen::Index>(n_++);
  const auto put = [&](double number, Lanes& lanes) {
    if (is_first) {
      lanes.setConstant(number);
    } else {
      lanes(lane) = number;
    }
  };
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    for (Eigen::Index k = 0; k < 4; ++k) put(x(i, k), corners_[axis][static_cast<std::size_t>(k)]);
    put(point[i], points_[axis]);
  }
  const unsigned lanes = is_first ? ~0u : 1u << lane;
  triangles_ = (triangles_ & ~lanes) | (is_triangle ? lanes : 0u);
}

std::array<std::optional<ClosestPoint>, n_lanes> ProjectionLanes::project() const {
  const auto found = project_onto<Lanes>(corners_, LaneMask::of_bits(triangles_), points_);
  std::array<std::optional<ClosestPoint>, n_lanes> closest;
  for (std::size_t lane = 0; lane < n_; ++lane) {
    const auto in_lane = [lane](const auto& numbers) { return numbers(static_cast<Eigen::Index>(lane)); };
    closest[lane] = found.closest_point(in_lane);
  }
  return closest;
}

std::optional<ClosestPoint> project_sphere(const FaceCorners& x, bool is_triangle,
                                           const Eigen::Vector3d& centre, double radius) {
  return project_sphere(x, is_triangle, centre, radius, project_onto_face(x, is_triangle, centre));
}

std::optional<ClosestPoint> project_sphere(const FaceCorners& x, bool is_triangle,
                                           const Eigen::Vector3d& centre, double radius,
                                           const std::optional<ClosestPoint>& flat) {
  if (!flat || radius == 0.0) return flat;
  ClosestPoint found = *flat;
  found.gap -= radius;
  if (!flat->edge) return found;
  if (flat->gap < 0.0) return std::nullopt;
  static constexpr std::array<std::array<double, 2>, 3> triangle{{{0, 0}, {1, 0}, {0, 1}}};
  static constexpr std::array<std::array<double, 2>, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  const std::span<const std::array<double, 2>> corners =
      is_triangle ? std::span<const std::array<double, 2>>(triangle) : square;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = (k + 1) % corners.size();
    const Eigen::Vector3d from = x.col(static_cast<Eigen::Index>(k));
    const Eigen::Vector3d edge = x.col(static_cast<Eigen::Index>(next)) - from;
    const double share = std::clamp(edge.dot(centre - from) / edge.squaredNorm(), 0.0, 1.0);
    const Eigen::Vector3d away = centre - from - share * edge;
    const double distance = away.norm();
    if (!(distance < least) || distance == 0.0) continue;
    least = distance;
    found.xi = corners[k][0] + share * (corners[next][0] - corners[k][0]);
    found.eta = corners[k][1] + share * (corners[next][1] - corners[k][1]);
    found.normal = away / distance;
    found.gap = distance - radius;
  }
  found.beyond = 0.0;
  found.edge = std::nullopt;
  return found;
}

}  // namespace contactsim
