// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/near_pairs.hpp"

namespace contactsim {

/// What of a surface node's area a law in tractions acts on where the node meets a face [1], such that nodes
/// of both sides act on all that lies over each other, and once. Pairs that go one way meet everything
/// once: 1.
///
/// Of two surfaces that go both ways one leads, by its position, of one with itself by the faces' positions.
/// A node around which some node does not meet the other side is at the rim of the interface. A node of the
/// leading surface that projects inside a face with weights w_k leaves to that face's corners half of
///     c = sum of w_k over the corners k that project inside the node's surface and are not at the rim,
/// or all of it where it is at the rim itself, for there the other side's nodes know better what is covered.
/// A node of the other surface takes 1 - sum of w_k s_k / sum of w_k over the leading corners that project
/// inside its surface, of shares s_k: so the shares of both sides add up to 1 everywhere. Their product with
/// covered_share() is what counts.
///   node_faces  candidates of a search
///   near_pair   of the node; its tolerance holds for the corners' gaps as well
///   weights     of the face's corners at the node's closest point, sum 1 [1]
double node_share(const ContactStepContext& context, const NodeFaceLists& node_faces,
                  const NearPair& near_pair, const Eigen::Vector4d& weights);

}  // namespace contactsim
