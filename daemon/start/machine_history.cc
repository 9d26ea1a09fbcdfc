#include "daemon/start/machine_history.h"

#include <fmt/chrono.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <ctime>

#include "daemon/host/unix_time.h"

namespace stanok::daemon {
namespace {

// As the clock on the wall says it.
std::string wall_time(double unix_s) {
  const auto seconds = static_cast<std::time_t>(std::floor(unix_s));
  std::tm local{};
  localtime_r(&seconds, &local);
  return fmt::format("{:%Y-%m-%d %H:%M:%S}", local);
}

std::string place_of_end(const JournalContents::CutOff& cut) {
  return cut.line > 0 ? cut.file + ":" + std::to_string(cut.line) : cut.file;
}

}  // namespace

// When a cycle was is told by the newest one and the clock of the wall, as cycles may be lost and
// the clock may be set.
MachineHistory::MachineHistory(const std::filesystem::path& state_directory,
                               RunningMachine& machine, channels::Machine& reports)
    : machine_(machine), reports_(reports), watch_(machine), journal_(state_directory) {
  watch_.pass_over(journal_.before().past());
  const double cycle_s = machine.file().machine.cycle_us * 1e-6;
  reports_.recall(journal_.before().past(), [&machine, cycle_s](std::int64_t cycle) {
    return unix_time_s() - static_cast<double>(machine.cycles() - cycle) * cycle_s;
  });
  for (const auto& cut : journal_.before().cut_off()) close(cut);
}

void MachineHistory::close(const JournalContents::CutOff& cut) {
  journal_.add(run_ended_record(cut.run));
  channels::AlarmReport alarm;
  alarm.channel = cut.run.channel;
  alarm.at = unix_time_s();
  alarm.diagnostic.code = "W941";
  alarm.diagnostic.message = "the control ended in " + place_of_end(cut) + " at " +
                             wall_time(cut.run.ended_at) + " without being shut down";
  alarm.diagnostic.place.file = cut.file;
  alarm.diagnostic.place.line = cut.line;
  spdlog::warn("channel {}: {}", cut.run.channel, alarm.diagnostic.message);
  reports_.note(std::move(alarm));
}

void MachineHistory::begin() {
  journal_.begin([this] { return watch_.look(unix_time_s()); },
                 [this](const std::string& fault) { tell_not_kept("the journal", fault); });
}

void MachineHistory::tell(std::string_view code, const std::string& text) {
  channels::AlarmReport alarm;
  alarm.channel = machine_.file().machine.channels.front().id;
  alarm.at = unix_time_s();
  alarm.diagnostic.code = code;
  alarm.diagnostic.message = text;
  channels::Event event;
  event.cycle = machine_.cycles();
  event.channel = alarm.channel;
  event.code = FixedText<8>(code);
  event.text = FixedText<240>(text);
  reports_.note(std::move(alarm));
  const std::lock_guard lock(mutex_);
  if (announce_) announce_(event);
}

void MachineHistory::announce_to(Announce announce) {
  const std::lock_guard lock(mutex_);
  announce_ = std::move(announce);
}

void MachineHistory::tell_not_kept(const std::string& what, const std::string& fault) {
  tell("W940", what + " cannot be saved: " + fault);
}

}  // namespace stanok::daemon
