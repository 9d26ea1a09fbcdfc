#include "jobs/foresight/foresight.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "base/batch_thread.h"
#include "runtime/axis_positions.h"
#include "runtime/simulation.h"
#include "runtime/thread_time.h"

namespace stanok::jobs {
namespace {

constexpr std::size_t entries_max = 20'000;
constexpr double machine_time_max_s = 48.0 * 3600.0;

class TimelineWriter final : public runtime::CycleObserver {
 public:
  TimelineWriter(std::map<int, Timeline>& timelines, double cycle_s)
      : timelines_(timelines), cycle_s_(cycle_s) {}

  void observe(const channels::CycleOutput& output) override {
    const double t = static_cast<double>(output.cycle) * cycle_s_;
    for (const channels::ChannelOutput& channel : output.of_channels()) {
      if (channel.running) timelines_[channel.id].add(channel.run, channel.tag.block, t);
    }
  }

 private:
  std::map<int, Timeline>& timelines_;
  double cycle_s_;
};

class PreviewGathering final : public runtime::CycleObserver {
 public:
  explicit PreviewGathering(const channels::MachineConfig& machine) {
    for (const channels::ChannelConfig& channel : machine.channels) {
      if (!channel.axes.empty())
        writers_.emplace(channel.id, recording::PreviewWriter(channel.words));
    }
  }

  void observe(const channels::CycleOutput& output) override {
    for (const channels::ChannelOutput& channel : output.of_channels()) {
      const auto writer = writers_.find(channel.id);
      if (writer != writers_.end()) writer->second.add(channel);
    }
  }

  void hand_to(const Foresight::PathTaker& take_path, const std::string& program) {
    for (auto& [channel, writer] : writers_) {
      auto points = writer.take();
      if (!points.empty()) take_path({channel, program, std::move(points)});
    }
  }

 private:
  std::map<int, recording::PreviewWriter> writers_;
};

// Paths of the channels that move, each from its first movement on.
class PathGathering final : public runtime::CycleObserver {
 public:
  using NewPath = std::function<std::shared_ptr<PlannedPath>(int channel)>;

  PathGathering(const channels::MachineConfig& machine, NewPath new_path)
      : machine_(machine), new_path_(std::move(new_path)) {
    for (const channels::ChannelConfig& channel : machine.channels)
      places_.emplace(channel.id, PartPlace(machine, channel));
  }

  void observe(const channels::CycleOutput& output) override {
    for (const channels::ChannelOutput& channel : output.of_channels()) {
      if (channel.axis_count == 0) continue;
      auto writer = writers_.find(channel.id);
      if (writer == writers_.end() && channel.running) {
        if (channel.moving)
          writer = writers_.emplace(channel.id, writer_for(channel)).first;
        else
          parts_[channel.id].see(places_.at(channel.id), channel);
      }
      if (writer != writers_.end()) writer->second.add(channel);
    }
  }

  void complete() {
    for (auto& [channel, writer] : writers_) writer.complete();
  }

 private:
  [[nodiscard]] PlannedPathWriter writer_for(const channels::ChannelOutput& output) {
    const auto config = std::find_if(machine_.channels.begin(), machine_.channels.end(),
                                     [&](const auto& one) { return one.id == output.id; });
    const auto part = parts_[output.id].at_begin(places_.at(output.id), output);
    return {machine_, *config, part, new_path_(output.id)};
  }

  const channels::MachineConfig& machine_;
  NewPath new_path_;
  std::map<int, PartPlace> places_;
  std::map<int, PartChoice> parts_;  // of the channels that have not moved
  std::map<int, PlannedPathWriter> writers_;
};

}  // namespace

RunsOfChannels runs_of(const channels::CycleOutput& output) {
  RunsOfChannels runs;
  for (const channels::ChannelOutput& channel : output.of_channels()) {
    runs[channel.id] = channel.run;
  }
  return runs;
}

void Timeline::add(std::uint32_t run, std::uint64_t block, double t) {
  ends_[run] = t;
  if (!entries_.empty()) {
    const Entry& last = entries_.back();
    const bool is_same = last.run == run && last.block == block;
    if (is_same || (last.run == run && t - last.t < spacing_s_)) return;
  }
  entries_.push_back({run, block, t});
  if (entries_.size() > entries_max) thin_out();
}

void Timeline::thin_out() {
  spacing_s_ *= 2.0;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < entries_.size(); k += 2) entries_[kept++] = entries_[k];
  entries_.resize(kept);
}

std::optional<double> Timeline::at(std::uint32_t run, std::uint64_t block) const {
  if (!ends_.contains(run)) return std::nullopt;
  const auto is_before = [](const Entry& entry,
                            const std::pair<std::uint32_t, std::uint64_t>& key) {
    return std::pair(entry.run, entry.block) <= key;
  };
  const auto behind =
      std::lower_bound(entries_.begin(), entries_.end(), std::pair(run, block), is_before);
  return behind == entries_.begin() ? 0.0 : (behind - 1)->t;
}

std::optional<double> Timeline::end_of(std::uint32_t run) const {
  const auto end = ends_.find(run);
  return end == ends_.end() ? std::nullopt : std::optional(end->second);
}

Foresight::Foresight(const config::MachineFile& file,
                     std::vector<std::filesystem::path> program_roots, PathTaker take_path,
                     ObstacleTaker take_obstacle, std::chrono::nanoseconds computing_time)
    : file_(file),
      program_roots_(std::move(program_roots)),
      take_path_(std::move(take_path)),
      take_obstacle_(std::move(take_obstacle)),
      computing_time_(computing_time),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

Foresight::~Foresight() {
  end_batch_thread(thread_);
}

void Foresight::look_at(int channel, const std::string& program, const channels::CycleOutput& now,
                        channels::TablesConfig tables) {
  Order order{channel, program,           runtime::positions_of_axes(file_.machine, now),
              {},      std::move(tables), nullptr};
  for (const channels::ChannelConfig& config : file_.machine.channels) {
    const channels::ChannelOutput* output = now.of_channel(config.id);
    if (output == nullptr) continue;
    if (output->scheme != 0) order.schemes.emplace_back(config.id, output->scheme);
  }
  const std::lock_guard lock(mutex_);
  foreseen_.erase(channel);
  order.path = std::make_shared<PlannedPath>(++last_path_, program);
  paths_[channel] = order.path;
  orders_[channel] = std::move(order);
  if (at_work_ == channel) is_outdated_ = true;
  wakes_.notify_one();
}

void Foresight::begins(int channel, RunsOfChannels before) {
  const std::lock_guard lock(mutex_);
  foreseen_[channel].before = std::move(before);
}

// The root of the thread: what cannot be foreseen is no reason to end a machine at work.
void Foresight::work(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    Order order;
    {
      std::unique_lock lock(mutex_);
      if (!wakes_.wait(lock, stop, [this] { return !orders_.empty(); })) return;
      order = std::move(orders_.extract(orders_.begin()).mapped());
      at_work_ = order.channel;
      is_outdated_ = false;
    }
    grow_paths(order, stop);
    growing_.clear();
    const std::lock_guard lock(mutex_);
    at_work_ = 0;
  }
}

// Where there is no memory even to begin, nobody can be told.
void Foresight::grow_paths(const Order& order, const std::stop_token& stop) {
  try {
    growing_ = {order.path};
    const GivenUp why = look_ahead(order, stop);
    for (const auto& path : growing_) path->give_up(why);
  } catch (...) {
    return;
  }
}

// Why it was given up, for the paths that are not complete.
GivenUp Foresight::look_ahead(const Order& order, const std::stop_token& stop) {
  try {
    auto seen = foresee(order, stop);
    if (!seen) return seen.error();
    keep(order.channel, std::move(*seen));
  } catch (const std::exception& error) {
    tell_obstacle(order.program, error.what());
  } catch (...) {
    tell_obstacle(order.program, "");
  }
  return GivenUp::failed;
}

// Where memory ends nobody can be told.
void Foresight::tell_obstacle(const std::string& program, std::string_view reason) const {
  try {
    const std::string why = reason.empty() ? "" : ": " + std::string(reason);
    take_obstacle_(program + " cannot be simulated beforehand" + why);
  } catch (...) {
    return;
  }
}

void Foresight::keep(int channel, Foreseen seen) {
  const std::lock_guard lock(mutex_);
  if (is_outdated_) return;
  Foreseen& kept = foreseen_[channel];
  seen.before = std::move(kept.before);
  kept = std::move(seen);
}

// Throws where it cannot be simulated.
Expected<Foresight::Foreseen, GivenUp> Foresight::foresee(const Order& order,
                                                          const std::stop_token& stop) {
  const BatchWork batch(stop);
  Foreseen seen;
  runtime::SimulationOptions options;
  options.file = file_;
  options.file.machine.tables = order.tables;
  for (std::size_t k = 0; k < order.axes.size(); ++k)
    options.file.machine.axes[k].start = order.axes[k];
  options.program_roots = program_roots_;
  options.programs = {{order.channel, order.program}};
  options.schemes = order.schemes;
  options.until_s = machine_time_max_s;
  TimelineWriter writer(seen.timelines, file_.machine.cycle_us * 1e-6);
  PreviewGathering previews(file_.machine);
  PathGathering paths(file_.machine, [&](int channel) { return path_of(channel, order); });
  const auto give_up_at = runtime::processor_time_of_thread() + computing_time_;
  GivenUp given_up = GivenUp::no;
  constexpr std::int64_t cycles_between_looks = 256;  // at the clock: a look costs half a cycle
  std::int64_t cycle = 0;
  const auto interrupted = [&] {
    if (stop.stop_requested() || is_outdated_)
      given_up = GivenUp::replaced;
    else if (cycle++ % cycles_between_looks == 0 &&
             runtime::processor_time_of_thread() > give_up_at)
      given_up = GivenUp::computing_time;
    return given_up != GivenUp::no;
  };
  const auto result = runtime::simulate(options, {&writer, &previews, &paths}, interrupted);
  if (given_up == GivenUp::no && result.until_reached) given_up = GivenUp::machine_time;
  if (given_up == GivenUp::no && !result.refusals.empty()) given_up = GivenUp::refused;
  if (given_up != GivenUp::no) return Unexpected<GivenUp>(given_up);
  seen.total_s = result.machine_time_s;
  if (!result.alarms.empty()) seen.alarm = result.alarms.front();
  previews.hand_to(take_path_, order.program);
  paths.complete();
  order.path->complete();
  seen.is_known = true;
  return seen;
}

std::shared_ptr<PlannedPath> Foresight::path_of(int channel, const Order& order) {
  if (channel == order.channel) return order.path;
  const std::lock_guard lock(mutex_);
  auto path = std::make_shared<PlannedPath>(++last_path_, order.program);
  growing_.push_back(path);
  if (!is_outdated_) paths_[channel] = path;
  return path;
}

std::shared_ptr<const PlannedPath> Foresight::planned_path(int channel) const {
  const std::lock_guard lock(mutex_);
  const auto path = paths_.find(channel);
  return path == paths_.end() ? nullptr : path->second;
}

// How far in the time of the simulation a channel has come.
std::optional<double> Foresight::reached(const Foreseen& foreseen, int channel,
                                         const channels::CycleOutput& now) {
  const channels::ChannelOutput* output = now.of_channel(channel);
  const auto timeline = foreseen.timelines.find(channel);
  const auto before = foreseen.before.find(channel);
  if (output == nullptr || timeline == foreseen.timelines.end() ||
      before == foreseen.before.end() || !output->running || output->run <= before->second)
    return std::nullopt;
  return timeline->second.at(output->run - before->second, output->tag.block);
}

Outlook Foresight::outlook(int channel, const channels::CycleOutput& now) const {
  const std::lock_guard lock(mutex_);
  Outlook outlook;
  const auto own = foreseen_.find(channel);
  if (own != foreseen_.end() && own->second.is_known) {
    outlook.predicted_s = own->second.total_s;
    outlook.foreseen = own->second.alarm;
    // The master waits while its workers come on.
    std::optional<double> farthest = reached(own->second, channel, now);
    if (!farthest) return outlook;
    for (const auto& [id, timeline] : own->second.timelines)
      farthest = std::max(*farthest, reached(own->second, id, now).value_or(0.0));
    outlook.remaining_s = own->second.total_s - *farthest;
    return outlook;
  }
  for (const auto& [owner, foreseen] : foreseen_) {
    const auto t = reached(foreseen, channel, now);
    if (!foreseen.is_known || !t || !reached(foreseen, owner, now)) continue;
    const std::uint32_t run = now.of_channel(channel)->run - foreseen.before.at(channel);
    outlook.remaining_s = foreseen.timelines.at(channel).end_of(run).value_or(*t) - *t;
  }
  return outlook;
}

}  // namespace stanok::jobs
