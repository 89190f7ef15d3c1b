// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace contactsim {

/// The sources of the page, app/report/page, which CMake puts into the program.
extern const std::string_view report_page_html, report_page_css, report_page_js;

}  // namespace contactsim
