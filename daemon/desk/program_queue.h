// ProgramQueue: programs of a channel that begin one after the other, once an operator has started
// the queue.
//
// A program begins only behind one that has ended without an alarm. Whatever an operator would look
// at first stops the queue: an alarm of any channel, a stop, a reset, an emergency stop, another
// program, somebody else who has taken the channel. What is under way goes on then; nothing begins
// behind it. A feed hold is none of these when an operator lets the program go on. Programs that
// wait are kept on the disk with their ids, and no id is ever given twice; after a start of the
// daemon every queue stands still. Belongs to the
// operator server's thread; `tick` wants to be called often.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "daemon/cycle/asked_at.h"
#include "daemon/desk/background_work.h"
#include "daemon/desk/channel_control.h"
#include "daemon/desk/command_desk.h"

namespace stanok::daemon {

class ProgramQueue {
 public:
  static constexpr std::size_t programs_max = 500;  // of a channel

  // Who lets programs begin, and when it was asked for. What follows the first of them has no age.
  struct Starter {
    int session = 0;
    std::string peer;
    AskedAt asked_at;
  };

  // All but the file outlive the queue; what the file holds is taken over. `notes` are kept up to
  // date.
  ProgramQueue(RunningMachine& machine, CommandDesk& desk, const ChannelControl& control,
               NotesOfChannels& notes, std::filesystem::path file);

  // Channel 0: of all. Parameters are as checked_parameters returned them.
  [[nodiscard]] nlohmann::json list(int channel) const;
  // Answered when the disk has it. What the disk does not take (E9023) is not added, unless it is
  // under way by then; what was removed or moved stays so until the daemon ends.
  void add(const nlohmann::json& parameters, int channel, Answer answer);
  void remove(const nlohmann::json& parameters, int channel, Answer answer);
  void move(const nlohmann::json& parameters, int channel, Answer answer);
  [[nodiscard]] CommandResult start(int channel, Starter starter);
  [[nodiscard]] CommandResult stop(int channel, const std::string& peer);

  void tick();
  // The machine has accepted this, whoever asked.
  void note(const channels::OperatorEvent& accepted);

 private:
  struct Entry {
    std::uint64_t id = 0;
    std::string program;
  };
  struct Line {
    std::vector<Entry> entries;
    bool is_started = false;
    std::uint64_t under_way = 0;  // id of the entry; 0: none
    bool is_accepted = false;     // the machine has begun it
    Starter starter;
    std::string stopped_by;
    std::uint64_t version = 0;  // another one with every change
  };

  void read();
  void take_over(const std::string& text);
  void take_over_version_1(const std::string& text);
  void append(int channel, Entry entry);
  void reserve_ids();
  [[nodiscard]] std::string text() const;
  [[nodiscard]] nlohmann::json shown(int channel, const Line& line) const;
  void changed(int channel);
  static void end_if_empty(Line& line);
  void halt(int channel, const std::string& why);
  void note(int channel, const channels::OperatorEvent& accepted);
  [[nodiscard]] std::string obstacle(int channel, const Line& line);
  void begin_next(int channel, Line& line);
  void ended(int channel, const CommandResult& outcome);
  // A change that waits for the disk; then `answer` gets the queue of the channel.
  struct Change {
    int channel = 0;
    std::uint64_t added = 0;  // id of the entry; 0: none
    Answer answer;
  };
  void keep(Change change);
  void withdraw(const Change& change);
  void write();

  RunningMachine& machine_;
  CommandDesk& desk_;
  const ChannelControl& control_;
  NotesOfChannels& notes_;
  std::filesystem::path file_;
  std::map<int, Line> lines_;  // by channel, every one
  std::uint64_t last_id_ = 0;
  std::uint64_t reserved_id_ = 0;  // on the disk: no later daemon gives one up to it
  bool is_to_be_written_ = false;
  bool is_being_written_ = false;
  std::vector<Change> waiting_;  // for the disk
  BackgroundWork files_{BackgroundWork::Urgency::usual};
};

}  // namespace stanok::daemon
