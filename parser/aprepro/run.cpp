// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/run.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/base/errors.hpp"
#include "parser/aprepro/expression.hpp"
#include "parser/aprepro/operators.hpp"
#include "parser/text/expression_grammar.hpp"

namespace contactsim {

namespace {

using Kind = ApreproNode::Kind;
using Test = ApreproBranch::Test;

constexpr std::size_t max_output = std::size_t{64} << 20;
constexpr std::size_t max_reports = 200;

}  // namespace

ApreproRunner::ApreproRunner(const ApreproOptions& options, Diagnostics& diagnostics)
    : options_(options), diagnostics_(diagnostics) {
  state_.read_file = options.read_file;
  state_.max_work = options.max_work;
  state_.warn = [this](std::string_view id, const ExpressionError& problem) {
    report(Severity::warning, id, problem);
  };
}

void ApreproRunner::run_source(const Source& source, const std::shared_ptr<const Trail>& trail) {
  const Frame outer = std::exchange(frame_, {&source, trail});
  run_nodes(read_aprepro_structure(source, diagnostics_));
  frame_ = outer;
}

void ApreproRunner::run_nodes(const std::vector<ApreproNode>& nodes) {
  for (const ApreproNode& node : nodes) run_node(node);
}

void ApreproRunner::run_node(const ApreproNode& node) {
  switch (node.kind) {
    case Kind::text:
      state_.work += node.range.end - node.range.begin;
      if (is_echoing_) output_.append_part(*frame_.source, node.range.begin, node.range.end, frame_.trail);
      break;
    case Kind::expression:
    case Kind::silent:
    case Kind::unclosed:
      run_expression(node);
      break;
    case Kind::conditional:
    case Kind::choice:
      run_branches(node);
      break;
    case Kind::loop:
      run_loop(node);
      break;
    case Kind::include:
    case Kind::optional_include:
      run_include(node);
      break;
    case Kind::echo_on:
    case Kind::echo_off:
      is_echoing_ = node.kind == Kind::echo_on;
      break;
    case Kind::immutable_on:
    case Kind::immutable_off:
      state_.makes_immutable = node.kind == Kind::immutable_on;
      break;
    case Kind::glued_mark:
    case Kind::joined_text:
      warn_of_joined_lines(node);
      break;
  }
  check_work(node.at);
}

void ApreproRunner::warn_of_joined_lines(const ApreproNode& node) {
  if (node.kind == Kind::glued_mark) {
    report(Severity::warning, "aprepro-hidden",
           {node.at, 1, "this comment mark comes to stand before the next line and hides it",
            "put a blank between the mark and the brace"});
  } else {
    report(Severity::warning, "aprepro-joined",
           {node.at, 1,
            fmt::format("this text is joined to the next line, as the line end behind {} is dropped",
                        text_of(node.range)),
            "put it on a line of its own"});
  }
}

void ApreproRunner::run_expression(const ApreproNode& node) {
  // A wrong expression has been reported; the number that takes its place should not make further errors.
  std::string printed = "1";
  if (node.kind == Kind::unclosed) {
    fail(node.at, "nothing closes this brace", "write \\{ for a brace that is none of Aprepro's");
  } else if (text_of(node.range).find_first_not_of(" \t\r\n") == std::string_view::npos) {
    printed.clear();
  } else {
    try {
      const ApreproValue value = evaluate(node.range);
      const double* number = std::get_if<double>(&value);
      printed = number != nullptr ? state_.variables.print(*number) : std::get<std::string>(value);
    } catch (const ExpressionError& error) {
      report(Severity::error, "", error);
    }
  }
  state_.work += printed.size() + 1;
  if (!is_echoing_ || node.kind == Kind::silent) return;
  Origin origin = frame_.source->origin(node.at);
  origin.trail = frame_.trail ? frame_.trail : origin.trail;
  output_.append_made(printed, origin);
}

void ApreproRunner::run_branches(const ApreproNode& node) {
  ApreproValue compared = 0.0;
  try {
    if (node.kind == Kind::choice) compared = evaluate(node.range);
  } catch (const ExpressionError& error) {
    report(Severity::error, "", error);
    return;
  }
  for (const ApreproBranch& branch : node.branches) {
    if (!holds(branch, compared)) continue;
    run_nodes(branch.body);
    return;
  }
}

bool ApreproRunner::holds(const ApreproBranch& branch, const ApreproValue& compared) {
  if (branch.test == Test::otherwise) return true;
  try {
    const std::string_view condition = text_of(branch.condition);
    if (branch.test == Test::is_true) return is_true(evaluate(branch.condition));
    if (branch.test == Test::equals) return evaluate(branch.condition) == compared;
    const bool is_undefined_name = is_aprepro_name(condition) && state_.variables.find(condition) == nullptr;
    const bool is_set = !is_undefined_name && is_true(evaluate(branch.condition));
    return is_set == (branch.test == Test::is_defined);
  } catch (const ExpressionError& error) {
    report(Severity::error, "", error);
    return false;
  }
}

ApreproValue ApreproRunner::evaluate(TextRange range) {
  return evaluate_aprepro(text_of(range), range.begin, state_);
}

std::string_view ApreproRunner::text_of(TextRange range) const {
  return std::string_view(frame_.source->text()).substr(range.begin, range.end - range.begin);
}

DeckLocation ApreproRunner::locate(std::size_t offset) const {
  DeckLocation location = frame_.source->locate(offset);
  if (frame_.trail) location.trail = frame_.trail;
  return location;
}

void ApreproRunner::report(Severity severity, std::string_view id, const ExpressionError& problem) {
  const bool is_undefined = id == "aprepro-undefined";
  if (is_undefined && lacks_file_) return;
  const DeckLocation location = locate(problem.offset);
  const std::string file = location.is_known() ? location.file->name : "";
  if (!reported_.emplace(file, problem.offset, problem.text).second) return;
  if (reported_.size() > max_reports) {
    stop(problem.offset, "too many problems with Aprepro; the deck is not expanded further");
  }
  Diagnostic diagnostic{severity, std::string(id), location, problem.length, problem.text, problem.hint};
  if (is_undefined && !options_.is_lenient) {
    diagnostic.severity = Severity::error;
    diagnostic.id.clear();
  } else if (is_undefined) {
    diagnostic.text += ", 0 is taken";
  }
  diagnostics_.add(std::move(diagnostic));
}

void ApreproRunner::check_work(std::size_t offset) {
  const bool is_too_much = state_.work > state_.max_work || output_.text().size() > max_output;
  if (is_too_much) stop(offset, "the deck expands without end, or to too much");
}

void ApreproRunner::stop(std::size_t offset, std::string text) {
  diagnostics_.add_error(locate(offset), std::move(text));
  throw DeckError(diagnostics_);
}

}  // namespace contactsim
