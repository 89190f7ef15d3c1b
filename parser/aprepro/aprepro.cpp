// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/aprepro.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <vector>

#include "core/base/errors.hpp"
#include "core/base/names.hpp"
#include "parser/aprepro/run.hpp"
#include "parser/text/expression_grammar.hpp"

namespace contactsim {

namespace {

/// The value of -D name=value: a number where all of it is one.
ApreproValue value_given(const std::string& text) {
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + sign, end, number);
  const bool is_number = error == std::errc() && stop == end && std::isfinite(number);
  return is_number ? ApreproValue(number) : ApreproValue(text);
}

bool has_braces(const std::string& text) {
  return text.find('{') != std::string::npos || text.find("\\}") != std::string::npos;
}

/// Whether a name stands in some expression, be it in a branch that is not taken.
bool is_name_in_braces(const std::string& text, const std::string& name) {
  const auto is_part_of_name = [&](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
  };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    if ((at > 0 && is_part_of_name(at - 1)) || is_part_of_name(at + name.size())) continue;
    const std::size_t opened = text.rfind('{', at), closed = text.rfind('}', at);
    if (opened != std::string::npos && (closed == std::string::npos || closed < opened)) return true;
  }
  return false;
}

}  // namespace

void ApreproRunner::set_overrides(std::span<const std::string> overrides) {
  for (const std::string& given : overrides) {
    const std::size_t equals = given.find('=');
    const std::string name = given.substr(0, equals);
    if (equals == std::string::npos || !is_aprepro_name(name)) {
      diagnostics_.add_error({}, fmt::format("-D {} is not of the form name=value", given));
    } else {
      state_.variables.override_with(name, value_given(given.substr(equals + 1)));
    }
  }
}

Source ApreproRunner::run(const Source& deck) {
  if (has_braces(deck.text())) {
    open_paths_.push_back(deck.locate(0).file->name);
    run_source(deck, nullptr);
  } else {
    output_ = deck;
  }
  if (lacks_file_) throw DeckError(diagnostics_);
  const std::vector<std::string> names = state_.variables.names();
  for (const std::string& name : state_.variables.unused_overrides()) {
    std::vector<std::string> others;
    std::copy_if(names.begin(), names.end(), std::back_inserter(others),
                 [&](const std::string& other) { return other != name; });
    const std::string text = fmt::format("the deck does not use '{}' of -D", name);
    if (options_.is_lenient || is_name_in_braces(deck.text(), name)) {
      diagnostics_.add_warning("aprepro-unused", {}, text, suggest(name, others));
    } else {
      diagnostics_.add_error({}, text, suggest(name, others));
    }
  }
  return std::move(output_);
}

Source run_aprepro(const Source& deck, const ApreproOptions& options, Diagnostics& diagnostics) {
  ApreproRunner runner(options, diagnostics);
  runner.set_overrides(options.overrides);
  return runner.run(deck);
}

}  // namespace contactsim
