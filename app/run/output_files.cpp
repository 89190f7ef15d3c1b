// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/output_files.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "app/run/file_clashes.hpp"
#include "core/base/version.hpp"
#include "io/exodus/results_writer.hpp"
#include "io/files/format_clock.hpp"

namespace contactsim {

namespace {

ResultsText make_text(const OutputFileSettings& settings, const std::string& title) {
  ResultsText text;
  text.title = title;
  if (!settings.mesh_path.empty()) text.qa_records = read_qa_records(settings.mesh_path);
  const std::time_t now = settings.clock();
  text.qa_records.push_back(
      {"contactsim", version, format_clock(now, "%m/%d/%Y"), format_clock(now, "%H:%M:%S")});
  text.info.push_back(settings.command_line);
  text.info.insert(text.info.end(), settings.deck_lines.begin(), settings.deck_lines.end());
  return text;
}

OutputWriters::OpenResults open_results(const OutputFileSettings& settings, const ResultsFile& file,
                                        const Mesh& mesh, std::span<const OutputField> fields) {
  const ResultsText text = make_text(settings, file.title);
  if (settings.pieces && file.has_mesh) return open_results_piece(*settings.pieces, file, mesh, text, fields);
  refuse_to_replace(file.path, file.overwrites);
  const auto writer = std::make_shared<ResultsWriter>(file.path, mesh, text, fields);
  return {[writer, lock = lock_output(file.path)](double time, const OutputWriters::FieldValues& values) {
    writer->write_step(time, values);
  }};
}

std::vector<std::string> name_results(const OutputFileSettings& settings, const ResultsFile& file) {
  if (!settings.pieces || !file.has_mesh) return {file.path};
  const PieceFiles files = name_results_pieces(*settings.pieces, file);
  std::vector<std::string> paths;
  for (std::size_t piece = 0; piece < files.count; ++piece) paths.push_back(files.path(piece));
  return paths;
}

OutputBytes measure_results(const OutputFileSettings& settings, const ResultsFile& file, const Mesh& mesh,
                            std::span<const OutputField> fields) {
  const FileBytes bytes = ResultsWriter::measure(mesh, make_text(settings, file.title), fields);
  return {bytes.start, bytes.record};
}

/// Counts what a heartbeat has before its first line, and of a line.
OutputBytes measure_heartbeat(const OutputFileSettings& settings, const HeartbeatFile& file,
                              std::vector<std::string> names) {
  HeartbeatStyle style = heartbeat_style(file.form);
  if (file.form.has_units && !style.is_spyhis) style.units = file.dimensions;
  std::uint64_t n_bytes = 0;
  const std::vector<double> values(names.size(), 0.0);
  HeartbeatWriter writer([&](std::string_view text) { n_bytes += text.size(); }, std::move(style),
                         std::move(names), settings.clock);
  writer.write(0.0, values);
  const std::uint64_t n_first = n_bytes;
  writer.write(0.0, values);
  const std::uint64_t n_line = n_bytes - n_first;
  return {n_first - n_line, n_line};
}

OutputWriters::AppendLine open_heartbeat(const OutputFileSettings& settings, const HeartbeatFile& file,
                                         std::vector<std::string> names) {
  HeartbeatStyle style = heartbeat_style(file.form);
  std::error_code ignored;
  const bool continues = file.form.appends && std::filesystem::file_size(file.path, ignored) > 0 && !ignored;
  if (file.form.has_units && !style.is_spyhis && !continues) style.units = file.dimensions;
  if (continues && !style.is_spyhis) style.has_legend = false;
  const bool is_in_log = file.path.empty();
  if (!is_in_log) lock_output(file.path);
  TextSink sink = is_in_log ? settings.log : make_file_sink(file.path, file.form.appends);
  const auto writer =
      std::make_shared<HeartbeatWriter>(std::move(sink), std::move(style), std::move(names), settings.clock);
  return [writer, lock = is_in_log ? nullptr : lock_output(file.path)](
             double time, std::span<const double> values) { writer->write(time, values); };
}

}  // namespace

OutputWriters make_output_writers(OutputFileSettings settings) {
  const auto shared = std::make_shared<const OutputFileSettings>(std::move(settings));
  return {[shared](const ResultsFile& file, const Mesh& mesh, std::span<const OutputField> fields) {
            return open_results(*shared, file, mesh, fields);
          },
          [shared](const HeartbeatFile& file, std::vector<std::string> names) {
            return open_heartbeat(*shared, file, std::move(names));
          },
          [shared](const ResultsFile& file) { return name_results(*shared, file); },
          [shared](const ResultsFile& file, const Mesh& mesh, std::span<const OutputField> fields) {
            return measure_results(*shared, file, mesh, fields);
          },
          [shared](const HeartbeatFile& file, std::vector<std::string> names) {
            return measure_heartbeat(*shared, file, std::move(names));
          }};
}

HeartbeatStyle heartbeat_style(const HeartbeatOutput& form) {
  using Format = HeartbeatOutput::Format;
  HeartbeatStyle style;
  if (form.format == Format::original) style = original_heartbeat_style();
  style.is_spyhis = form.format == Format::spyhis;
  constexpr std::int64_t max_digits = 17;
  if (form.precision) style.n_digits = static_cast<int>(std::min(*form.precision, max_digits));
  // Programs read SPYHIS by its form, which nothing else may change.
  if (style.is_spyhis) return style;
  style.has_labels = form.has_labels.value_or(style.has_labels);
  style.has_legend = form.has_legend.value_or(style.has_legend);
  style.timestamp_format = form.timestamp_format.value_or(style.timestamp_format);
  return style;
}

}  // namespace contactsim
