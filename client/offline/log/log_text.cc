#include "client/offline/log/log_text.h"

#include <fmt/format.h>

#include <cmath>

#include "channels/stores/live_tables.h"
#include "client/terminal/text_table.h"
#include "recording/format/encode.h"

namespace stanok::client {
namespace {

using recording::ChannelContents;
using recording::Damage;
using recording::DamageKind;
using recording::LogContents;
using recording::LogDescription;

// Holds for any two times, as a damaged log may have them.
double seconds_between(std::int64_t first_utime, std::int64_t utime) {
  return (static_cast<double>(utime) - static_cast<double>(first_utime)) * 1e-6;
}

std::string axes_text(const recording::ChannelDescription& channel) {
  std::string text;
  for (const auto& axis : channel.axes) {
    text += (text.empty() ? "" : " ") + axis.name;
    if (axis.word != axis.name) text += "=" + axis.word;
  }
  return text.empty() ? "no axes" : text;
}

std::string description_text(const LogDescription& log) {
  std::string text = fmt::format("machine  {}, cycle {} us\n", log.machine, log.cycle_us);
  text += fmt::format("made by  stanok {}, {}, {}\n", log.version, log.build, log.libm);
  for (const auto& channel : log.channels) {
    text += fmt::format("channel  {}: {}\n", channel.id, axes_text(channel));
  }
  return text;
}

std::string damage_text(const Damage& damage) {
  switch (damage.kind) {
    case DamageKind::cut:
      return fmt::format("the file is cut: {} bytes from byte {} are not a whole event",
                         damage.bytes, damage.offset);
    case DamageKind::unreadable:
      return fmt::format("damaged: {} bytes from byte {} were skipped", damage.bytes,
                         damage.offset);
    case DamageKind::altered:
      return fmt::format("damaged: some of the {} bytes from byte {} have been altered",
                         damage.bytes, damage.offset);
  }
  return {};
}

std::string end_text(const recording::LogCoverage& coverage) {
  if (!coverage.has_checks)
    return "recorded without checksums, as by stanok 0.1.0: altered bytes cannot be detected\n";
  switch (coverage.end) {
    case recording::LogEnd::complete:
      return "";
    case recording::LogEnd::next_piece:
      return "the recording continues in its next file\n";
    case recording::LogEnd::goes_on:
      return "no trailer: the recording was cut (power failure, kill, full disk) or is still in "
             "progress\n";
  }
  return "";
}

std::string fault_text(const LogContents& contents, const Terminal& terminal) {
  std::string text;
  for (const Damage& damage : contents.damage) {
    text += terminal.coloured(damage_text(damage), Colour::red) + "\n";
  }
  for (const auto& [name, channel] : contents.channels) {
    if (channel.undecodable > 0) {
      const std::string line = fmt::format("damaged: {} messages of {} are not of type {}",
                                           channel.undecodable, name, channel.type);
      text += terminal.coloured(line, Colour::red) + "\n";
    }
    if (channel.missing > 0) {
      const std::string line = fmt::format("missing: {} messages of {}", channel.missing, name);
      text += terminal.coloured(line, Colour::yellow) + "\n";
    }
  }
  if (text.empty()) text = "no damage, nothing missing\n";
  return text + end_text(contents.coverage);
}

std::string length_text(const situation_t& situation) {
  const double length = std::hypot(situation.length[0], situation.length[1], situation.length[2]);
  if (length == 0.0 && situation.length_tool == 0) return "-";
  const auto& along = situation.length;
  const bool is_along_z = along[0] == 0.0 && along[1] == 0.0;
  const std::string value = is_along_z
                                ? fmt::format("{:.3f}", along[2])
                                : fmt::format("{:.3f} {:.3f} {:.3f}", along[0], along[1], along[2]);
  return situation.length_tool == 0 ? value : fmt::format("H{} {}", situation.length_tool, value);
}

}  // namespace

std::string text_of(const LogContents& contents, const Terminal& terminal) {
  std::string text = contents.description ? description_text(*contents.description)
                                          : "the log does not describe its machine\n";
  text += fmt::format("span     {:.3f} s, {} events, {} bytes\n\n",
                      seconds_between(contents.utime_first, contents.utime_last), contents.events,
                      contents.bytes);
  TextTable table({"LCM channel", "type", "messages", "bytes", "from [s]", "to [s]"});
  for (const auto& [name, channel] : contents.channels) {
    table.add_row(
        {name, channel.type, std::to_string(channel.messages), std::to_string(channel.bytes),
         fmt::format("{:.3f}", seconds_between(contents.utime_first, channel.utime_first)),
         fmt::format("{:.3f}", seconds_between(contents.utime_first, channel.utime_last))});
  }
  return text + table.text(terminal) + "\n" + fault_text(contents, terminal);
}

std::vector<std::string> situation_row(const situation_t& situation,
                                       const recording::LogContents& contents) {
  return {fmt::format("{:.3f}", seconds_between(contents.utime_first, situation.utime)),
          std::to_string(situation.channel),
          std::to_string(situation.number),
          channels::work_offset_name(situation.work_offset_number),
          situation.tool == 0 ? "-" : fmt::format("T{}.{}", situation.tool, situation.edge),
          length_text(situation),
          std::string(recording::text_of(situation.codes))};
}

}  // namespace stanok::client
