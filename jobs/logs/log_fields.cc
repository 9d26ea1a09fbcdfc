#include "jobs/logs/log_fields.h"

#include <fmt/format.h>

#include "base/enum_names.h"

namespace stanok::jobs {
namespace {

using recording::ChannelContents;
using recording::ChannelDescription;
using recording::Damage;
using recording::DamageKind;
using recording::LogContents;

constexpr auto damage_names = enum_names<DamageKind>({
    {DamageKind::cut, "cut"},
    {DamageKind::unreadable, "unreadable"},
    {DamageKind::altered, "altered"},
});

constexpr auto log_end_names = enum_names<recording::LogEnd>({
    {recording::LogEnd::complete, "complete"},
    {recording::LogEnd::next_piece, "next_piece"},
    {recording::LogEnd::goes_on, "missing"},
});

// "unknown": of a log without checks.
std::string_view end_name(const recording::LogCoverage& coverage) {
  return coverage.has_checks ? log_end_names[coverage.end] : "unknown";
}

Fields axis_names(const std::vector<ChannelDescription>& channels) {
  Fields fields;
  for (const ChannelDescription& channel : channels) {
    fields.push_back({std::to_string(channel.id), field_list(channel.axes, [](const auto& axis) {
                        return text_field(axis.name);
                      })});
  }
  return fields;
}

void add_machine(Fields& fields, const LogContents& contents) {
  if (!contents.description) {
    fields.push_back({"machine", {}});
    return;
  }
  const recording::LogDescription& log = *contents.description;
  fields.insert(fields.end(), {{"machine", log.machine},
                               {"cycle_us", count_field(log.cycle_us)},
                               {"version", log.version},
                               {"build", log.build},
                               {"libm", log.libm},
                               {"config_hash", fmt::format("{:016x}", log.config_hash)},
                               {"axes", axis_names(log.channels)}});
}

FieldValue messages_of(const std::string& name, const ChannelContents& channel) {
  return Fields{{"name", name},
                {"type", channel.type},
                {"messages", count_field(channel.messages)},
                {"bytes", count_field(channel.bytes)},
                {"missing", count_field(channel.missing)},
                {"undecodable", count_field(channel.undecodable)},
                {"utime_first", count_field(channel.utime_first)},
                {"utime_last", count_field(channel.utime_last)}};
}

FieldValue damage_fields(const Damage& damage) {
  return Fields{{"kind", text_field(damage_names[damage.kind])},
                {"offset", count_field(damage.offset)},
                {"bytes", count_field(damage.bytes)}};
}

}  // namespace

Fields log_fields(const LogContents& contents) {
  Fields fields{{"ok", contents.is_sound() && !contents.is_cut()},
                {"covered", contents.coverage.has_checks},
                {"end", text_field(end_name(contents.coverage))},
                {"events", count_field(contents.events)},
                {"bytes", count_field(contents.bytes)},
                {"utime_first", count_field(contents.utime_first)},
                {"utime_last", count_field(contents.utime_last)}};
  add_machine(fields, contents);
  fields.push_back({"channels", field_list(contents.channels, [](const auto& named) {
                      return messages_of(named.first, named.second);
                    })});
  fields.push_back({"damage", field_list(contents.damage, damage_fields)});
  return fields;
}

}  // namespace stanok::jobs
