// Preparation: everything that one channel does ahead of motion, in bounded steps.
//
// Interprets the program, prepares blocks, builds and plans the path and hands it, with the items
// between, to the cycle. Told what to do by notices of the cycle. One thread at a time; never
// called from the cycle.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "channels/contract/machine_config.h"
#include "channels/contract/progress.h"
#include "channels/messages/channel_link.h"
#include "channels/preparation/path_feed.h"
#include "channels/preparation/program_search.h"
#include "channels/preparation/queue_sink.h"
#include "channels/preparation/search_sink.h"
#include "channels/stores/block_book.h"
#include "channels/stores/live_tables.h"
#include "channels/stores/report_book.h"
#include "channels/stores/shared_variables.h"
#include "lang/run/interpreter.h"

namespace stanok::channels {

// The schemes of one channel by id, made once from its configuration.
using SchemeSet = std::map<int, std::unique_ptr<const kinematics::Scheme>>;

// Throws std::invalid_argument for a type of scheme that does not exist.
[[nodiscard]] SchemeSet make_schemes(const ChannelConfig& channel);

// What a preparation shares with others of its machine; all outlive it.
struct PreparationBooks {
  LiveTables& tables;
  SharedVariables& shared;
  ChannelLink& link;
  ReportBook& reports;
  BlockBook& blocks;  // of the channel alone
};

class Preparation {
 public:
  Preparation(const MachineConfig& machine, const ChannelConfig& channel, const SchemeSet& schemes,
              const lang::Files& files, const PreparationBooks& books,
              std::function<bool()> gives_up);

  // A fault of our own, or memory that is missing, ends what the channel does with an alarm; its
  // axes stop along the path that the cycle has.
  [[nodiscard]] Progress step();

 private:
  static constexpr int commands_per_step = 64;
  enum class Task { idle, running, waiting_answer };
  using LoadResult = Expected<std::shared_ptr<const lang::Program>, Diagnostics>;

  [[nodiscard]] Progress work();
  void break_off(std::string_view code, std::string_view reason);
  void forget_path();

  // Notices of the cycle.
  void obey(const Notice& notice);
  void load(const std::string& name, std::int32_t number);
  void use_load(std::int32_t number);
  void load_line(const std::string& line);
  void finish_load(const std::string& name, const LoadResult& compiled, Diagnostics diagnostics,
                   std::int32_t number = 0);
  [[nodiscard]] Diagnostics declare_shared(const lang::Program& program);
  void start(const Notice& notice);
  void name_files();
  void take_answer(const Notice& notice);
  void reset();
  void switch_scheme(const Notice& notice);

  // Block search (preparation_search.cc).
  void search(const Notice& notice);
  [[nodiscard]] bool enter_program(ProgramSearch::Stage stage);
  [[nodiscard]] Progress search_on();
  void end_search(const Diagnostic& fault);
  void arrive();
  [[nodiscard]] std::optional<Diagnostic> pass(const lang::Command& command);
  [[nodiscard]] std::optional<Diagnostic> pass_request(const lang::Command& command,
                                                       const lang::Request& request);
  [[nodiscard]] std::optional<lang::Answer> answer_of_tables(const lang::Request& request) const;
  [[nodiscard]] std::optional<Diagnostic> obstacle_at_target() const;
  void approach(const motion::Point& target);
  [[nodiscard]] lang::Step next_command();

  // Program.
  [[nodiscard]] Progress interpret();
  [[nodiscard]] bool take(const lang::Command& command);
  void tell_codes();
  void fail(const Diagnostic& diagnostic, const motion::BlockTag& tag);

  const ChannelConfig& config_;
  const SchemeSet& schemes_;
  const lang::Files& files_;
  SharedVariables& shared_;
  ChannelLink& link_;
  ReportBook& reports_;
  BlockBook& block_book_;
  const LiveTables& live_;
  lang::Interruption is_unwanted_;  // what is being compiled
  std::uint32_t resets_obeyed_ = 0;
  motion::MotionConfig motion_;
  lang::ChannelDescription description_;
  ChannelTables tables_;
  lang::Interpreter interpreter_;
  QueueSink queue_;
  PathFeed feed_;

  Task task_ = Task::idle;
  // A load that the cycle has not used yet.
  struct Load {
    std::int32_t number = 0;
    std::shared_ptr<const lang::Program> program;
    std::string name;
  };
  Load newest_;
  std::shared_ptr<const lang::Program> program_;  // loaded
  std::string program_name_;
  std::shared_ptr<const lang::Program> line_;     // of an operator, compiled
  std::shared_ptr<const lang::Program> running_;  // one of both
  std::deque<lang::Command> entry_;               // of a run that begins in the middle
  std::optional<ProgramSearch> search_;           // where the loaded program shall begin
  const kinematics::Scheme* scheme_ = nullptr;
  bool scheme_switched_ = false;  // since the last answer or start
  bool axes_change_ = false;      // the answer to come tells where a spindle stands as an axis
  lang::Command command_;
};

}  // namespace stanok::channels
