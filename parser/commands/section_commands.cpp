// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/section_commands.hpp"

#include <fmt/format.h>

#include "parser/commands/row_lists.hpp"

namespace contactsim {

namespace {

/// A section while it is bound: the properties of one type beside what all types have.
template <class Properties>
struct SectionOf {
  DeckName name;
  std::optional<DeckName> rigid_body;
  Properties properties;
};

std::vector<Row<SolidSection>> rows_of(const SolidSection&) {
  using S = SolidSection;
  const auto total = choice_of<bool>({"incremental", "total"});
  const auto scaled = choice_of<bool>({"approximate", "scaled"});
  return {
      row("formulation", read::name, &S::formulation, "Element formulation"),
      row("strain incrementation", read::name, &S::strain_incrementation, "How strain increments are formed"),
      row("deviatoric parameter", read::share, &S::deviatoric_parameter,
          "Share of full integration of the deviatoric stress [1]"),
      row("hourglass formulation", total, &S::is_hourglass_total, "How hourglass forces are formed"),
      row("hourglass rotation", scaled, &S::is_hourglass_rotation_scaled,
          "How hourglass forces follow the rotation"),
  };
}

std::vector<Row<TotalLagrangeSection>> rows_of(const TotalLagrangeSection&) {
  using S = TotalLagrangeSection;
  return {
      row("formulation", read::name, &S::formulation, "Element formulation"),
      row("volume average j", read::on_off, &S::has_volume_average_j, "Averages the volume ratio"),
      row("vem exponent", read::real, &S::vem_exponent, "Exponent of the virtual element stabilisation [1]"),
  };
}

std::vector<Row<CohesiveSection>> rows_of(const CohesiveSection&) {
  return {row("number of integration points", read::positive_integer, &CohesiveSection::n_integration_points,
              "Pairs of opposite nodes that carry tractions: all, whatever the number [1]")};
}

/// What shells and membranes share.
template <class S>
std::vector<Row<S>> thickness_rows() {
  return {
      row("thickness", read::positive, &S::thickness, "Thickness, else the mesh's attribute counts [length]"),
      row("thickness scale factor", read::positive, &S::thickness_scale_factor,
          "Factor of the thickness [1]"),
      row("thickness mesh variable", read::name, &S::thickness_mesh_variable,
          "Attribute or variable of the mesh that holds the thickness [length]"),
      row("lofting factor", read::share, &S::lofting_factor,
          "Share of the thickness on the side of the mesh surface's normal [1]"),
      row("formulation", read::name, &S::formulation, "Element formulation"),
  };
}

std::vector<Row<ShellSection>> rows_of(const ShellSection&) {
  using S = ShellSection;
  auto rows = thickness_rows<S>();
  const Row<S> more[] = {
      row("integration rule", read::name, &S::integration_rule, "Integration rule through the thickness"),
      row("number of integration points", read::positive_integer, &S::n_integration_points,
          "Integration points through the thickness [1]"),
      row("drilling stiffness factor", read::non_negative, &S::drilling_stiffness_factor,
          "Factor of the stiffness against drilling rotation [1]"),
      row("orientation", read::name_of(NameKind::coordinate_system), &S::orientation,
          "Coordinate system of the material directions"),
  };
  rows.insert(rows.end(), std::begin(more), std::end(more));
  return rows;
}

std::vector<Row<MembraneSection>> rows_of(const MembraneSection&) {
  auto rows = thickness_rows<MembraneSection>();
  rows.push_back(row("deviatoric parameter", read::share, &MembraneSection::deviatoric_parameter,
                     "Share of full integration of the deviatoric stress [1]"));
  return rows;
}

Row<BeamSection> axis_offset_row() {
  return row<BeamSection>(
             "axis offset", "= <t> <s>",
             [](Arguments& arguments, BeamSection& beam) {
               const double along = arguments.real();
               beam.axis_offset = {along, arguments.real()};
             },
             "Offset of the section's centre from the element [length]", "0 0")
      .once();
}

std::vector<Row<BeamSection>> rows_of(const BeamSection&) {
  using S = BeamSection;
  return {
      row("section", choice_of<BeamShape>({"rod", "tube", "bar", "box", "i"}), &S::shape,
          "Shape of the cross-section"),
      row("width", read::positive, &S::width, "Size along the t axis, diameter of rod and tube [length]"),
      row("height", read::positive, &S::height, "Size across the t axis [length]"),
      row("wall thickness", read::positive, &S::wall_thickness, "Wall of tube, box and I [length]"),
      row("flange thickness", read::positive, &S::flange_thickness, "Flange of an I [length]"),
      row("t axis", read::vector3, &S::t_axis, "Direction of the width [1]"),
      row("reference axis", read::name, &S::reference_axis, "Axis that the offset is measured from"),
      axis_offset_row(),
  };
}

std::vector<Row<TrussSection>> rows_of(const TrussSection&) {
  using S = TrussSection;
  return {
      row("area", read::positive, &S::area, "Cross-section, else the mesh's attribute counts [length^2]"),
      row("initial load", read::real, &S::initial_load, "Axial force at the start [force]"),
      row("period", read::non_negative, &S::period, "Time over which the initial load is brought on [time]"),
  };
}

std::vector<Row<ParticleSection>> rows_of(const ParticleSection&) {
  return {row("radius", read::positive, &ParticleSection::radius,
              "Radius of the particles, else the mesh's attribute counts [length]")};
}

std::vector<Row<PointMassSection>> rows_of(const PointMassSection&) {
  using S = PointMassSection;
  return {
      row("mass", read::non_negative, &S::mass, "Mass of each element [mass]"),
      row("ixx", read::real, &S::ixx, "Moment of inertia about x [mass length^2]"),
      row("iyy", read::real, &S::iyy, "Moment of inertia about y [mass length^2]"),
      row("izz", read::real, &S::izz, "Moment of inertia about z [mass length^2]"),
      row("ixy", read::real, &S::ixy, "Product of inertia xy [mass length^2]"),
      row("iyz", read::real, &S::iyz, "Product of inertia yz [mass length^2]"),
      row("izx", read::real, &S::izx, "Product of inertia zx [mass length^2]"),
  };
}

std::vector<Row<SpringSection>> rows_of(const SpringSection&) {
  using S = SpringSection;
  return {
      row("area", read::positive, &S::area, "Cross-section [length^2]"),
      row("default stiffness", read::positive, &S::default_stiffness, "Stiffness [force/length]"),
      row("force strain function", read::name_of(NameKind::function), &S::force_strain_function,
          "Force over strain"),
      row("mass per unit length", read::non_negative, &S::mass_per_unit_length, "Mass [mass/length]"),
  };
}

std::vector<Row<DamperSection>> rows_of(const DamperSection&) {
  return {row("area", read::positive, &DamperSection::area, "Cross-section [length^2]")};
}

template <class P>
const Table<SectionOf<P>>& table_of() {
  using S = SectionOf<P>;
  static const Table<S> table(joined({lift_all(rows_of(P{}), &S::properties),
                                      {row("rigid body", read::name_of(NameKind::rigid_body), &S::rigid_body,
                                           "Rigid body that the section's blocks belong to")}}));
  return table;
}

using Sections = std::vector<SectionDefinition>;

template <class P>
Row<Sections> section_row(std::string phrase, std::string help) {
  return block<Sections, SectionOf<P>>(
             std::move(phrase), Naming::required, table_of<P>,
             [](Sections& sections, SectionOf<P> part) {
               sections.push_back({part.name, part.rigid_body, part.properties});
             },
             std::move(help))
      .defines(NameKind::section);
}

struct OpaqueSection {
  DeckName name;
};

const Table<OpaqueSection>& opaque_section_table() {
  static const Table<OpaqueSection> table({
      anything<OpaqueSection>(
          "<words>", [](Arguments& arguments, OpaqueSection&) { arguments.rest(); },
          "A line of a section type that contactsim does not know, not read"),
  });
  return table;
}

Row<Sections> unsupported_section_row(const std::string& phrase) {
  return block<Sections, OpaqueSection>(
             phrase, Naming::required, opaque_section_table,
             [phrase](Sections& sections, const OpaqueSection& part) {
               sections.push_back({part.name, {}, UnsupportedSection{phrase}});
             },
             "Not supported: an error when a block uses it")
      .defines(NameKind::section);
}

}  // namespace

std::vector<Row<Sections>> section_rows() {
  return {
      section_row<SolidSection>("solid section", "Solid elements; also the default of a block"),
      section_row<TotalLagrangeSection>("total lagrange section", "Solid elements, total Lagrange"),
      section_row<CohesiveSection>(
          "cohesive section",
          "Cohesive elements: HEX8 and WEDGE6, flat or not, that hold two faces together"),
      section_row<ShellSection>("shell section", "Shell elements"),
      section_row<MembraneSection>("membrane section", "Membrane elements"),
      section_row<BeamSection>("beam section", "Beam elements"),
      section_row<TrussSection>("truss section", "Truss elements"),
      section_row<ParticleSection>("particle section", "Particles"),
      section_row<PointMassSection>("point mass section", "Point masses"),
      section_row<SpringSection>("spring section", "Spring elements"),
      section_row<DamperSection>("damper section", "Damper elements"),
      unsupported_section_row("superelement section"),
      unsupported_section_row("dem section"),
      unsupported_section_row("bolt section"),
      unsupported_section_row("cylindrical joint section"),
      unsupported_section_row("linear beam section"),
      unsupported_section_row("spring support section"),
      unsupported_section_row("usermount section"),
  };
}

}  // namespace contactsim
