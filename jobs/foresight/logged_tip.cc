#include "jobs/foresight/logged_tip.h"

#include <algorithm>

#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode_tool_row.h"
#include "runtime/workpiece/workpiece_feed.h"

namespace stanok::jobs {

using recording::Topic;

LoggedTip::LoggedTip(const channels::MachineConfig& machine, const channels::ChannelConfig& channel,
                     const PartSystem& part)
    : channel_(channel.id),
      place_(machine, channel),
      part_(part),
      tools_(runtime::tools_of(machine.tables)) {}

void LoggedTip::take(const tool_t& message) {
  tool_ = {message.number, message.edge};
}

void LoggedTip::take(const tool_row_t& message) {
  if (const auto row = recording::from_tool_row(message))
    tools_[{row->number, row->edge}] = runtime::record_of(*row);
}

std::optional<simulation::Vector> LoggedTip::at(const setpoint_t& setpoint) const {
  simulation::Axes axes_M{};
  const int most = static_cast<int>(std::min(axes_M.size(), std::size(setpoint.position)));
  std::copy_n(setpoint.position, std::clamp(setpoint.axis_count, 0, most), axes_M.begin());
  const auto tool = tools_.find({tool_.number, tool_.edge});
  const auto mount = tool == tools_.end() ? simulation::ToolMount{} : tool->second.mount;
  const auto place = place_.tool_over_bed_in(part_, setpoint.scheme, axes_M, mount);
  if (!place) return std::nullopt;
  return place->tip;
}

std::optional<recording::LogError> for_each_place(
    const std::filesystem::path& log, LoggedTip& tip,
    const std::function<void(const setpoint_t&, const std::optional<simulation::Vector>&)>& visit) {
  auto reader = recording::LogReader::open(log);
  if (!reader) return reader.error();
  const auto of_channel = [&](const auto& message) {
    return message && message->channel == tip.channel();
  };
  while (const auto event = reader->next()) {
    const std::string_view topic = recording::topic_of(event->channel);
    if (topic == recording::name_of(Topic::setpoint)) {
      const auto message = recording::decode<setpoint_t>(event->bytes);
      if (of_channel(message)) visit(*message, tip.at(*message));
    } else if (topic == recording::name_of(Topic::tool)) {
      const auto message = recording::decode<tool_t>(event->bytes);
      if (of_channel(message)) tip.take(*message);
    } else if (topic == recording::name_of(Topic::tool_row)) {
      const auto message = recording::decode<tool_row_t>(event->bytes);
      if (of_channel(message)) tip.take(*message);
    }
  }
  return std::nullopt;
}

}  // namespace stanok::jobs
