// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>

#include "contact/geometry/edge_edge.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/surfaces/contact_surface.hpp"
#include "core/definition/contact_options.hpp"

namespace contactsim {

/// Adds the edges between faces that turn away from each other by more than the FEATURE ANGLE of their
/// surface's options, 45 degrees if they say none, and takes away all edges of surfaces with EDGE CONTACT =
/// OFF. Faces of bricks count too: the rims of shells are sharp. Without a number for FEATURE ANGLE edges of
/// more than 30 degrees meet beams and trusses where there are any; with OFF sharp edges meet nothing else.
/// Source: feature edges of Abaqus/Explicit general contact, 36.4.2.
///   start  the faces at the start
void choose_feature_edges(const std::vector<SurfaceOptions>& options, const SurfaceList& surfaces,
                          const ContactKinematics& start, ContactMesh& contact_mesh);

/// Sets the sharpness of faces: the greatest angle by which a face and one which shares an edge with it on
/// the same surface turn away from each other, a right angle at the border of a surface; of faces around the
/// tip of a spike that is more than blade_sharpness twice the angle between their normals and the mean there.
/// Whole degrees, so that round-off does not matter.
///   start  the faces at the start
void measure_sharpness(const ContactKinematics& start, ContactMesh& contact_mesh);

/// The sharpness of one face, but for the edges beyond which its surface continues with a face.
double sharpness_of(const ContactKinematics& start, FaceIndex face,
                    const std::function<bool(FaceIndex)>& goes_on);

/// The face of the same surface that shares an edge with a face, by contact nodes.
std::optional<FaceIndex> find_face_beyond(const ContactMesh& contact_mesh, FaceIndex face,
                                          const std::array<ContactNodeIndex, 2>& edge);

/// How two edges stand to each other at a point.
struct EdgeGap {
  Eigen::Vector3d normal;    ///< unit, from the second edge to the first [1]
  double gap = 0.0;          ///< < 0 when they touch [length]
  bool is_of_faces = false;  ///< sharp edges along the normal of a face, by which the face meets things too
};

/// The point of an edge at a share of its length [length].
Eigen::Vector3d point_at(const ContactKinematics& kinematics, const ContactEdge& edge, double share);

/// The gap between two edges at their nearest points. Round edges meet all around. A sharp edge is met only
/// where neither of its faces is: well between their normals. A line, of which faces
/// meet the nodes only, meets it up to the normals, and so does another sharp edge if that is asked for.
/// Nothing when they do not meet, or are as deep in each other as another wall.
///   depth   of sharp edges at most [length]
///   beside  also sharp edges that are not well between the normals: is_of_faces
std::optional<EdgeGap> find_edge_gap(const ContactKinematics& kinematics, const ContactEdge& first,
                                     const ContactEdge& second, const EdgePairPoint& pair_point, double depth,
                                     bool beside = false);

}  // namespace contactsim
