// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/geometry/face_face.hpp"
#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_mesh.hpp"
#include "contact/surfaces/surface_pairs.hpp"

namespace contactsim {

/// The springs of two sides in series, as elements have them; that of the deformable side alone where the
/// other is rigid, held or driven [force/length^3].
///   second  absent: rigid
double stiffness_of_sides(const PenaltyProperties& first, const PenaltyProperties* second);

/// Stiffness and damping of two sides that meet: the springs of both sides in series, K/t of each the bulk
/// modulus over the thickness of its element, times the pair's scale; or the pair's own stiffness. A rigid,
/// held or driven side has no spring and an infinite mass where the other gives way; two such sides have
/// those of their elements. Damping is the pair's fraction of the critical one of the masses on both sides.
/// Half the thinner element is deep enough to be another wall, if the pair does not say how deep contact
/// reaches. The stiffness that the pair does not give itself grows with the depth, from behind the one that
/// either side had at the start on: what overlaps there is pushed out by a spring.
///   second  absent: rigid
/// Source: element penalty of LS-DYNA and Tribol, 1/(t1/K1 + t2/K2); Hallquist et al. (1985).
PairPenalty make_pair_penalty(const PenaltyProperties& first, const PenaltyProperties* second,
                              const SurfacePair& pair);
/// The same by the law that acts now, which may have a pressure of its own.
PairPenalty make_pair_penalty(const PenaltyProperties& first, const PenaltyProperties* second,
                              const PairRule& rule);

}  // namespace contactsim
