// PreparationParts: what running a program and searching in it share: interpreter, feed and the
// kinematic schemes.
//
// Thread: that of the preparation. Owner: the channel's preparation. Invariant: `scheme` is the one
// that interpreter tables and feed work with, but for a search under way, which may have switched.
#pragma once

#include <map>
#include <memory>

#include "channels/contract/machine_config.h"
#include "channels/messages/notice.h"
#include "channels/preparation/path_feed.h"
#include "channels/preparation/queue_sink.h"
#include "channels/stores/channel_tables.h"
#include "channels/stores/live_tables.h"
#include "channels/stores/report_book.h"
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
  SituationBook& situations;  // of the channel alone
};

struct PreparationParts {
  PreparationParts(const MachineConfig& machine, const ChannelConfig& channel,
                   const SchemeSet& scheme_set, const lang::Files& files,
                   const PreparationBooks& books);

  // Nothing is set up but the scheme of the channel, whose axes and tool stand so.
  void restart(const Stand& stand);
  // Scheme, axes and tool are these; what else is set up, and transforms, stay.
  void stand(const Stand& stand);
  // The program that the commands to come belong to.
  void set_program(std::shared_ptr<const lang::Program> next);

  const ChannelConfig& config;
  const SchemeSet& schemes;
  ReportBook& reports;
  motion::MotionConfig motion;
  lang::ChannelDescription description;
  ChannelTables tables;
  lang::Interpreter interpreter;
  QueueSink queue;
  PathFeed feed;
  const kinematics::Scheme* scheme = nullptr;
  std::shared_ptr<const lang::Program> program;
  lang::Command command;  // the newest of the interpreter
};

}  // namespace stanok::channels
