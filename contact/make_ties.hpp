// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "contact/contact_scene.hpp"
#include "contact/node_face.hpp"
#include "contact/pair_lists.hpp"
#include "contact/ties.hpp"

namespace contactsim {

/// Whether a rule asks for something to hold its places.
using HoldsPlace = std::function<bool(const PairRule&)>;

/// Two faces that may be, or a node and a face that are near enough to be held together.
struct NearPlace {
  std::uint32_t first = 0;   ///< face, or surface node
  std::uint32_t second = 0;  ///< face
  std::uint32_t pair = 0;
  bool is_node = false;
  double tolerance = 0.0;  ///< of the gap either way [length]
  double share = 1.0;      ///< of nodes as share_of_node() [1]
};

/// The candidates of active pairs that something holds, over a gap or an overlap: by the pair's capture
/// tolerance, else its normal tolerance, else a share of the face's size. Of a node the nearest face that it
/// stands over; faces need not overlap within the tolerance yet. In the order of the candidates.
///   face_partners, node_faces  candidates of a search
///   size_share                 of the square root of a face's area [1]
std::vector<NearPlace> find_near_places(const ContactScene& scene, const PairLists& face_partners,
                                        const PairLists& node_faces, double size_share,
                                        const HoldsPlace& holds);

/// Whether a rule ties what is near: TIED MODEL.
inline bool is_tied(const PairRule& rule) { return rule.law == ContactLaw::tied; }

/// Ties the near places, such as those of tied pairs.
std::vector<Tie> make_ties(const ContactScene& scene, const PairLists& face_partners,
                           const PairLists& node_faces, double size_share, const HoldsPlace& holds = is_tied);

/// What ties and bonds of two faces, or of a surface node and a face, have in common.
HeldPlace place_of_faces(const ContactScene& scene, std::uint32_t first, std::uint32_t second);
HeldPlace place_of_node(const ContactScene& scene, std::uint32_t row, std::uint32_t face);

/// Where a surface node stands over a face; nothing when it does not, or the gap is beyond the tolerance. The
/// gap of a ball counts from its surface.
std::optional<FacePoint> find_foot(const ContactScene& scene, std::uint32_t row, std::uint32_t face,
                                   double tolerance);

/// What a surface node counts for where it meets a face [1]. Pairs that go one way meet everything once: 1.
/// In those that go both ways nodes of the face count too, as far as they stand over the node's surface: from
/// 1, when no corner of the face does, down to 1/2, when all do.
///   node_faces  candidates of a search
///   place       of the node; its tolerance holds for the corners' gaps as well
///   weights     of the face's corners at the node's foot, sum 1 [1]
double share_of_node(const ContactScene& scene, const PairLists& node_faces, const NearPlace& place,
                     const Eigen::Vector4d& weights);

/// Ties two faces as they are now; nothing when they do not overlap.
std::optional<Tie> make_face_tie(const ContactScene& scene, std::uint32_t first, std::uint32_t second,
                                 double tolerance);

/// Ties a surface node to a face as they are now; nothing when it does not stand over it.
std::optional<Tie> make_node_tie(const ContactScene& scene, const NearPlace& place);

}  // namespace contactsim
