// The interpreter of one channel: compiled programs in, commands out, one bounded step at a time.
//
// Owner: the channel's preparation (one thread). Nothing here blocks: at a sync point `next` yields
// the ProgramRequest as a command and then returns Step::waiting until `answer` was called, in the
// middle of an expression too.
#pragma once

#include <memory>
#include <vector>

#include "base/diagnostic.h"
#include "lang/contract/changed_rows.h"
#include "lang/contract/command.h"
#include "lang/contract/environment.h"
#include "lang/contract/meaning.h"
#include "lang/program/compile.h"
#include "lang/run/block_search.h"

namespace stanok::lang {

enum class Step {
  command,  // `command` was filled
  working,  // the bound of work was reached without a command (a loop without blocks); call again
  waiting,  // an Answer is owed
  stopped,  // the place of a search is reached, nothing of it executed; next() goes on
  ended,    // ProgramEnd was delivered before
  failed,   // the program ended with an error; see error()
};

// What is known behind a faulty block that was passed: nothing, it cannot be passed; where the axes
// are to be; the run may go on, but not where they are.
enum class Passed { no, known_position, unknown_position };

class Interpreter {
 public:
  Interpreter(const ChannelDescription& channel, Tables& tables, const Files& files);
  ~Interpreter();
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  // Begins a run of `program` with the default modal state, the programmed point standing at
  // `position_B`. FrameChange and ToolLength of the default state are emitted before the first
  // move.
  void start(std::shared_ptr<const Program> program, const AxisValues& position_B);

  // Begins a run of a line, in the state in which the channel stands: modal state lasts from line
  // to line; behind a program or a reset it is the default one.
  void start_line(std::shared_ptr<const Program> line, const AxisValues& position_B);

  // Begins a run that stops, once, before `place` (Step::stopped): block search with calculation.
  // What comes before is for a SearchCollector, not for the machine.
  void start_search(std::shared_ptr<const Program> program, const AxisValues& position_B,
                    const StopPlace& place);

  // Begins a run at `place` with the default modal state: block search without calculation. The
  // error is E6042: the place lies inside braces or a subprogram.
  [[nodiscard]] std::optional<Diagnostic> start_at(std::shared_ptr<const Program> program,
                                                   const AxisValues& position_B,
                                                   const StopPlace& place);

  // Whatever runs is over: the channel stands in the default state, with this tool in place. What
  // was interpreted ahead did not come about.
  void reset(const ToolInPlace& tool);

  // The run is over, where what it wants cannot be done.
  void break_off();

  // In what the channel stands while nothing runs. Of a run it holds when that has ended or failed;
  // a search leaves it as it is.
  [[nodiscard]] Meaning standing() const;
  // The machine has this tool in place.
  void take_tool(const ToolInPlace& tool);
  // An operator has changed rows of the tables while the channel stands.
  void take_changed_rows(const ChangedRows& rows);
  // Lengths that count at once have changed in a hold (Tables::in_force): the programmed point
  // stays.
  void follow_lengths();

  // Does a bounded amount of work. `command` is valid only when Step::command is returned.
  [[nodiscard]] Step next(Command& command);

  // The answer to the ProgramRequest delivered last.
  void answer(const Answer& answer);

  // After Step::failed: why, with place and call stack.
  [[nodiscard]] const Diagnostic& error() const;

  // After Step::failed by a block: the run goes on behind it, as if it had done what its words say
  // as far as that is clear. For those who look for all faults of a program; nothing may move.
  [[nodiscard]] Passed pass_fault();

  // Line of the current statement, for status displays.
  [[nodiscard]] Origin origin() const;

  // Steps of this run: instructions and lines, a block counts hundred.
  [[nodiscard]] std::uint64_t steps() const;
  // The run moved, waited or asked: the steps that it may compute without (ProgramBounds) begin
  // anew. A run that takes more fails with E8005. The first run of a Interpreter and each start
  // begin with all of them.
  void renew_steps();

  // ISO blocks executed in this run.
  [[nodiscard]] std::uint64_t blocks() const;

  // Changes of the meaning of words since the last call.
  [[nodiscard]] std::vector<MeaningChange> take_meanings();

  // Bit n: blocks that begin with /n are skipped (1 also for / alone). To be called before start
  // and at sync points only.
  void set_block_skip(std::uint16_t levels);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stanok::lang
