// DryRun: a program through interpreter and block preparation without a machine; for `interpret`,
// `check` and the background check.
//
// Nothing is executed: requests are answered as if all went well, switches of kinematics take
// effect at once with the axes that leave the scheme at their parked positions. One object per
// channel and run.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/diagnostic.h"
#include "channels/preparation/block_preparation.h"
#include "channels/preparation/preparation.h"
#include "channels/preparation/thread_preparation.h"
#include "channels/stores/live_tables.h"
#include "config/files/machine_file.h"
#include "lang/run/block_search.h"
#include "lang/run/interpreter.h"
#include "motion/feed_laws/law_estimate.h"
#include "runtime/fault_sieve.h"

namespace stanok::runtime {

// One record after block preparation; `block` only for motion. Both are valid during the call.
using RecordSink =
    std::function<void(const lang::Command& command, const motion::PathBlock* block)>;

// What a dry run does at a request to another channel.
using RequestSink = std::function<void(const lang::Request& request, const lang::Command& command)>;

// A block under a feed law, and what is to be expected of it.
struct LawBlock {
  Place place;
  motion::LawKind kind = motion::LawKind::none;
  motion::LawUnits units;
  double way_mm = 0.0;
  motion::LawEstimate estimate;
  bool time_is_least = false;  // the spindle follows the diameter: planned for its highest speed
};

struct DryRunResult {
  Diagnostics diagnostics;  // errors, and warnings of the load
  bool loaded = false;
  std::uint64_t blocks = 0;
  std::vector<LawBlock> laws;  // of a checked run, in their order
};

// Where a dry run begins: what comes before is interpreted only, or left out.
enum class Calculation { with, without };
struct Beginning {
  lang::SearchTarget target;
  Calculation calculation = Calculation::with;
};
// What a search came to at its target; valid during the call.
using SearchSink = std::function<void(const lang::SearchState& state, const lang::Origin& target)>;

enum class Reachability { unchecked, checked };  // every pose against the axis limits
// What a fault of a block does: it ends the run, or the run goes on to find the next one.
enum class BlockFaults { end_the_run, are_collected };

class DryRun {
 public:
  // `scheme` < 0: the one active at power-on. Throws std::invalid_argument when channel or scheme
  // do not exist.
  DryRun(const channels::MachineConfig& machine, int channel, int scheme, const lang::Files& files);

  [[nodiscard]] DryRunResult run(const std::string& program, Reachability reachability,
                                 const RecordSink& record, const RequestSink& request,
                                 BlockFaults faults = BlockFaults::end_the_run);

  // The same from a block on (block search); `found` is called before the first record.
  [[nodiscard]] DryRunResult run_from(const std::string& program, const Beginning& beginning,
                                      const RecordSink& record, const SearchSink& found);

  [[nodiscard]] const channels::ChannelConfig& channel() const { return channel_; }

 private:
  [[nodiscard]] bool load(const std::string& program, Diagnostics& diagnostics);
  void go_on(Reachability reachability, const RecordSink& record, const RequestSink& request,
             DryRunResult& result);
  [[nodiscard]] bool passes_fault(Diagnostics& diagnostics);
  [[nodiscard]] bool may_go_on(const lang::Command& command, const motion::Point& before,
                               Diagnostics& diagnostics);
  [[nodiscard]] std::optional<Diagnostic> search(const lang::StopPlace& place,
                                                 lang::SearchCollector& collector);
  [[nodiscard]] std::optional<Diagnostic> pass_request(const lang::Request& request,
                                                       const lang::Command& command,
                                                       const lang::SearchCollector& collector);
  void take(const lang::Command& command, Reachability reachability, const RecordSink& record,
            const RequestSink& request, Diagnostics& diagnostics);
  [[nodiscard]] motion::Point as_programmed(const lang::Move& move,
                                            const motion::PathBlock& block) const;
  void take_move(const lang::Command& command, const lang::Move& move, Reachability reachability,
                 const RecordSink& record, Diagnostics& diagnostics);
  void take_curve(const lang::Command& command, const lang::SplineMove& spline,
                  Reachability reachability, const RecordSink& record, Diagnostics& diagnostics);
  [[nodiscard]] bool follow(const motion::PathBlock& block, const lang::Command& command,
                            Diagnostics& diagnostics);
  void refuse(const lang::Command& command, Diagnostic diagnostic, Diagnostics& diagnostics);
  void skip(const lang::Command& command, Diagnostic diagnostic, Diagnostics& diagnostics);
  void watch_feed(Diagnostics& diagnostics);
  void estimate_law(const motion::PathBlock& block, double steady_speed);
  void take_synchronous(const lang::Command& command, const lang::SynchronousMove& move,
                        Reachability reachability, const RecordSink& record,
                        Diagnostics& diagnostics);
  void take_request(const lang::Command& command, const lang::Request& request,
                    const RequestSink& sink);
  [[nodiscard]] lang::Answer answer_of(const lang::Request& request);
  void switch_scheme(int id);

  const channels::ChannelConfig& channel_;
  const lang::Files& files_;
  motion::MotionConfig motion_;
  lang::ChannelDescription description_;
  channels::LiveTables live_;
  channels::ChannelTables tables_;
  channels::SchemeSet schemes_;
  channels::BlockPreparation blocks_;
  motion::PathBuilder builder_;
  channels::ThreadPreparation threads_;
  lang::Interpreter interpreter_;
  std::shared_ptr<const lang::Program> program_;
  std::uint64_t steps_max_ = 0;  // of a run; text that is passed once is free
  const kinematics::Scheme* scheme_ = nullptr;
  bool feed_is_warned_of_ = false;  // once a program
  std::vector<LawBlock> laws_;
  BlockFaults faults_ = BlockFaults::end_the_run;
  FaultSieve sieve_;
};

// Everything that can be known of a program before a run: follows #kinematics, channel_run and
// channel_load with constant arguments into the worker programs. All diagnostics, each once, and
// the blocks of all programs together.
[[nodiscard]] DryRunResult check_program(const channels::MachineConfig& machine, int channel,
                                         int scheme, const std::string& program,
                                         const lang::Files& files);

}  // namespace stanok::runtime
