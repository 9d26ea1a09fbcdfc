// Preparation: everything that one channel does ahead of motion, in bounded steps.
//
// Interprets the program, prepares blocks, builds and plans the path and hands it, with the items
// between, to the cycle. Told what to do by notices of the cycle. Thread: one at a time, never the
// cycle. Owner: the channel's seat in the machine. Invariant: what leaves it is in the order of the
// program, and nothing of a run that a reset has ended.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "channels/contract/progress.h"
#include "channels/messages/channel_link.h"
#include "channels/messages/recorded_work.h"
#include "channels/preparation/preparation_parts.h"
#include "channels/preparation/program_shelf.h"
#include "channels/preparation/search_runner.h"
#include "channels/stores/situation_book.h"

namespace stanok::channels {

class Preparation {
 public:
  Preparation(const MachineConfig& machine, const ChannelConfig& channel, const SchemeSet& schemes,
              const lang::Files& files, const PreparationBooks& books,
              std::function<bool()> gives_up);

  // A fault of our own, or memory that is missing, ends what the channel does with an alarm; its
  // axes stop along the path that the cycle has.
  [[nodiscard]] Progress step() { return step(nullptr, {}); }
  // The same of a run that is repeated. `may_go_on`: more was made in it than has been made by now,
  // as far as it is known.
  [[nodiscard]] Progress step(RecordedWork* recorded, const std::function<bool()>& may_go_on);
  // A run is prepared, and the cycle has little of its motion before it: the axes may come to rest
  // in the cut where the next step is late.
  [[nodiscard]] bool is_urgent();

 private:
  static constexpr int commands_per_step = 64;
  enum class Task { idle, running, waiting_answer };

  // With the recorded run, if there is one.
  struct Guide {
    RecordedWork* recorded = nullptr;
    const std::function<bool()>& may_go_on;
  };

  [[nodiscard]] Progress work(const Guide& guide);
  void break_off(std::string_view code, std::string_view reason);
  void forget_path();

  void obey_notices();
  // Notices of the cycle, one overload for each.
  void obey(const ProgramLoad& load);
  void obey(const LineLoad& load);
  void obey(const BlockSearch& search);
  void obey(const ProgramStart& notice);
  void obey(const LineStart& notice);
  void obey(const RequestAnswer& notice);
  void obey(const PathReset& reset);
  void obey(const Settle& question);
  void obey(const SchemeSwitch& change);
  void obey(const TapOut& order);
  void begin_run(const RunStart& start, std::shared_ptr<const lang::Program> program,
                 const std::string& name);
  [[nodiscard]] bool stands_elsewhere(const Stand& stand);
  void settle(const Settle& question);
  void name_files();

  // Program.
  [[nodiscard]] Progress interpret(const Guide& guide);
  [[nodiscard]] bool take_tables(const Guide& guide);
  [[nodiscard]] bool repeat_takings(const Guide& guide);
  void follow_tables();
  [[nodiscard]] Progress use_result(SearchRunner::Result result);
  [[nodiscard]] lang::Step next_command();
  [[nodiscard]] bool take(const lang::Command& command);
  void take_meanings();
  void select_situation(std::uint64_t block);
  void settle_feed();
  void fail(const Diagnostic& diagnostic, const motion::BlockTag& tag);

  ChannelLink& link_;
  SituationBook& situations_;
  std::uint32_t resets_obeyed_ = 0;
  PreparationParts parts_;
  ProgramShelf shelf_;
  SearchRunner search_;
  Task task_ = Task::idle;
  // Meanings that blocks to come were read in, by block; the first one holds now.
  struct Numbered {
    std::uint64_t block = 0;
    std::uint32_t situation = 0;
  };
  std::deque<Numbered> numbered_;
  std::uint32_t situation_ = 0;     // in which the channel stands
  std::optional<Settle> question_;  // that waits until a search is over
  std::uint32_t run_ = 0;           // its number
  std::uint64_t command_ = 0;       // of the run, the next one
  bool asks_ = false;               // the newest command was a request
  bool scheme_switched_ = false;    // since the last answer or start
  bool axes_change_ = false;        // the answer to come tells where a spindle stands as an axis
};

}  // namespace stanok::channels
