// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "contact/formulations/contact_step_context.hpp"
#include "contact/formulations/tied/ties.hpp"
#include "contact/geometry/node_face.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

/// Whether a rule asks for something to hold its pairs.
using HoldsPair = std::function<bool(const PairRule&)>;

/// Two faces that may be, or a node and a face that are near enough to be held together.
struct NearPair {
  std::uint32_t first = 0;   ///< face, or surface node
  std::uint32_t second = 0;  ///< face
  std::uint32_t pair = 0;
  bool is_node = false;
  double tolerance = 0.0;  ///< of the gap either way [length]
  double share = 1.0;      ///< of nodes as share_of_node() [1]
  bool is_facing = true;   ///< of a node: one of its own faces is turned towards the face
};

/// The candidates of active pairs that something holds, over a gap or an overlap: by the pair's capture
/// tolerance, else its normal tolerance, else a share of the face's size. Of a node the nearest face that it
/// projects inside; faces need not overlap within the tolerance yet. In the order of the candidates.
///   face_partners, node_faces  candidates of a search
///   size_share                 of the square root of a face's area [1]
std::vector<NearPair> find_near_pairs(const ContactStepContext& context, const PairLists& face_partners,
                                      const PairLists& node_faces, double size_share, const HoldsPair& holds);

/// Whether a rule ties what is near: TIED MODEL.
inline bool is_tied(const PairRule& rule) { return rule.law == ContactLaw::tied; }
/// Whether a rule has one model for what is close at the start and another for the rest: HYBRID MODEL.
inline bool is_hybrid(const PairRule& rule) { return rule.model.far != nullptr; }

/// Ties the near pairs, such as those of tied pairs.
std::vector<Tie> make_ties(const ContactStepContext& context, const PairLists& face_partners,
                           const PairLists& node_faces, double size_share, const HoldsPair& holds = is_tied);

/// What ties and bonds of two faces, or of a surface node and a face, have in common.
InterfaceConstraint constraint_of_faces(const ContactStepContext& context, std::uint32_t first,
                                        std::uint32_t second);
InterfaceConstraint constraint_of_node(const ContactStepContext& context, std::uint32_t row,
                                       std::uint32_t face);

/// Where a surface node projects inside a face; nothing when it does not, or the gap is beyond the tolerance.
/// The gap of a sphere counts from its surface.
std::optional<ClosestPoint> find_closest_point(const ContactStepContext& context, std::uint32_t row,
                                               std::uint32_t face, double tolerance);

/// What a surface node counts for where it meets a face [1]. Pairs that go one way meet everything once: 1.
/// In those that go both ways nodes of the face count too, as far as they project inside the node's surface:
/// from 1, when no corner of the face does, down to 1/2, when all do.
///   node_faces  candidates of a search
///   near_pair   of the node; its tolerance holds for the corners' gaps as well
///   weights     of the face's corners at the node's closest point, sum 1 [1]
double share_of_node(const ContactStepContext& context, const PairLists& node_faces,
                     const NearPair& near_pair, const Eigen::Vector4d& weights);

/// Ties two faces as they are now; nothing when they do not overlap.
std::optional<Tie> make_face_tie(const ContactStepContext& context, std::uint32_t first, std::uint32_t second,
                                 double tolerance);

/// Ties a surface node to a face as they are now; nothing when it does not project inside it.
std::optional<Tie> make_node_tie(const ContactStepContext& context, const NearPair& near_pair);

}  // namespace contactsim
