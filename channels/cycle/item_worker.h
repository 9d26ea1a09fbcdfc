// ItemWorker: the items of a program in the cycle: executed in their order, each when the path
// before it is done and the axes stand.
//
// An item that takes time (a dwell, a spindle that comes to its speed, brakes, a request) keeps
// those behind it, and the path behind it, until it is over. Thread: the real-time cycle. Owner:
// the channel. Invariant: a request is open from its item to its answer, or to a reset.
#pragma once

#include <optional>

#include "base/rt_safe.h"
#include "channels/cycle/channel_terms.h"
#include "channels/cycle/cycle_parts.h"
#include "channels/cycle/kinematics_change.h"
#include "channels/cycle/load_desk.h"
#include "channels/cycle/probe_watch.h"
#include "channels/cycle/settling.h"

namespace stanok::channels {

// A request of the program that waits for the coordinator.
struct OpenRequest {
  motion::BlockTag tag;
  Request content;
};

class ItemWorker {
 public:
  // `parts` outlive the worker.
  explicit ItemWorker(CycleParts& parts);

  // Once a cycle, before the path goes on.
  void advance() RT_SAFE;
  // The next item waits until the spindles have their speeds.
  void wait_for_spindles() RT_SAFE { wait(Activity::spindle, 0.0); }
  // A reset: what is under way is given up; when the preparation has obeyed (true: the item that
  // says so has come), all that items brought about ends.
  void give_up() RT_SAFE;
  // Sets `rest` to how the channel stands then.
  [[nodiscard]] bool drop_until_reset_done(Rest& rest) RT_SAFE;
  void end_all() RT_SAFE;

  void begin_load(const ShortText& text, Job job) RT_SAFE { loads_.begin(text, job); }
  void begin_search(const ShortText& target, SearchWay way, int passes) RT_SAFE;
  void begin_run(Job job) RT_SAFE;
  void begin_switch(int scheme) RT_SAFE;
  // Of the tap in the hole: its way comes before the answer to the request.
  void begin_tap_out() RT_SAFE;
  // Nothing runs: how the channel stands is asked for as far as it is not known any more.
  void settle() RT_SAFE { settling_.ask(stand()); }
  // To the open request.
  void answer(const ChannelAnswer& answer) RT_SAFE;

  // That of the own program, or nullptr.
  [[nodiscard]] const OpenRequest* request() const RT_SAFE {
    return request_ ? &*request_ : nullptr;
  }
  [[nodiscard]] bool is_idle() const RT_SAFE { return activity_ == Activity::none; }
  [[nodiscard]] bool is_waiting() const RT_SAFE {
    return !is_idle() && activity_ != Activity::frame;
  }
  // Nothing is under way that needs the axes where they are.
  [[nodiscard]] bool lets_axes_leave() const RT_SAFE;
  [[nodiscard]] Wait waits_for() const RT_SAFE;
  // Of what took effect last: an item, or a block of the path. While nothing runs it has no line,
  // and the situation in which the channel stands.
  [[nodiscard]] const motion::BlockTag& current_tag() const RT_SAFE { return now_; }
  // The path is at `tag` in this cycle.
  void follow(const motion::BlockTag& tag) RT_SAFE;
  void rest(const Rest& rest) RT_SAFE;
  // Chunks that may be entered now: those before the next item, none while an item is at work.
  [[nodiscard]] std::uint64_t chunk_limit() const RT_SAFE;
  // Of an item that waits for nothing but riders; 0: there is none.
  [[nodiscard]] std::uint64_t riders_before_item() const RT_SAFE;

  [[nodiscard]] ProbeWatch& probe() RT_SAFE { return probe_; }
  [[nodiscard]] const ProbeWatch& probe() const RT_SAFE { return probe_; }
  [[nodiscard]] const LoadDesk& loads() const RT_SAFE { return loads_; }
  [[nodiscard]] const KinematicsChange& change() const RT_SAFE { return change_; }
  [[nodiscard]] const ToolAtWork& tool() const RT_SAFE { return tool_; }
  [[nodiscard]] const lang::CoolantCommand& coolant() const RT_SAFE { return coolant_; }
  [[nodiscard]] Settling& settling() RT_SAFE { return settling_; }
  [[nodiscard]] const Settling& settling() const RT_SAFE { return settling_; }
  [[nodiscard]] Stand stand() const RT_SAFE;

 private:
  // Executes an item: one overload for each of its contents.
  struct Execution;
  enum class Activity : std::uint8_t { none, frame, dwell, spindle, brakes, request };

  [[nodiscard]] bool stops_where_preparation_broke_off() RT_SAFE;
  [[nodiscard]] bool finish_activity() RT_SAFE;
  [[nodiscard]] bool finish_brakes() RT_SAFE;
  void wait(Activity activity, double seconds) RT_SAFE;
  void end_run(RunResult result, std::uint64_t blocks) RT_SAFE;
  void end_effects() RT_SAFE;
  [[nodiscard]] RunStart run_start() const RT_SAFE;

  CycleParts& parts_;
  LoadDesk loads_;
  KinematicsChange change_;
  ProbeWatch probe_;
  Activity activity_ = Activity::none;
  std::int64_t cycles_left_ = 0;  // of the activity
  std::int64_t began_ = 0;        // cycle in which it began
  Item item_;                     // the item being executed
  motion::BlockTag now_;
  motion::BlockTag on_path_;  // as it was followed last
  std::optional<OpenRequest> request_;
  ToolAtWork tool_;
  lang::CoolantCommand coolant_;
  Settling settling_;
};

}  // namespace stanok::channels
