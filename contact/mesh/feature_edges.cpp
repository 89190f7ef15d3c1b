// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/feature_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "contact/geometry/common_plane.hpp"
#include "contact/surfaces/surface_options.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// Square of the sine of the angle below which sharp edges do not cross but lie along each other.
constexpr double parallel = 0.03;

/// A direction counts as between two normals when it is this far from both [1]: nearer to one, faces meet.
/// Lines may be that far beyond.
constexpr double well_between = 0.1, just_between = -0.02;

/// Edges that miss each other by this share of their lengths cross all the same.
constexpr double just_beside = 1e-6;

/// What is sharp to beams and trusses, and to other sharp edges, if the deck does not say [degrees].
constexpr double usual_angle = 30.0, usual_feature_angle = 45.0;

/// By which an angle must be passed: whether a right angle cut in two is sharp must not be chance [degrees].
constexpr double round_off = 1e-6;

/// Width of the strip along a sharp edge that touches another one, over the size of its face.
constexpr double strip = 0.25;

/// Of the angle that a surface turns by at its border.
constexpr double cosine_of_border = 0.0;

/// Of the angles that a surface turns by where it is flat for certain, 5 degrees, and at blades.
constexpr double flat_cosine = 0.996;
const double blade_cosine = std::cos(blade_sharpness * std::numbers::pi / 180.0);

/// An edge of a face, whichever way it runs.
struct FaceEdge {
  ContactNodeIndex low, high;
  FaceIndex face;
  auto operator<=>(const FaceEdge&) const = default;
};

std::vector<FaceEdge> list_edges(const IndexedVector<FaceIndex, ContactFace>& faces) {
  std::vector<FaceEdge> edges;
  for (const FaceIndex f : indices(faces)) {
    const std::size_t n = faces[f].is_triangle() ? 3 : 4;
    for (std::size_t k = 0; k < n; ++k) {
      const auto [low, high] = std::minmax(faces[f].corners[k], faces[f].corners[(k + 1) % n]);
      if (low != high) edges.push_back({low, high, f});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// A face at the start: unit normal [1] and the sum of its corners [length].
struct StartFace {
  Eigen::Vector3d normal, sum;
};

StartFace start_of(const ContactKinematics& start, const ContactFace& face) {
  StartFace found{start.area(face).normalized(), Eigen::Vector3d::Zero()};
  for (const ContactNodeIndex corner : face.corners) found.sum += start.x(corner);
  return found;
}

/// The cosine of the angle that two faces turn away from each other by, as seen from inside; 1 if they turn
/// towards each other.
double cosine_of_turn(const StartFace& a, const StartFace& b) {
  if (!((a.sum - b.sum).dot(a.normal - b.normal) > 0.0)) return 1.0;
  return std::clamp(a.normal.dot(b.normal), -1.0, 1.0);
}

ContactEdge make_edge(const ContactKinematics& start, const FaceEdge& one, const FaceEdge& other) {
  const ContactFace &a = start.contact_mesh().faces[one.face], &b = start.contact_mesh().faces[other.face];
  ContactEdge edge;
  edge.nodes = {one.low, one.high};
  edge.faces = {{one.face, other.face}};
  edge.surface = a.surface;
  edge.side = a.side;
  edge.penalty_properties = a.penalty_properties.thickness < b.penalty_properties.thickness
                                ? a.penalty_properties
                                : b.penalty_properties;
  edge.width = strip * std::sqrt(std::min(start.area(a).norm(), start.area(b).norm()));
  return edge;
}

/// The wedge of directions between the normals of a sharp edge's faces: those of which both products with
/// these vectors are positive.
struct Wedge {
  Eigen::Vector3d one, other;

  Wedge(const ContactKinematics& kinematics, const ContactEdge& edge) {
    const auto& faces = kinematics.contact_mesh().faces;
    const Eigen::Vector3d a = kinematics.area(faces[(*edge.faces)[0]]).normalized();
    const Eigen::Vector3d b = kinematics.area(faces[(*edge.faces)[1]]).normalized();
    const double cosine = a.dot(b);
    one = a - cosine * b;
    other = b - cosine * a;
  }
  /// Whether a direction away from the edge is that far inside.
  bool contains(const Eigen::Vector3d& direction, double least) const {
    return direction.dot(one) > least && direction.dot(other) > least;
  }
};

std::optional<EdgeGap> gap_of_sharp(const ContactKinematics& kinematics, const ContactEdge& first,
                                    const ContactEdge& second, const Eigen::Vector3d& apart, bool beside) {
  const Eigen::Vector3d p = kinematics.x(first.nodes[1]) - kinematics.x(first.nodes[0]);
  const Eigen::Vector3d q = kinematics.x(second.nodes[1]) - kinematics.x(second.nodes[0]);
  Eigen::Vector3d normal = p.cross(q);
  const double square = normal.squaredNorm();
  if (!(square > parallel * p.squaredNorm() * q.squaredNorm())) return std::nullopt;
  normal /= std::sqrt(square);
  // At their ends edges do not cross: the way between them is not along the normal.
  if ((apart - apart.dot(normal) * normal).norm() > just_beside * (p.norm() + q.norm())) return std::nullopt;
  const Wedge of_second(kinematics, second);
  std::optional<Wedge> of_first;
  const auto meet = [&](double least) {
    if (!of_second.contains(normal, least)) normal = -normal;
    if (!of_second.contains(normal, least)) return false;
    if (!of_first) of_first.emplace(kinematics, first);
    return of_first->contains(-normal, least);
  };
  const bool is_of_faces = !meet(well_between);
  if (is_of_faces && (!beside || !meet(just_between))) return std::nullopt;
  return EdgeGap{normal, apart.dot(normal), is_of_faces};
}

}  // namespace

void choose_feature_edges(const std::vector<SurfaceOptions>& options, const SurfaceList& surfaces,
                          const ContactKinematics& start, ContactMesh& contact_mesh) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto is_line = [](const ContactEdge& edge) { return !edge.is_particle(); };
  const bool has_lines = std::ranges::any_of(contact_mesh.edges, is_line);
  IndexedVector<SurfaceIndex, double> feature_angle(surfaces.size(), usual_feature_angle);
  IndexedVector<SurfaceIndex, double> line_angle(surfaces.size(), has_lines ? usual_angle : infinite);
  IndexedVector<SurfaceIndex, std::uint8_t> meets(surfaces.size(), 1);
  visit_surface_options(options, surfaces, [&](SurfaceIndex i, const SurfaceOptions& of) {
    if (of.feature_angle) feature_angle[i] = *of.feature_angle;
    if (of.feature_angle && std::isfinite(*of.feature_angle)) line_angle[i] = infinite;
    if (of.has_edge_contact) meets[i] = *of.has_edge_contact ? 1 : 0;
  });
  std::erase_if(contact_mesh.edges, [&](const ContactEdge& edge) { return meets[edge.surface] == 0; });
  IndexedVector<SurfaceIndex, double> angle(surfaces.size(), infinite);
  for (const SurfaceIndex i : indices(angle)) {
    if (meets[i] != 0) angle[i] = std::min(feature_angle[i], line_angle[i]);
  }
  if (std::ranges::all_of(angle, [](double a) { return std::isinf(a); })) return;
  const std::vector<FaceEdge> edges = list_edges(contact_mesh.faces);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const FaceEdge &one = edges[i], &other = edges[i + 1];
    if (std::tie(one.low, one.high) != std::tie(other.low, other.high)) continue;
    const ContactFace &a = contact_mesh.faces[one.face], &b = contact_mesh.faces[other.face];
    const double turn =
        std::acos(cosine_of_turn(start_of(start, a), start_of(start, b))) * 180.0 / std::numbers::pi;
    if (!(turn > angle[a.surface] + round_off)) continue;
    contact_mesh.edges.push_back(make_edge(start, one, other));
    contact_mesh.edges.back().is_feature = turn > feature_angle[a.surface] + round_off;
  }
}

namespace {

/// The mean normal of a surface at a node, of the faces by their angles there [1]. Source: Thuermer and
/// Wuethrich, Journal of Graphics Tools 3 (1998) 43.
Eigen::Vector3d mean_normal(const ContactKinematics& start, const IndexedVector<FaceIndex, StartFace>& faces,
                            ContactNodeIndex node, SurfaceIndex surface) {
  const ContactMesh& contact_mesh = start.contact_mesh();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const FaceIndex i : contact_mesh.faces_of_node.of(node)) {
    const ContactFace& face = contact_mesh.faces[i];
    if (face.surface != surface) continue;
    const std::size_t n = face.is_triangle() ? 3 : 4;
    const auto k = static_cast<std::size_t>(std::ranges::find(face.corners, node) - face.corners.begin());
    const Eigen::Vector3d x = start.x(node), before = start.x(face.corners[(k + n - 1) % n]) - x,
                          behind = start.x(face.corners[(k + 1) % n]) - x;
    sum += std::atan2(before.cross(behind).norm(), before.dot(behind)) * faces[i].normal;
  }
  return sum.normalized();
}

/// The cosine of twice the angle between a face's normal and the mean one at a corner that sticks out; 1 at
/// others.
double cosine_at_spike(const ContactKinematics& start, const IndexedVector<FaceIndex, StartFace>& faces,
                       FaceIndex index, ContactNodeIndex corner) {
  const Eigen::Vector3d mean = mean_normal(start, faces, corner, start.contact_mesh().faces[index].surface);
  const bool sticks_out = mean.dot(0.25 * faces[index].sum - start.x(corner)) < 0.0;
  const double cosine = mean.dot(faces[index].normal);
  if (!sticks_out || !(cosine > 0.0)) return 1.0;
  return 2.0 * cosine * cosine - 1.0;
}

}  // namespace

std::optional<FaceIndex> find_face_beyond(const ContactMesh& contact_mesh, FaceIndex face,
                                          const std::array<ContactNodeIndex, 2>& edge) {
  for (const FaceIndex other : contact_mesh.faces_of_node.of(edge[0])) {
    const ContactFace& candidate = contact_mesh.faces[other];
    if (other == face || candidate.surface != contact_mesh.faces[face].surface) continue;
    if (std::ranges::count(candidate.corners, edge[1]) > 0) return other;
  }
  return std::nullopt;
}

void measure_sharpness(const ContactKinematics& start, ContactMesh& contact_mesh) {
  const auto n_faces = static_cast<std::int64_t>(contact_mesh.faces.size());
  const int n_threads = threads_for(contact_mesh.faces.size());
  IndexedVector<FaceIndex, StartFace> starts(contact_mesh.faces.size());
#pragma omp parallel for schedule(static) num_threads(n_threads)
  for (std::int64_t i = 0; i < n_faces; ++i) {
    const FaceIndex f{static_cast<std::uint32_t>(i)};
    starts[f] = start_of(start, contact_mesh.faces[f]);
  }
#pragma omp parallel for schedule(static) num_threads(n_threads)
  for (std::int64_t i = 0; i < n_faces; ++i) {
    const FaceIndex f{static_cast<std::uint32_t>(i)};
    ContactFace& face = contact_mesh.faces[f];
    const std::size_t n = face.is_triangle() ? 3 : 4;
    double least = 1.0;
    for (std::size_t k = 0; k < n; ++k) {
      const auto beyond = find_face_beyond(contact_mesh, f, {face.corners[k], face.corners[(k + 1) % n]});
      least = std::min(least, beyond ? cosine_of_turn(starts[f], starts[*beyond]) : cosine_of_border);
    }
    // A surface that turns nowhere by more than some degrees has none.
    for (std::size_t k = 0; k < n && least < flat_cosine; ++k) {
      const double at_spike = cosine_at_spike(start, starts, f, face.corners[k]);
      if (at_spike < blade_cosine) least = std::min(least, at_spike);
    }
    face.sharpness = static_cast<float>(std::round(std::acos(least) * 180.0 / std::numbers::pi));
  }
}

double sharpness_of(const ContactKinematics& start, FaceIndex index,
                    const std::function<bool(FaceIndex)>& goes_on) {
  const ContactMesh& contact_mesh = start.contact_mesh();
  const ContactFace& face = contact_mesh.faces[index];
  const std::size_t n = face.is_triangle() ? 3 : 4;
  double least = 1.0;
  for (std::size_t k = 0; k < n; ++k) {
    const auto beyond = find_face_beyond(contact_mesh, index, {face.corners[k], face.corners[(k + 1) % n]});
    if (beyond && goes_on(*beyond)) continue;
    const StartFace own = start_of(start, face);
    least = std::min(
        least, beyond ? cosine_of_turn(own, start_of(start, contact_mesh.faces[*beyond])) : cosine_of_border);
  }
  return std::round(std::acos(least) * 180.0 / std::numbers::pi);
}

Eigen::Vector3d point_at(const ContactKinematics& kinematics, const ContactEdge& edge, double share) {
  return (1.0 - share) * kinematics.x(edge.nodes[0]) + share * kinematics.x(edge.nodes[1]);
}

std::optional<EdgeGap> find_edge_gap(const ContactKinematics& kinematics, const ContactEdge& first,
                                     const ContactEdge& second, const EdgePairPoint& pair_point, double depth,
                                     bool beside) {
  const Eigen::Vector3d apart =
      point_at(kinematics, first, pair_point.s) - point_at(kinematics, second, pair_point.t);
  if (first.is_sharp() && second.is_sharp()) {
    const auto found = gap_of_sharp(kinematics, first, second, apart, beside);
    return found && found->gap > -depth ? found : std::nullopt;
  }
  const double distance = apart.norm();
  if (distance == 0.0) return std::nullopt;
  const EdgeGap found{apart / distance,
                      distance - first.radius_at(pair_point.s) - second.radius_at(pair_point.t)};
  if (first.is_sharp() && !Wedge(kinematics, first).contains(-found.normal, just_between))
    return std::nullopt;
  if (second.is_sharp() && !Wedge(kinematics, second).contains(found.normal, just_between))
    return std::nullopt;
  return found;
}

}  // namespace contactsim
