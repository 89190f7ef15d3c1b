// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "contact/output/contact_output.hpp"

namespace contactsim {

namespace {

using MemberName = std::string_view;

constexpr std::array<MemberName, 2> cstress_members{"contact_normal_traction_magnitude",
                                                    "contact_tangential_traction_magnitude"};
constexpr std::array<MemberName, 2> cforce_members{"contact_normal_force", "contact_tangential_force"};
constexpr std::array<MemberName, 3> cdisp_members{"contact_normal_gap", "contact_accumulated_slip",
                                                  "contact_accumulated_slip_vector"};
constexpr std::array<MemberName, 2> cslipr_members{"contact_slip_rate", "contact_slip_rate_components"};
constexpr std::array<MemberName, 1> ctandir_members{"contact_tangential_direction"};

constexpr auto of_nodes = FieldLocation::node;
constexpr std::array group_rows{
    OutputGroup{"cstress", of_nodes, cstress_members, "Pressure and shear of contact [force/length^2]"},
    OutputGroup{"cforce", of_nodes, cforce_members, "Normal and friction force of contact [force]"},
    OutputGroup{"cdisp", of_nodes, cdisp_members, "Gap and slips of contact [length]"},
    OutputGroup{"cslipr", of_nodes, cslipr_members, "Rate of slip and its components [length/time]"},
    OutputGroup{"ctandir", of_nodes, ctandir_members, "Direction of friction [1]"},
};

constexpr std::array foreign_names{
    ForeignVariable{"contact_pressure", "contact_normal_traction_magnitude"},
    ForeignVariable{"contact_gap", "contact_normal_gap"},
    ForeignVariable{"contact_slip", "contact_accumulated_slip"},
    ForeignVariable{"cpress", "contact_normal_traction_magnitude"},
    ForeignVariable{"cshear", "contact_tangential_traction_magnitude"},
    ForeignVariable{"cshear1", "contact_tangential_traction_magnitude"},
    ForeignVariable{"cshear2", "contact_tangential_traction_magnitude"},
    ForeignVariable{"cshearmag", "contact_tangential_traction_magnitude"},
    ForeignVariable{"cnormf", "contact_normal_force"},
    ForeignVariable{"cshearf", "contact_tangential_force"},
    ForeignVariable{"copen", "contact_normal_gap"},
    ForeignVariable{"cslipeq", "contact_accumulated_slip"},
    ForeignVariable{"cslip", "contact_accumulated_slip_vector"},
    ForeignVariable{"cslip1", "contact_accumulated_slip_vector"},
    ForeignVariable{"cslip2", "contact_accumulated_slip_vector"},
    ForeignVariable{"csliprmag", "contact_slip_rate"},
    ForeignVariable{"cslipr1", "contact_slip_rate_components(1)"},
    ForeignVariable{"cslipr2", "contact_slip_rate_components(2)"},
    ForeignVariable{"ctandir1", "contact_tangential_direction"},
    ForeignVariable{"ctandir2", "contact_tangential_direction"},
    ForeignVariable{"cstatus", "contact_slip_status"},
    ForeignVariable{"cfn", "contact_normal_force_<surface>"},
    ForeignVariable{"cfs", "contact_friction_force_<surface>"},
    ForeignVariable{"cft", "contact_force_<surface>"},
    ForeignVariable{"cmn", "contact_normal_moment_<surface>"},
    ForeignVariable{"cms", "contact_friction_moment_<surface>"},
    ForeignVariable{"cmt", "contact_moment_<surface>"},
    ForeignVariable{"xn", "contact_normal_line_point_<surface>"},
    ForeignVariable{"xs", "contact_friction_line_point_<surface>"},
    ForeignVariable{"xt", "contact_line_point_<surface>"},
    ForeignVariable{"carea", "contact_area_<surface>"},
    ForeignVariable{"cdis", "contact_normal_gap, and the slips of the group CDISP"},
    ForeignVariable{"cstr", "the group CSTRESS"},
    ForeignVariable{"pcon", "contact_normal_traction_magnitude"},
};

}  // namespace

OutputNames contact_output_names() { return {group_rows, foreign_names}; }

}  // namespace contactsim
