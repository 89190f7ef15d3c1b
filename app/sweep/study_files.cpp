// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/study_files.hpp"
#include "core/base/csv_field.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace contactsim {

namespace {

template <class T>
std::string known(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : "";
}

/// A column of numbers and its name.
struct NumberColumn {
  const char* name;
  std::optional<double> RunRecord::*member;
};

constexpr std::array number_columns{
    NumberColumn{"time", &RunRecord::time},
    NumberColumn{"kinetic_energy", &RunRecord::kinetic},
    NumberColumn{"internal_energy", &RunRecord::internal},
    NumberColumn{"external_energy", &RunRecord::external},
    NumberColumn{"contact_energy", &RunRecord::contact},
    NumberColumn{"friction_energy", &RunRecord::friction},
    NumberColumn{"energy_error", &RunRecord::energy_error},
    NumberColumn{"energy_error_share", &RunRecord::energy_error_share},
    NumberColumn{"peak_force", &RunRecord::peak_force},
    NumberColumn{"deepest_penetration", &RunRecord::deepest},
    NumberColumn{"deepest_share", &RunRecord::deepest_share},
};

std::string header(const SweepPoint& point) {
  std::string text = "run,folder";
  for (const auto& [name, value] : point) text += "," + csv_field(name);
  text += ",state,exit_code,wall_time,steps";
  for (const NumberColumn& column : number_columns) text += fmt::format(",{}", column.name);
  return text + ",warnings,errors,error\n";
}

std::string record_fields(const RunRecord& record) {
  std::string text = fmt::format(",{},{},{},{}", record.state, known(record.exit_code),
                                 known(record.wall_time), known(record.n_steps));
  for (const NumberColumn& column : number_columns) text += "," + known(record.*column.member);
  return text + fmt::format(",{},{},{}", record.n_warnings, record.n_errors, csv_field(record.first_error));
}

/// Text for XML. What XML cannot hold becomes a question mark.
std::string xml_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '>') {
      escaped += "&gt;";
    } else if (c == '"') {
      escaped += "&quot;";
    } else {
      escaped += byte < 0x20 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return escaped;
}

bool is_done(const RunRecord& record) { return record.state == "done"; }

std::string test_case(const std::string& name, const SweepRun& run, const std::optional<RunRecord>& record) {
  std::string text = fmt::format("  <testcase classname=\"{}\" name=\"{}\"", xml_text(name),
                                 xml_text(describe_point(run.point)));
  if (!record) return text + "><skipped/></testcase>\n";
  text += fmt::format(" time=\"{:.3f}\"", record->wall_time.value_or(0.0));
  if (is_done(*record)) return text + "/>\n";
  const std::string how =
      record->exit_code ? fmt::format("{}, exit code {}", record->state, *record->exit_code) : "did not end";
  return text + fmt::format(">\n    <failure message=\"{}\">{}</failure>\n  </testcase>\n", xml_text(how),
                            xml_text(record->first_error));
}

}  // namespace

std::string format_study_csv(const std::vector<SweepRun>& runs,
                             const std::vector<std::optional<RunRecord>>& records) {
  std::string text = header(runs.empty() ? SweepPoint{} : runs[0].point);
  RunRecord none;
  none.state = "not run";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    text += fmt::format("{},{}", runs[i].number, csv_field(runs[i].folder));
    for (const auto& [name, value] : runs[i].point) text += "," + csv_field(value);
    text += record_fields(records[i] ? *records[i] : none) + "\n";
  }
  return text;
}

std::string format_study_xml(const std::string& name, const std::vector<SweepRun>& runs,
                             const std::vector<std::optional<RunRecord>>& records) {
  std::size_t n_failed = 0, n_skipped = 0;
  double seconds = 0.0;
  std::string cases;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    cases += test_case(name, runs[i], records[i]);
    if (!records[i]) ++n_skipped;
    if (records[i] && !is_done(*records[i])) ++n_failed;
    if (records[i]) seconds += records[i]->wall_time.value_or(0.0);
  }
  return fmt::format(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" "
             "time=\"{:.3f}\">\n",
             xml_text(name), runs.size(), n_failed, n_skipped, seconds) +
         cases + "</testsuite>\n";
}

}  // namespace contactsim
