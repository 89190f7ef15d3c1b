// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "parser/aprepro/aprepro.hpp"
#include "parser/aprepro/control.hpp"
#include "parser/aprepro/functions.hpp"
#include "parser/text/source.hpp"

namespace contactsim {

/// Carries out what read_aprepro_structure() found in a deck and in the files it includes.
class ApreproRunner {
 public:
  /// Both arguments must outlive the object.
  ApreproRunner(const ApreproOptions& options, Diagnostics& diagnostics);

  /// Sets variables for good, "name=value" each.
  void set_overrides(std::span<const std::string> overrides);

  /// Expands the deck. Throws DeckError when that would take too much time or memory, when too much is wrong,
  /// or when an included file cannot be read: the rest would make no sense.
  Source run(const Source& deck);

 private:
  /// The text that is being read.
  struct Frame {
    const Source* source;
    std::shared_ptr<const Trail> trail;
  };

  void run_source(const Source& source, const std::shared_ptr<const Trail>& trail);
  void run_nodes(const std::vector<ApreproNode>& nodes);
  void run_node(const ApreproNode& node);
  void warn_of_joined_lines(const ApreproNode& node);
  void run_expression(const ApreproNode& node);
  void run_branches(const ApreproNode& node);
  bool holds(const ApreproBranch& branch, const ApreproValue& compared);
  void run_include(const ApreproNode& node);
  std::string included_path(TextRange argument);
  std::string find_obstacle(const std::string& path) const;
  std::string find_beside(const std::string& path, TextFile::Failure failure) const;
  void include(const ApreproNode& node, const std::string& path, std::string text);
  void run_loop(const ApreproNode& node);
  void run_passes(const ApreproNode& node, double n, const std::string& variable, double first, double step);
  double loop_count(TextRange range);

  ApreproValue evaluate(TextRange range);
  double evaluate_number(TextRange range);
  std::string_view text_of(TextRange range) const;
  std::shared_ptr<const Trail> trail_to(std::string text) const;
  DeckLocation locate(std::size_t offset) const;
  void check_work(std::size_t offset);
  [[noreturn]] void stop(std::size_t offset, std::string text);
  void report(Severity severity, std::string_view id, const ExpressionError& problem);
  void fail(std::size_t offset, std::string text, std::string hint = "", int length = 1) {
    report(Severity::error, "", {offset, length, std::move(text), std::move(hint)});
  }

  const ApreproOptions& options_;
  Diagnostics& diagnostics_;
  ApreproState state_;
  Source output_;
  Frame frame_{nullptr, nullptr};
  bool is_echoing_ = true;
  int loop_depth_ = 0;
  double n_passes_ = 0.0;
  bool lacks_file_ = false;  ///< an include failed, so what follows cannot be judged
  std::size_t n_files_ = 0;
  std::vector<std::string> open_paths_;
  std::set<std::tuple<std::string, std::size_t, std::string>> reported_;
};

}  // namespace contactsim
