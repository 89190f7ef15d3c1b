// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "core/base/errors.hpp"
#include "io/exodus/exodus_conventions.hpp"
#include "io/exodus/exodus_draft.hpp"
#include "io/exodus/results_format.hpp"
#include "io/exodus/results_mesh.hpp"
#include "io/exodus/results_sets.hpp"

namespace contactsim {

namespace {

void check_input(const std::string& path, const Mesh& mesh) {
  std::error_code is_missing;
  if (std::filesystem::equivalent(path, mesh.path(), is_missing)) {
    throw FileError(path, "is the mesh of the run; results need a file of their own");
  }
  for (std::uint32_t b = 0; b < mesh.blocks().size(); ++b) {
    const ElementBlock& block = mesh.blocks()[b];
    if (block.n_elements == 0 || block.shape != Shape::unknown) continue;
    throw FileError(path, fmt::format("cannot hold {} of {}: elements of the type '{}' are not known",
                                      mesh.name({EntityKind::block, b}), mesh.path(), block.type_name));
  }
}

void add_globals(const std::string& title, ExodusDraft& draft) {
  constexpr int global = NetcdfOutput::global;
  constexpr double wide_maps = 0x400, wide_ids = 0x800;
  NetcdfOutput& file = draft.file();
  const ExodusFormat& format = draft.format();
  // 8.03 is the first version that knows maximum_name_length and the 64-bit status; assemblies need no
  // number.
  file.set_number(global, "api_version", NetcdfType::float32, 8.03);
  file.set_number(global, "version", NetcdfType::float32, 8.03);
  file.set_number(global, "floating_point_word_size", NetcdfType::int32, 8);
  file.set_number(global, "file_size", NetcdfType::int32, 1);
  file.set_number(global, "maximum_name_length", NetcdfType::int32, static_cast<double>(format.name_length));
  file.set_number(global, "int64_status", NetcdfType::int32, format.has_wide_ids ? wide_maps + wide_ids : 0);
  file.set_text(global, "title", title.substr(0, exodus_title_length));
  draft.add_dimension("len_string", exodus_string_length);
  draft.add_dimension("len_line", exodus_line_length);
  draft.add_dimension("len_name", format.name_length + 1);
  draft.add_dimension("four", 4);
}

std::vector<std::string> split_lines(const std::vector<std::string>& lines) {
  constexpr std::size_t n_characters = exodus_line_length - 1;
  std::vector<std::string> records;
  for (const std::string& line : lines) {
    records.push_back(line.substr(0, n_characters));
    for (std::size_t at = n_characters; at < line.size(); at += n_characters) {
      records.push_back(line.substr(at, n_characters));
    }
  }
  return records;
}

void add_records(const ResultsText& text, ExodusDraft& draft) {
  if (!text.qa_records.empty()) {
    std::vector<std::string> strings;
    for (const QaRecord& record : text.qa_records) {
      strings.insert(strings.end(), {record.code, record.version, record.date, record.time});
    }
    const int n_records = draft.add_dimension("num_qa_rec", text.qa_records.size());
    draft.add_texts("qa_records", {n_records, draft.dimension("four")}, "len_string", std::move(strings));
  }
  std::vector<std::string> info = split_lines(text.info);
  if (info.empty()) return;
  const int n_lines = draft.add_dimension("num_info", info.size());
  draft.add_texts("info_records", {n_lines}, "len_line", std::move(info));
}

ResultsVariables define_results(const Mesh& mesh, const ResultsText& text,
                                std::span<const OutputField> fields, ExodusDraft& draft) {
  add_globals(text.title, draft);
  add_records(text, draft);
  add_mesh(mesh, draft);
  add_sets(mesh, draft);
  add_assemblies(mesh, draft);
  return {mesh, fields, draft};
}

}  // namespace

ResultsWriter::ResultsWriter(const std::string& path, const Mesh& mesh, const ResultsText& text,
                             std::span<const OutputField> fields) {
  check_input(path, mesh);
  const ExodusFormat format = choose_format(find_results_sizes(mesh, fields));
  NetcdfOutput file(path, format.is_large);
  ExodusDraft draft(file, format);
  variables_ = define_results(mesh, text, fields, draft);
  draft.write();
  file.commit();
  records_.emplace(path);
}

ResultsWriter::ResultsWriter(const std::string& path, const MeshPiece& piece, const Mesh& mesh,
                             std::span<const OutputField> fields) {
  const ExodusFormat format = choose_format(find_results_sizes(mesh, fields));
  NetcdfOutput file(format.is_large);
  ExodusDraft draft(file, format);
  variables_ = define_results(mesh, {}, fields, draft);
  variables_->take_piece(piece);
  records_.emplace(path);
}

FileBytes ResultsWriter::measure(const Mesh& mesh, const ResultsText& text,
                                 std::span<const OutputField> fields) {
  check_input("results", mesh);
  const ExodusFormat format = choose_format(find_results_sizes(mesh, fields));
  NetcdfOutput file(format.is_large);
  ExodusDraft draft(file, format);
  define_results(mesh, text, fields, draft);
  return file.measure();
}

void ResultsWriter::write_step(double time, const Values& values) {
  records_->write("time_whole", std::span(&time, 1));
  for (std::size_t i = 0; i < variables_->size(); ++i) variables_->write(i, values(i), *records_);
  records_->end_record();
}

}  // namespace contactsim
