// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/enforcement/contact_setup.hpp"
#include "contact/enforcement/interface_constraints.hpp"
#include "contact/formulations/edge_contacts.hpp"
#include "contact/formulations/face_face_contacts.hpp"
#include "contact/formulations/node_areas.hpp"
#include "contact/formulations/node_face_contacts.hpp"
#include "contact/formulations/plane_contacts.hpp"
#include "contact/search/contact_search.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// Contact detection: the broad phase finds candidates when something has moved far enough, the narrow phase
/// of each formulation finds the contact points among them in every step. The same points in the same order
/// for any number of threads.
class ContactDetection {
 public:
  /// All must outlive this.
  ContactDetection(const ContactSetup& setup, const ContactMesh& contact_mesh, const PairRules& rules);

  /// Whether the candidates may no longer be all.
  bool is_due(const ContactKinematics& kinematics) const {
    return has_new_surfaces_ || search_.is_due(kinematics);
  }
  /// The broad phase. Bounds of faces without candidates are not kept up to date until the next one.
  void find_candidates(const Motion& motion, ContactKinematics& kinematics);
  /// Faces of which something has to be known until the next search.
  std::vector<std::uint32_t> faces_with_candidates() const;

  /// Begins a step: what is known of the last one is kept, and gathered anew.
  void begin_step();
  /// The narrow phase: takes all contact points of the pairs that the context enforces, in their order.
  /// Returns those that touch under a GLUED MODEL.
  template <class Take>
  std::vector<ContactPoint> visit_points(const ContactStepContext& context, const Take& take);
  /// Appends the contacts that ended in the last step though they were deep.
  void find_lost(std::vector<LostContact>& lost) const;

  /// Marks the edges of HYBRID pairs that are close to each other.
  void mark_close_edges(const ContactStepContext& context, double size_share, PairRules& rules) const {
    edges_.mark_close(context, size_share, rules);
  }
  /// Pairs of faces, and of nodes with faces, that ties may hold.
  NearCandidates near_candidates() const;
  std::size_t n_candidates() const;
  const ContactSearch& search() const { return search_; }

  /// Goes over to other faces and nodes, which stand where those of the constructor stood already. A search
  /// has to follow.
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  template <class Contacts, class Take>
  void visit_contact_points(Contacts& contacts, const ContactStepContext& context, const Take& take);
  std::span<const ContactPoint> find_node_points(const ContactStepContext& context);

  const ContactSetup& setup_;
  const ContactMesh& contact_mesh_;
  const PairRules& rules_;
  ContactSearch search_;
  FaceFaceContacts face_face_;
  NodeFaceContacts node_face_;
  EdgeContacts edges_;
  PlaneContacts planes_;
  NodeAreas node_areas_;
  bool has_new_surfaces_ = false;                  // a search has to follow
  std::vector<std::vector<ContactPoint>> chunks_;  // scratch of each thread
  std::vector<ContactPoint> node_points_;          // scratch
};

/// Finds contact points chunk by chunk on all threads. They are taken in order while other threads work on
/// later chunks.
template <class Contacts, class Take>
void ContactDetection::visit_contact_points(Contacts& contacts, const ContactStepContext& context,
                                            const Take& take) {
  const std::size_t n_rows = contacts.n_rows();
  const std::size_t n_chunks = (n_rows + rows_per_chunk - 1) / rows_per_chunk;
  const int n_threads = threads_for(n_rows * 10);
  chunks_.resize(std::max(chunks_.size(), static_cast<std::size_t>(n_threads)));
#pragma omp parallel for ordered schedule(dynamic, 1) num_threads(n_threads)
  for (std::size_t i = 0; i < n_chunks; ++i) {
    std::vector<ContactPoint>& points = chunks_[static_cast<std::size_t>(omp_get_thread_num())];
    points.clear();
    contacts.find(context, i * rows_per_chunk, std::min((i + 1) * rows_per_chunk, n_rows), points);
#pragma omp ordered
    for (const ContactPoint& point : points) take(point);
  }
}

template <class Take>
std::vector<ContactPoint> ContactDetection::visit_points(const ContactStepContext& context,
                                                         const Take& take) {
  std::vector<ContactPoint> to_glue;
  const auto take_one = [&](const ContactPoint& point) {
    take(point);
    const bool may_glue = point.is_met() && !point.is_of_edges;
    if (may_glue && rules_.of(point).law == ContactLaw::glued) to_glue.push_back(point);
  };
  visit_contact_points(face_face_, context, [&](const ContactPoint& point) {
    take_one(point);
    face_face_.note(point);
  });
  for (const ContactPoint& point : find_node_points(context)) take_one(point);
  visit_contact_points(edges_, context, [&](const ContactPoint& point) {
    take_one(point);
    edges_.note(point);
  });
  visit_contact_points(planes_, context, take_one);
  return to_glue;
}

}  // namespace contactsim
