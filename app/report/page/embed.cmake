# SPDX-License-Identifier: BSD-3-Clause
# Writes the sources of the page into a C++ source.
#   cmake -DSCRIPTS="a.js;b.js" -DFOLDER=<page> -DOUTPUT=<report_page.cpp> -P embed.cmake
file(READ ${FOLDER}/report.html html)
file(READ ${FOLDER}/report.css css)
set(js "")
foreach(script ${SCRIPTS})
  file(READ ${script} text)
  string(APPEND js "${text}\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"app/report/report_page.hpp\"

namespace contactsim {
const std::string_view report_page_html = R\"~page~(${html})~page~\";
const std::string_view report_page_css = R\"~page~(${css})~page~\";
const std::string_view report_page_js = R\"~page~(${js})~page~\";
}  // namespace contactsim
")
