// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "contact/formulations/near_pairs.hpp"
#include "contact/formulations/tied/ties.hpp"

namespace contactsim {

/// Whether a rule ties what is near: TIED MODEL.
inline bool is_tied(const PairRule& rule) { return rule.law == ContactLaw::tied; }

/// Ties the near pairs, such as those of tied pairs.
std::vector<Tie> make_ties(const ContactStepContext& context, const FacePairLists& face_partners,
                           const NodeFaceLists& node_faces, double size_share,
                           const HoldsPair& holds = is_tied);

/// The stiffness per area of the springs between what a tie holds, as both sides have it now
/// [force/length^3].
double tie_stiffness(const ContactStepContext& context, const InterfaceConstraint& tie);

/// Ties two faces as they are now; nothing when they do not overlap.
std::optional<Tie> make_face_tie(const ContactStepContext& context, FaceIndex first, FaceIndex second,
                                 double tolerance);

/// Ties a surface node to a face as they are now; nothing when it does not project inside it.
std::optional<Tie> make_node_tie(const ContactStepContext& context, const NearPair& near_pair);

}  // namespace contactsim
