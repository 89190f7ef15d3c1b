// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/contact_scene.hpp"
#include "contact/pair_lists.hpp"
#include "contact/ties.hpp"

namespace contactsim {

/// Ties the faces and nodes of tied pairs that are near each other, over a gap or an overlap: by the pair's
/// capture tolerance, else its normal tolerance, else a share of the face's size. A node is tied to the
/// nearest face that it stands over. In the order of the candidates.
///   face_partners, node_faces  candidates of a search
///   size_share                 of the square root of a face's area [1]
std::vector<Tie> make_ties(const ContactScene& scene, const PairLists& face_partners,
                           const PairLists& node_faces, double size_share);

/// Ties two faces as they are now; nothing when they do not overlap.
std::optional<Tie> make_face_tie(const ContactScene& scene, std::uint32_t first, std::uint32_t second,
                                 double tolerance);

/// Ties a surface node to a face as they are now; nothing when it does not stand over it.
std::optional<Tie> make_node_tie(const ContactScene& scene, std::uint32_t row, std::uint32_t face,
                                 double tolerance);

}  // namespace contactsim
