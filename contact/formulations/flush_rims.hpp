// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/contact_step_context.hpp"

namespace contactsim {

/// Where bodies lie flush beside each other, a body that slides over them penetrates them a little, and the
/// strip of its side faces below their surface meets the side faces inside the joint. Those contact points
/// are false: the faces on the other side of the rim carry the body. A strip counts as flush when the face
/// beyond the rim touches, faces of the other side are turned towards that one, and the strip is not wider
/// than a hundredth of half the side face and some times what the face beyond penetrated something by in the
/// last step.

/// Whether the overlap of two faces lies in a flush strip of either.
///   contact  overlaps
bool is_at_flush_rim(const ContactStepContext& context, FaceIndex first, FaceIndex second,
                     const FaceFaceContact& contact);

/// The same of a surface node that meets a face: whether the face does not rise above the node's own rim by
/// more than the strip, or the faces of the node not above the face's.
///   normal  of the face at the node's closest point, unit [1]
bool is_at_flush_rim(const ContactStepContext& context, SurfaceNodeIndex row, FaceIndex face,
                     const Eigen::Vector3d& normal);

/// How wide the strip below a face may be for its penetration in the last step [length].
double flush_width(const ContactStepContext& context, FaceIndex face);

}  // namespace contactsim
