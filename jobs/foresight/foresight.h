// Foresight: what a program will take and where it would fail, from running it beforehand on a
// virtual clock, in the background.
//
// After a program was loaded the whole machine is simulated with it, with ideal drives, the tables
// and the present places of the axes, overrides at 100 %, program stops passed over. One thread, of
// the idle scheduling class; a simulation is given up when it has had the processor for so long,
// however long it was kept waiting. Any thread may ask.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/expected.h"
#include "channels/machine/machine.h"
#include "config/files/machine_file.h"
#include "jobs/foresight/planned_path.h"
#include "recording/format/path_preview.h"

namespace stanok::jobs {

// Which run of each channel is the latest one, by channel id.
using RunsOfChannels = std::map<int, std::uint32_t>;
[[nodiscard]] RunsOfChannels runs_of(const channels::CycleOutput& output);

// Where the blocks of a channel lie in the time of a simulation; bounded.
class Timeline {
 public:
  // In the order of time. `run` counts from 1 with the simulation.
  void add(std::uint32_t run, std::uint64_t block, double t);
  // When the block begins, at the latest; nothing: the run is not known.
  [[nodiscard]] std::optional<double> at(std::uint32_t run, std::uint64_t block) const;
  // When the run ends, at the earliest.
  [[nodiscard]] std::optional<double> end_of(std::uint32_t run) const;

 private:
  struct Entry {
    std::uint32_t run = 0;
    std::uint64_t block = 0;
    double t = 0.0;
  };
  void thin_out();

  std::vector<Entry> entries_;
  std::map<std::uint32_t, double> ends_;
  double spacing_s_ = 0.05;
};

struct Outlook {
  std::optional<double> predicted_s;              // of the program that was loaded
  std::optional<double> remaining_s;              // of the current run
  std::optional<channels::AlarmReport> foreseen;  // the first alarm that it would raise
};

class Foresight {
 public:
  static constexpr std::chrono::seconds computing_time_max{120};

  // Takes the path of a channel that the program of a simulation moved; called from another thread.
  using PathTaker = std::function<void(recording::PathPreview)>;
  // Takes a line that says why a program cannot be simulated; called from another thread.
  using ObstacleTaker = std::function<void(const std::string&)>;

  // `file` outlives it.
  Foresight(const config::MachineFile& file, std::vector<std::filesystem::path> program_roots,
            PathTaker take_path, ObstacleTaker take_obstacle,
            std::chrono::nanoseconds computing_time = computing_time_max);
  ~Foresight();
  Foresight(const Foresight&) = delete;
  Foresight& operator=(const Foresight&) = delete;

  // The program was loaded; what was foreseen of the channel before is forgotten.
  void look_at(int channel, const std::string& program, const channels::CycleOutput& now,
               channels::TablesConfig tables);
  // It begins; `before` are the runs that were there when it was asked for.
  void begins(int channel, RunsOfChannels before);

  [[nodiscard]] Outlook outlook(int channel, const channels::CycleOutput& now) const;
  // Of the program that was loaded, or else of the newest simulation that moves the channel, as far
  // as it has come; nullptr: there is none.
  [[nodiscard]] std::shared_ptr<const PlannedPath> planned_path(int channel) const;

 private:
  struct Order {
    int channel = 0;
    std::string program;
    std::vector<double> axes;  // where they stand, machine axis order
    std::vector<std::pair<int, int>> schemes;
    channels::TablesConfig tables;
    std::shared_ptr<PlannedPath> path;
  };
  struct Foreseen {
    std::map<int, Timeline> timelines;  // by channel
    double total_s = 0.0;
    std::optional<channels::AlarmReport> alarm;
    bool is_known = false;
    RunsOfChannels before;
  };

  void work(const std::stop_token& stop);
  void tell_obstacle(const std::string& program, std::string_view reason) const;
  void keep(int channel, Foreseen seen);
  [[nodiscard]] Expected<Foreseen, GivenUp> foresee(const Order& order,
                                                    const std::stop_token& stop);
  [[nodiscard]] GivenUp look_ahead(const Order& order, const std::stop_token& stop);
  void grow_paths(const Order& order, const std::stop_token& stop);
  [[nodiscard]] std::shared_ptr<PlannedPath> path_of(int channel, const Order& order);
  [[nodiscard]] static std::optional<double> reached(const Foreseen& foreseen, int channel,
                                                     const channels::CycleOutput& now);

  const config::MachineFile& file_;
  std::vector<std::filesystem::path> program_roots_;
  PathTaker take_path_;
  ObstacleTaker take_obstacle_;
  std::chrono::nanoseconds computing_time_;
  mutable std::mutex mutex_;
  std::condition_variable_any wakes_;
  std::map<int, Order> orders_;                        // by channel
  std::map<int, Foreseen> foreseen_;                   // by the channel whose program it is
  std::map<int, std::shared_ptr<PlannedPath>> paths_;  // by channel
  std::uint32_t last_path_ = 0;
  std::vector<std::shared_ptr<PlannedPath>> growing_;  // of the thread that writes
  std::atomic<int> at_work_{0};                        // channel of the simulation under way
  std::atomic<bool> is_outdated_{false};
  std::jthread thread_;
};

}  // namespace stanok::jobs
