// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/formulations/contact_step_context.hpp"

namespace contactsim {

/// Where bodies lie flush beside each other, a body that slides over them penetrates them a little, and the
/// strip of its side faces below their surface meets the side faces inside the joint. Those contact points
/// are false: the faces on the other side of the rim carry the body. A strip counts as flush when the face
/// beyond the rim touches, faces of the other side are turned towards that one, and the strip is not wider
/// than a hundredth of half the side face and some times what the face beyond penetrated something by in the
/// last step.

/// What of a side face lies below a rim, where it is flush.
struct FlushStrip {
  Eigen::Vector3d x;    ///< a corner on the rim [length]
  Eigen::Vector3d out;  ///< of the face beyond the rim: unit, out of the element [1]
  double width;         ///< [length]

  bool holds(const Eigen::Vector3d& point) const { return (x - point).dot(out) <= width; }
};

/// The flush strips of two faces, found once for all parts of their overlap. The context must outlive it.
class FlushStrips {
 public:
  FlushStrips(const ContactStepContext& context, FaceIndex first, FaceIndex second)
      : context_(context), first_(first), second_(second) {}

  /// Whether a part of the overlap lies in one of them.
  ///   contact  overlaps
  bool hold(const FaceFaceContact& contact);

 private:
  struct Strip : FlushStrip {
    FaceIndex other;  ///< that lies before it
  };
  void find();

  const ContactStepContext& context_;
  FaceIndex first_, second_;
  bool are_found_ = false;
  std::vector<Strip> strips_;
};

/// Whether a surface node that meets a face is at a flush rim: the face does not rise above the node's own
/// rim by more than the strip, or the faces of the node not above the face's.
///   normal  of the face at the node's closest point, unit [1]
bool is_at_flush_rim(const ContactStepContext& context, SurfaceNodeIndex row, FaceIndex face,
                     const Eigen::Vector3d& normal);

/// How wide the strip below a face may be for its penetration in the last step [length].
double flush_width(const ContactStepContext& context, FaceIndex face);

}  // namespace contactsim
