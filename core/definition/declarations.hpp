// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The blocks of a deck by name, for headers that pass them on: a changed field then rebuilds what reads it.
namespace contactsim {

struct BlockParameters;
struct ContactDefinition;
struct FiniteElementModel;
struct FrictionLaw;
struct FunctionDefinition;
struct MaterialDefinition;
struct OutputScheduler;
struct Procedure;
struct Region;
struct RigidBodyDefinition;
struct SectionDefinition;
struct SimulationDefinition;
struct TimeSteppingBlock;

}  // namespace contactsim
