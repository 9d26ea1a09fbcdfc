#include "daemon/server/orderly_end.h"

#include <algorithm>

namespace stanok::daemon {
namespace {

using channels::ChannelOutput;

constexpr auto rest_time_max = std::chrono::seconds(10);

bool all(const channels::CycleOutput& output, bool (*claim)(const ChannelOutput&)) {
  return std::ranges::all_of(output.of_channels(), claim);
}

bool stands(const ChannelOutput& channel) {
  return !channel.moving;
}

bool is_off(const ChannelOutput& channel) {
  return std::none_of(channel.drives.begin(), channel.drives.begin() + channel.axis_count,
                      [](const auto& drive) { return drive.enabled; });
}

}  // namespace

void OrderlyEnd::begin(Time now) {
  if (stage_ != Stage::not_begun) return;
  stage_ = Stage::holding;
  deadline_ = now + rest_time_max;
  stops_.order(channels::commands::ProgramHold{});
}

bool OrderlyEnd::step(Time now) {
  if (stage_ == Stage::not_begun) return false;
  if (now >= deadline_) stage_ = Stage::done;
  const auto output = machine_.newest_output();
  if (stage_ == Stage::holding && all(output, stands)) {
    stage_ = Stage::switching_off;
    stops_.order(channels::commands::MachineOff{});
  } else if (stage_ == Stage::switching_off && all(output, stands) && all(output, is_off)) {
    stage_ = Stage::done;
  }
  return stage_ == Stage::done;
}

}  // namespace stanok::daemon
