// SPDX-License-Identifier: BSD-3-Clause
// The includes and loops of the runner; the rest of it is in run.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "parser/aprepro/expression.hpp"
#include "parser/aprepro/groups.hpp"
#include "parser/aprepro/run.hpp"
#include "parser/text/expression_grammar.hpp"

namespace contactsim {

namespace {

constexpr std::size_t max_include_depth = 32;
constexpr std::size_t max_included_files = 10000;
constexpr double max_loop_passes = 1e6;
constexpr std::size_t cost_of_pass = 200;  ///< in characters

std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\f";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return "";
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/// Whether the first line of an included text would be missed behind a comment mark.
bool has_live_first_line(std::string_view text) {
  const std::string_view first = trim(text.substr(0, text.find('\n')));
  return !first.empty() && std::string_view("#${").find(first[0]) == std::string_view::npos;
}

/// The arguments of a loop, cut at commas outside parentheses.
std::vector<TextRange> split_arguments(std::string_view text, TextRange range) {
  std::vector<TextRange> arguments{{range.begin, range.end}};
  int depth = 0;
  const std::string_view inside = text.substr(0, range.end);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const char c = text[i];
    if (c == '"' || c == '\'') i = skip_aprepro_string(inside, i) - 1;
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c != ',' || depth != 0) continue;
    arguments.back().end = i;
    arguments.push_back({i + 1, range.end});
  }
  return arguments;
}

}  // namespace

void ApreproRunner::run_include(const ApreproNode& node) {
  std::string path;
  try {
    path = included_path(node.range);
  } catch (const ExpressionError& error) {
    report(Severity::error, "", error);
    return;
  }
  const std::size_t at = node.range.begin;
  const int length = static_cast<int>(node.range.end - at);
  std::string problem = find_obstacle(path);
  TextFile file;
  if (problem.empty()) {
    ++n_files_;
    file = state_.read_file(path);
    problem = file.problem;
  }
  const bool may_be_missing = node.kind == ApreproNode::Kind::optional_include;
  if (may_be_missing && file.failure == TextFile::Failure::missing) return;
  if (problem.empty()) {
    include(node, path, std::move(file.text));
  } else {
    lacks_file_ = true;
    report(
        Severity::error, "",
        {at, length, fmt::format("cannot include '{}': {}", path, problem), find_beside(path, file.failure)});
  }
}

/// A hint when a file that was not found stands in the folder of the file that includes it, else "".
std::string ApreproRunner::find_beside(const std::string& path, TextFile::Failure failure) const {
  if (failure != TextFile::Failure::missing) return "";
  const std::string beside = (std::filesystem::path(open_paths_.back()).parent_path() / path).string();
  const bool stands_there = beside != path && state_.read_file(beside).problem.empty();
  return stands_there
             ? fmt::format("paths count from the folder in which contactsim runs, and '{}' is there", beside)
             : "";
}

/// The path meant by the argument of an include: a string, the name of a variable that holds one, an
/// expression that has a string in it, or else the argument as it stands.
std::string ApreproRunner::included_path(TextRange argument) {
  const std::string_view text = trim(text_of(argument));
  if (is_aprepro_name(text)) {
    const ApreproValue* value = state_.variables.find(text);
    const std::string* path = value != nullptr ? std::get_if<std::string>(value) : nullptr;
    return path != nullptr ? *path : std::string(text);
  }
  if (text.find_first_of("\"'") == std::string_view::npos) return std::string(text);
  const ApreproValue value = evaluate(argument);
  if (const std::string* path = std::get_if<std::string>(&value)) return *path;
  throw ExpressionError{argument.begin, 1, "an include takes a file name, found a number"};
}

/// Why the file may not be included, or "".
std::string ApreproRunner::find_obstacle(const std::string& path) const {
  if (path.empty()) return "there is no file name";
  const auto is_same = [wanted = std::filesystem::path(path).lexically_normal()](const std::string& other) {
    return std::filesystem::path(other).lexically_normal() == wanted;
  };
  if (std::any_of(open_paths_.begin(), open_paths_.end(), is_same)) return "the file includes itself";
  if (open_paths_.size() > max_include_depth)
    return fmt::format("includes are nested more than {} deep", max_include_depth);
  return n_files_ >= max_included_files ? "too many files are included" : "";
}

void ApreproRunner::include(const ApreproNode& node, const std::string& path, std::string text) {
  if (node.is_glued && has_live_first_line(text)) {
    report(Severity::warning, "aprepro-hidden",
           {node.at - 1, 1, fmt::format("this comment mark hides the first line of '{}'", path),
            "put a blank between the mark and the brace"});
  }
  const DeckLocation place = locate(node.at);
  const auto trail = trail_to(fmt::format("included from {}:{}", place.file->name, place.line));
  open_paths_.push_back(path);
  run_source(make_source(path, std::move(text), trail), trail);
  open_paths_.pop_back();
  is_echoing_ = true;
  state_.makes_immutable = false;
  const bool runs_on = node.ends_line && !output_.text().empty() && output_.text().back() != '\n';
  if (runs_on) output_.append_made("\n", frame_.source->origin(node.at));
}

std::shared_ptr<const Trail> ApreproRunner::trail_to(std::string text) const {
  return std::make_shared<const Trail>(Trail{std::move(text), frame_.trail});
}

/// {loop(count[, variable[, first value[, step]]])}
void ApreproRunner::run_loop(const ApreproNode& node) {
  try {
    const auto arguments = split_arguments(frame_.source->text(), node.range);
    if (arguments.size() > 4) {
      throw ExpressionError{arguments[4].begin, 1, "a loop takes a count, a name, a first value and a step"};
    }
    const double n = loop_count(arguments[0]);
    std::string variable = fmt::format("__loop_{}", loop_depth_ + 1);
    if (arguments.size() > 1) variable = trim(text_of(arguments[1]));
    if (!is_aprepro_name(variable)) {
      throw ExpressionError{arguments[1].begin, 1,
                            fmt::format("'{}' is not a name for a variable", variable)};
    }
    const double first = arguments.size() > 2 ? evaluate_number(arguments[2]) : 0.0;
    const double step = arguments.size() > 3 ? evaluate_number(arguments[3]) : 1.0;
    run_passes(node, n, variable, first, step);
  } catch (const ExpressionError& error) {
    report(Severity::error, "", error);
  }
}

void ApreproRunner::run_passes(const ApreproNode& node, double n, const std::string& variable, double first,
                               double step) {
  const Frame outer = frame_;
  const std::string place = to_string(locate(node.at));
  ++loop_depth_;
  for (double pass = 0.0; pass < n; pass += 1.0) {
    if (++n_passes_ > max_loop_passes) stop(node.at, "the loops of the deck make more than a million passes");
    const auto assigned = state_.variables.assign(variable, first + pass * step, false);
    if (assigned != ApreproVariables::Assigned::done) {
      fail(node.at, fmt::format("the loop cannot change '{}', which is immutable", variable));
    }
    frame_.trail = std::make_shared<const Trail>(
        Trail{fmt::format("pass {:.0f} of {:.0f} of the loop at {}", pass + 1.0, n, place), outer.trail});
    run_nodes(node.body);
    frame_ = outer;
    state_.work += cost_of_pass;
    check_work(node.at);
  }
  --loop_depth_;
}

/// The number of passes, whole and not negative.
double ApreproRunner::loop_count(TextRange range) {
  using Kind = ExpressionItem::Kind;
  const auto items = parse_expression(text_of(range), ExpressionDialects::aprepro, range.begin);
  const bool is_single = items.size() == 1 && (items[0].kind == Kind::number || items[0].kind == Kind::name);
  const bool is_negative =
      items.size() == 2 && items[0].kind == Kind::number && items[1].kind == Kind::prefix;
  if (!is_single && !is_negative) {
    throw ExpressionError{items[0].offset, 1, "the count of a loop is a number or the name of a variable",
                          "give the expression a name first"};
  }
  return std::max(0.0, std::trunc(evaluate_number(range)));
}

double ApreproRunner::evaluate_number(TextRange range) {
  const ApreproValue value = evaluate(range);
  if (const double* number = std::get_if<double>(&value)) return *number;
  throw ExpressionError{range.begin, 1, "a loop takes numbers, found a string"};
}

}  // namespace contactsim
