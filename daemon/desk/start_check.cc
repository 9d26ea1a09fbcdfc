#include "daemon/desk/start_check.h"

#include <cmath>

#include "daemon/report/search_report.h"

namespace stanok::daemon {
namespace {

constexpr double same_place = 1e-6;  // mm, deg

bool stands_elsewhere(const channels::SearchReport& search, const channels::ChannelOutput& now) {
  for (std::size_t k = 0; k < search.axes_M.size(); ++k)
    if (std::abs(search.axes_M[k] - now.axes[static_cast<int>(k)].position) > same_place)
      return true;
  return false;
}

std::string list_of(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + text;
  return list;
}

}  // namespace

std::optional<protocol::Failure> obstacle_to_start(RunningMachine& machine, int channel,
                                                   const nlohmann::json& parameters) {
  const auto search = machine.search(channel);
  if (!search || !search->state.calculated) return std::nullopt;
  const auto refused = [&](const char* code, const std::string& text) {
    return protocol::Failure{protocol::FailureKind::refused, code, text, channel, {}};
  };
  const std::string target = search->file + ":" + std::to_string(search->line);
  const std::string number = std::to_string(search->number);
  const auto given = parameters.value("approach", std::uint32_t{0});
  if (given == 0)
    return refused("E6045", "the program would begin at " + target +
                                ": look at its approach and give its number, " + number);
  const channels::CycleOutput output = machine.newest_output();
  const channels::ChannelOutput* const now = output.of_channel(channel);
  if (now == nullptr || given != search->number || now->tag.situation != search->situation ||
      stands_elsewhere(*search, *now))
    return refused("E6046", "axes, tool or tables have changed since " + target + " was searched");
  const auto changes = changes_of_start(*search, *now);
  if (!changes.empty() && parameters.value("restore", 0) == 0)
    return refused("E6047", "the program needs at " + target + ": " + list_of(changes));
  return std::nullopt;
}

}  // namespace stanok::daemon
