// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/node_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace contactsim {

namespace {

using std::abs;
Lanes abs(const Lanes& a) { return a.abs(); }

template <class Number>
using Truth = decltype(Number() < Number());

template <class Number>
using Vector = LaneVector<Number>;

/// See FaceMap.
template <class Number>
struct MapOf {
  std::array<Vector<Number>, 4> c;

  Vector<Number> at(const Number& xi, const Number& eta) const {
    return c[0] + xi * c[1] + eta * c[2] + (xi * eta) * c[3];
  }
  /// The tangents at a point: derivatives by xi and by eta.
  Vector<Number> tangent_xi(const Number& eta) const { return c[1] + eta * c[3]; }
  Vector<Number> tangent_eta(const Number& xi) const { return c[2] + xi * c[3]; }
};

/// The coordinates at which the vector to the point stands upright on the face; returns whether there are
/// such. Lanes that have converged, or have nothing to converge to, wait for the others.
template <class Number>
Truth<Number> find_closest_point(const MapOf<Number>& map, const Vector<Number>& point, Number& xi,
                                 Number& eta) {
  constexpr int max_iterations = 20;
  constexpr double accuracy =
      1e-8;  // of the coordinates, which are of order one: the next step would be its square
  constexpr double far_away = 10.0;  // such points project inside other faces
  Truth<Number> found(true), goes_on(true);
  for (int i = 0; i < max_iterations && any(goes_on); ++i) {
    const Vector<Number> a = map.tangent_xi(eta), b = map.tangent_eta(xi), away = point - map.at(xi, eta);
    const Number aa = a.dot(a), bb = b.dot(b), ab = a.dot(b) - away.dot(map.c[3]);
    const Number ra = away.dot(a), rb = away.dot(b), det = aa * bb - ab * ab;
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
    return ClosestPoint{get(xi),  get(eta),    {get(normal.x), get(normal.y), get(normal.z)},
                        get(gap), get(beyond), edge_of(get(edge))};
  }
};

template <class Number>
Found<Number> project_onto(const std::array<Vector<Number>, 4>& x, const Truth<Number>& is_triangle,
                           const Vector<Number>& point) {
  const MapOf<Number> map{make_functions(x, is_triangle)};
  Number xi = 0.0, eta = 0.0;
  const Truth<Number> exists = find_closest_point(map, point, xi, eta);
  const Vector<Number> closest = map.at(xi, eta);
  const Vector<Number> normal = normalized(map.tangent_xi(eta).cross(map.tangent_eta(xi)));
  Number xi_inside = xi, eta_inside = eta;
  const Number edge = move_inside_face<Number>(is_triangle, xi_inside, eta_inside);
  const Vector<Number> way = closest - map.at(xi_inside, eta_inside);
  const Number beyond = select(edge < 0.0, 0.0, square_root(way.dot(way)));
  return {exists, xi, eta, normal, (point - closest).dot(normal), beyond, edge};
}

}  // namespace

OptionalIndex<std::uint32_t> move_inside(bool is_triangle, double& xi, double& eta) {
  return edge_of(move_inside_face(is_triangle, xi, eta));
}

std::optional<ClosestPoint> project_onto_face(const FaceCorners& x, bool is_triangle,
                                              const Eigen::Vector3d& point) {
  const auto corner = [&](Eigen::Index k) { return Vector<double>::all(x.col(k)); };
  const auto found = project_onto<double>({corner(0), corner(1), corner(2), corner(3)}, is_triangle,
                                          Vector<double>::all(point));
  return found.closest_point([](auto number) { return number; });
}

void ProjectionLanes::add(const FaceCorners& x, bool is_triangle, const Eigen::Vector3d& point) {
  const bool is_first = n_ == 0;
  const auto lane = static_cast<Eigen::Index>(n_++);
  const auto put = [&](const Eigen::Vector3d& vector, DoubleVectors& lanes) {
    if (is_first) {
      lanes = DoubleVectors::all(vector);
    } else {
      set_lane(lane, vector, lanes);
    }
  };
  for (std::size_t k = 0; k < 4; ++k) put(x.col(static_cast<Eigen::Index>(k)), corners_[k]);
  put(point, points_);
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
