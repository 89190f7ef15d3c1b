// SPDX-License-Identifier: BSD-3-Clause
#include "io/heartbeat/heartbeat_writer.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>

#include "core/base/errors.hpp"
#include "core/base/file_paths.hpp"
#include "io/files/format_clock.hpp"

namespace contactsim {

HeartbeatStyle original_heartbeat_style() {
  HeartbeatStyle style;
  style.has_labels = true;
  style.has_legend = false;
  style.has_time = false;
  style.separator = "\t";
  style.timestamp_format = "[%H:%M:%S]";
  return style;
}

TextSink make_file_sink(const std::string& path, bool appends) {
  refuse_link_out_of_folder(path);
  const auto mode = appends ? std::ios::app : std::ios::trunc;
  const auto file = std::make_shared<std::ofstream>(path, std::ios::out | std::ios::binary | mode);
  const auto fail = [path] {
    throw FileError(path, "cannot be written (" + std::generic_category().message(errno) + ")");
  };
  if (!*file) fail();
  return [file, fail](std::string_view text) {
    *file << text << std::flush;
    if (!*file) fail();
  };
}

HeartbeatWriter::HeartbeatWriter(TextSink sink, HeartbeatStyle style, std::vector<std::string> names,
                                 std::function<std::time_t()> clock)
    : sink_(std::move(sink)), style_(std::move(style)), names_(std::move(names)), clock_(std::move(clock)) {}

std::string HeartbeatWriter::timestamp() const {
  if (style_.timestamp_format.empty()) return "";
  return fmt::format("+{} ", format_clock(clock_(), style_.timestamp_format));
}

void HeartbeatWriter::write_legend() {
  std::vector<std::string> titles = names_;
  if (style_.has_time) titles.insert(titles.begin(), style_.is_spyhis ? "TIME" : "Time");
  const std::string legend = timestamp() + fmt::format("{}\n", fmt::join(titles, style_.separator));
  if (style_.is_spyhis) {
    sink_("% Sierra SPYHIS Output " + format_clock(clock_(), "%a %b %e %H:%M:%S %Y\n"));
    // Its readers expect the names twice.
    sink_(legend);
  }
  sink_(legend);
}

void HeartbeatWriter::write_units() {
  std::vector<std::string> units = style_.units;
  if (style_.has_time) units.insert(units.begin(), "[time]");
  sink_(timestamp() + fmt::format("{}\n", fmt::join(units, style_.separator)));
}

void HeartbeatWriter::write(double time, std::span<const double> values) {
  if (!has_begun_ && style_.has_legend) write_legend();
  if (!has_begun_ && !style_.units.empty()) write_units();
  has_begun_ = true;
  std::vector<std::string> items;
  const auto add = [&](const std::string& name, double value) {
    const std::string number = fmt::format("{:.{}e}", value, style_.n_digits - 1);
    items.push_back(style_.has_labels ? fmt::format("{}={}", name, number) : number);
  };
  if (style_.has_time) add("Time", time);
  for (std::size_t i = 0; i < values.size(); ++i) add(names_[i], values[i]);
  sink_(timestamp() + fmt::format("{}\n", fmt::join(items, style_.separator)));
}

}  // namespace contactsim
