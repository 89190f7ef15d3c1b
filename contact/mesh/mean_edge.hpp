// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_kinematics.hpp"
#include "contact/surfaces/surface_pairs.hpp"

namespace contactsim {

/// Mean length of the edges of the faces that a pair's nodes meet: those of SIDE A, of both sides without
/// one, of the other side where that has no faces; without any of the rods of both, and the diameters of
/// particles; 0 when there are none either [length].
///   start  the faces before the first step
double mean_edge(const ContactKinematics& start, const SurfacePair& pair);

/// A pair's SEARCH DISTANCE, AUTO resolved. Precondition: it has one. Source: SRCHDIS of OptiStruct's
/// CONTACT, twice the mean edge of the main surface.
double find_search_distance(const ContactKinematics& start, const SurfacePair& pair);

}  // namespace contactsim
