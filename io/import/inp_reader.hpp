// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/import/draft_mesh.hpp"

namespace contactsim {

/// Reads the mesh of an Abaqus or CalculiX input file: *NODE, *ELEMENT, *ELSET, *NSET, *SURFACE of element
/// faces, one part at most. Groups are the ELSETs that sections name, else those of the *ELEMENT lines. Other
/// keywords are passed over. Throws FileError with the line. Source: Abaqus keywords reference; faces by the
/// Abaqus analysis guide, 28.1.4 (solid elements).
DraftMesh read_inp(const std::string& path);

}  // namespace contactsim
