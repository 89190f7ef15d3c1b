// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/manual/command_line.hpp"
#include "app/manual/manual_file.hpp"

namespace contactsim {

/// The pages of the manual that come from rows: reference.html, with a search; variables.html,
/// coming_from.html, command_line.html; and style.css.
std::vector<ManualFile> make_html_manual(const CommandLineText& commands);

/// Each of them alone.
ManualFile make_reference_page();
ManualFile make_variables_page();
ManualFile make_foreign_page();
ManualFile make_command_line_page(const CommandLineText& commands);

}  // namespace contactsim
