// DryRun: a program through interpreter and path feed without a machine; for `interpret`,
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
#include "channels/preparation/path_feed.h"
#include "channels/preparation/preparation_parts.h"
#include "channels/stores/channel_tables.h"
#include "channels/stores/live_tables.h"
#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_sink.h"
#include "jobs/dry_run/fault_sieve.h"
#include "jobs/dry_run/plane_log.h"
#include "jobs/dry_run/program_advice.h"
#include "lang/run/block_search.h"
#include "lang/run/interpreter.h"

namespace stanok::jobs {

// What a dry run does at a request to another channel.
using RequestSink =
    std::function<void(const lang::ProgramRequest& request, const lang::Command& command)>;

struct DryRunResult {
  Diagnostics diagnostics;  // errors, and warnings of the load
  bool loaded = false;
  std::uint64_t blocks = 0;
  std::vector<LawBlock> laws;  // of a checked run, in their order
  PlanePositions planes;
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
// Asked often; true: the run ends where it is.
using GivesUp = std::function<bool()>;
struct RunManner {
  BlockFaults faults = BlockFaults::end_the_run;
  GivesUp gives_up{};
};

class DryRun {
 public:
  // `scheme` < 0: the one active at power-on. Throws std::invalid_argument when channel or scheme
  // do not exist.
  DryRun(const channels::MachineConfig& machine, int channel, int scheme, const lang::Files& files);

  [[nodiscard]] DryRunResult run(const std::string& program, Reachability reachability,
                                 const RecordSink& record, const RequestSink& request,
                                 RunManner manner = {});

  // The same from a block on (block search); `found` is called before the first record.
  [[nodiscard]] DryRunResult run_from(const std::string& program, const Beginning& beginning,
                                      const RecordSink& record, const SearchSink& found);

  [[nodiscard]] const channels::ChannelConfig& channel() const { return channel_; }

 private:
  [[nodiscard]] bool load(const std::string& program, Diagnostics& diagnostics);
  void go_on(const RequestSink& request, DryRunResult& result);
  void follow(const RequestSink& request, DryRunResult& result);
  [[nodiscard]] bool passes_fault(Diagnostics& diagnostics);
  [[nodiscard]] bool may_go_on(const lang::Command& command, Diagnostics& diagnostics);
  [[nodiscard]] std::optional<Diagnostic> search(const lang::StopPlace& place,
                                                 lang::SearchCollector& collector);
  [[nodiscard]] std::optional<Diagnostic> pass_request(const lang::ProgramRequest& request,
                                                       const lang::Command& command,
                                                       const lang::SearchCollector& collector);
  [[nodiscard]] bool take(const lang::Command& command, const RequestSink& request,
                          Diagnostics& diagnostics);
  void note_plane(const lang::Command& command);
  void take_request(const lang::Command& command, const lang::ProgramRequest& request,
                    const RequestSink& sink);
  [[nodiscard]] lang::Answer answer_of(const lang::ProgramRequest& request);
  void switch_scheme(int id);

  const channels::ChannelConfig& channel_;
  const lang::Files& files_;
  motion::MotionConfig motion_;
  lang::ChannelDescription description_;
  channels::LiveTables live_;
  channels::ChannelTables tables_;
  channels::SchemeSet schemes_;
  DrySink sink_;
  channels::PathFeed feed_;
  lang::Interpreter interpreter_;
  std::shared_ptr<const lang::Program> program_;
  std::uint64_t steps_max_ = 0;  // of a run; text that is passed once is free
  const kinematics::Scheme* scheme_ = nullptr;
  RunManner manner_;
  struct {
    FaultSieve sieve;
    ProgramAdvice advice;
    PlaneLog planes;
  } judges_;
};

// Everything that can be known of a program before a run: follows #kinematics, channel_run and
// channel_load with constant arguments into the worker programs. All diagnostics, each once, and
// the blocks of all programs together. Given up, it tells what it has found so far.
[[nodiscard]] DryRunResult check_program(const channels::MachineConfig& machine, int channel,
                                         int scheme, const std::string& program,
                                         const lang::Files& files, const GivesUp& gives_up = {});

}  // namespace stanok::jobs
