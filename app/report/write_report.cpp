// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/write_report.hpp"

#include <filesystem>
#include <fstream>
#include <utility>

#include "app/report/report_json.hpp"
#include "app/report/report_page.hpp"
#include "core/base/errors.hpp"
#include "core/base/version.hpp"
#include "io/files/write_text.hpp"

namespace contactsim {

namespace {

constexpr std::size_t bytes_per_run = 5'000'000, spare_bytes = 20'000;

bool is_foreign(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored) || std::filesystem::is_empty(path, ignored))
    return false;
  return std::ifstream(path, std::ios::binary).get() != '<';
}

/// Text for HTML.
std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "&lt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string title_of(const std::vector<ReportRun>& runs) {
  std::string title;
  for (const ReportRun& run : runs) title += (title.empty() ? "" : " and ") + run.name;
  return escaped(title);
}

std::string data_of(const std::vector<ReportRun>& runs, std::size_t n_other_bytes) {
  const std::size_t all = bytes_per_run * runs.size(), used = n_other_bytes + spare_bytes;
  const std::size_t for_each = all > used ? (all - used) / runs.size() : 0;
  std::string text =
      std::string(R"({"schema":"contactsim-report/1","version":")") + version + R"(","runs":[)";
  for (std::size_t i = 0; i < runs.size(); ++i)
    text += (i > 0 ? "," : "") + format_report_json(runs[i], for_each);
  return text + "]}";
}

/// The page with a text in place of each of its marks <!--name-->.
std::string filled(std::string_view page, const std::vector<std::pair<std::string, std::string>>& texts) {
  std::string made;
  while (!page.empty()) {
    const std::size_t mark = page.find("<!--");
    const std::size_t end = page.find("-->", mark);
    made += page.substr(0, mark);
    if (end == std::string_view::npos) break;
    const std::string_view name = page.substr(mark + 4, end - mark - 4);
    for (const auto& [key, text] : texts) {
      if (key == name) made += text;
    }
    page.remove_prefix(end + 3);
  }
  return made;
}

}  // namespace

void check_report_place(const std::string& path) {
  if (is_foreign(path)) throw FileError(path, "the report would overwrite a file that is no HTML");
}

void write_report(const std::string& path, const std::vector<ReportRun>& runs,
                  const PageLibraries& libraries) {
  check_report_place(path);
  const std::string code = libraries.three + "\n" + libraries.orbit_controls + "\n" + libraries.chart;
  const std::size_t n_other =
      code.size() + report_page_html.size() + report_page_css.size() + report_page_js.size();
  write_text(path, filled(report_page_html, {{"title", title_of(runs)},
                                             {"css", std::string(report_page_css)},
                                             {"libraries", code},
                                             {"data", data_of(runs, n_other)},
                                             {"js", std::string(report_page_js)}}));
}

}  // namespace contactsim
