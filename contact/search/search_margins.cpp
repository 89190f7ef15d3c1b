// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/search_margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/state_archive.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// Share of a length that single precision loses at most.
constexpr double rounding = 0x1p-24;

/// The larger of two numbers; what is not a number stays.
double larger(double most, double value) { return value <= most || std::isnan(most) ? most : value; }

}  // namespace

void SearchMargins::set(const ContactMesh& contact_mesh, const Mesh& mesh, double share) {
  of_node_.assign(contact_mesh.n_nodes(), std::numeric_limits<float>::infinity());
  of_face_.clear();
  of_face_.reserve(contact_mesh.faces.size());
  widest_.assign(contact_mesh.n_surfaces(), 0.0);
  narrowest_.assign(contact_mesh.n_surfaces(), std::numeric_limits<double>::infinity());
  const ContactKinematics start = kinematics_of_mesh(contact_mesh, mesh);
  for (const ContactFace& face : contact_mesh.faces) {
    const auto margin = static_cast<float>(share * std::sqrt(start.area(face).norm()));
    of_face_.push_back(margin);
    for (const ContactNodeIndex corner : face.corners) of_node_[corner] = std::min(of_node_[corner], margin);
    widest_[face.surface] = std::max<double>(widest_[face.surface], margin);
  }
  for (const SurfaceNode& node : contact_mesh.surface_nodes)
    of_node_[node.node] = std::min(of_node_[node.node], static_cast<float>(share * std::sqrt(node.area)));
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    const double margin = of_node_[node.node];
    narrowest_[node.surface] = std::min(narrowest_[node.surface], margin);
    widest_[node.surface] = std::max(widest_[node.surface], margin);
  }
}

void SearchMargins::start_at(const ContactMesh& contact_mesh, const ContactKinematics& kinematics) {
  started_at_.resize(contact_mesh.n_nodes());
  if (contact_mesh.n_nodes() > 0) origin_ = kinematics.x({0});
  for (const ContactNodeIndex i : contact_mesh.nodes())
    started_at_[i] = (kinematics.x(i) - origin_).cast<float>();
}

double SearchMargins::used_by(const ContactKinematics& kinematics, ContactNodeIndex node) const {
  const Eigen::Vector3d now = kinematics.x(node) - origin_;
  const double moved = (now - started_at_[node].cast<double>()).norm() + rounding * now.lpNorm<1>();
  return moved / of_node_[node];
}

IndexedVector<SurfaceIndex, double> SearchMargins::used(const ContactMesh& contact_mesh,
                                                        const ContactKinematics& kinematics) const {
  // In pieces: all nodes may be of one surface.
  constexpr std::uint32_t rows_per_piece = 2048;
  struct Piece {
    SurfaceIndex surface;
    std::uint32_t begin, end;
    double most = 0.0;
  };
  std::vector<Piece> pieces;
  const SurfaceIndex past{static_cast<std::uint32_t>(contact_mesh.n_surfaces())};
  for (const SurfaceIndex surface : IndexRange<SurfaceIndex>({}, past)) {
    const auto rows = contact_mesh.rows_of(surface);
    const std::uint32_t end = (*rows.end()).value;
    for (std::uint32_t i = (*rows.begin()).value; i < end; i += rows_per_piece)
      pieces.push_back({surface, i, std::min(i + rows_per_piece, end)});
  }
  parallel_for_uneven(pieces.size(), threads_for(contact_mesh.n_nodes()), [&](std::size_t i) {
    Piece& piece = pieces[i];
    for (std::uint32_t row = piece.begin; row < piece.end; ++row)
      piece.most = larger(piece.most, used_by(kinematics, contact_mesh.surface_nodes[{row}].node));
  });
  IndexedVector<SurfaceIndex, double> used(contact_mesh.n_surfaces(), 0.0);
  for (const Piece& piece : pieces) used[piece.surface] = larger(used[piece.surface], piece.most);
  return used;
}

bool SearchMargins::has_room(SurfaceIndex first, double first_used, SurfaceIndex second,
                             double second_used) const {
  if (first_used <= 1.0) return true;
  return (first_used - 1.0) * widest_[first] <= (1.0 - second_used) * narrowest_[second];
}

double SearchMargins::room(const IndexedVector<SurfaceIndex, double>& used) const {
  constexpr double safe = 0.99;
  double room = std::numeric_limits<double>::infinity();
  for (const SurfaceIndex surface : indices(used)) {
    if (std::isinf(narrowest_[surface])) continue;  // it has no nodes
    room = std::min(room, (1.0 - used[surface]) * narrowest_[surface]);
  }
  return std::max(0.0, safe * room);
}

void SearchMargins::archive(std::uint64_t& n_searches, StateArchive& saved) {
  saved.numbers("contact/search/last", n_searches, origin_);
  saved.list("contact/search/searched_at", started_at_);
}

}  // namespace contactsim
