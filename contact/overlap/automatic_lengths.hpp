// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "contact/mesh/contact_model.hpp"
#include "core/definition/contact_options.hpp"

namespace contactsim {

/// The smallest and the largest of some lengths [length].
struct LengthRange {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;

  bool exists() const { return least <= most; }
  void add(double length) {
    least = std::min(least, length);
    most = std::max(most, length);
  }
  void add(const LengthRange& other) {
    least = std::min(least, other.least);
    most = std::max(most, other.most);
  }
};

/// What lines that are left out, or AUTO, come to on the faces and nodes of a pair.
struct AutomaticLengths {
  LengthRange normal;          ///< NORMAL TOLERANCE: the margin of the search
  LengthRange tangential;      ///< TANGENTIAL TOLERANCE of NODE_FACE
  LengthRange overlap_normal;  ///< OVERLAP NORMAL TOLERANCE: half the thickness behind the faces
  LengthRange capture;         ///< CAPTURE TOLERANCE
  LengthRange edge;            ///< mean edge: of SEARCH DISTANCE and GAP CLOSURE TOLERANCE

  void add(const AutomaticLengths& other);
};

/// The automatic lengths of each pair, on the mesh as it is.
IndexedVector<PairIndex, AutomaticLengths> find_automatic_lengths(const ContactModel& model, const Mesh& mesh,
                                                                  const DashOptions& dash);

}  // namespace contactsim
