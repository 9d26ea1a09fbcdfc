#include "channels/cycle/force_terms.h"

namespace stanok::channels {
namespace {

motion::ForceCommand::Kind kind_of(lang::ForceControl::Kind kind) RT_SAFE {
  switch (kind) {
    case lang::ForceControl::Kind::off:
      break;
    case lang::ForceControl::Kind::force:
      return motion::ForceCommand::Kind::force;
    case lang::ForceControl::Kind::oscillate:
      return motion::ForceCommand::Kind::oscillate;
    case lang::ForceControl::Kind::vibration_on:
      return motion::ForceCommand::Kind::vibration_on;
    case lang::ForceControl::Kind::vibration_off:
      return motion::ForceCommand::Kind::vibration_off;
    case lang::ForceControl::Kind::depth:
      return motion::ForceCommand::Kind::depth;
  }
  return motion::ForceCommand::Kind::off;
}

}  // namespace

motion::ForceCommand command_of(const lang::ForceControl& program) RT_SAFE {
  motion::ForceCommand command;
  command.kind = kind_of(program.kind);
  command.force_n = program.force_n;
  command.feed_min = program.feed_min;
  command.feed_max = program.feed_max;
  command.per_revolution = program.per_revolution;
  command.oscillation_n = program.oscillation_n;
  command.oscillation_hz = program.oscillation_hz;
  command.level_um = program.level_um;
  command.reduced_mass_kg = program.reduced_mass_kg;
  command.depth_mm = program.depth_mm;
  return command;
}

SensorLoss tell(motion::ForceEvent event, const motion::BlockTag& tag, ChannelLog& log) RT_SAFE {
  using motion::ForceEvent;
  switch (event) {
    case ForceEvent::none:
      break;
    case ForceEvent::sensor_lost:
      log.alarm("A4010", "the power sensor gives no value: feed hold", tag);
      return SensorLoss::holds_feed;
    case ForceEvent::sensor_lost_slow:
      log.alarm("A4010", "the power sensor gives no value: the feed is S_min", tag);
      break;
    case ForceEvent::no_answer:
      log.alarm("A4011", "the power has not followed three changes of the feed: feed hold", tag);
      return SensorLoss::holds_feed;
    case ForceEvent::no_answer_slow:
      log.alarm("A4011", "the power has not followed three changes of the feed: the feed is S_min",
                tag);
      break;
    case ForceEvent::stays_high:
      log.alarm("A4011", "the power has not followed the feed down to S_min: feed hold", tag);
      return SensorLoss::holds_feed;
    case ForceEvent::stays_high_slow:
      log.alarm("A4011", "the power has not followed the feed down to S_min: the feed is S_min",
                tag);
      break;
    case ForceEvent::below_idle:
      log.alarm("A4011", "the power is lower than that of the idling spindle: feed hold", tag);
      return SensorLoss::holds_feed;
    case ForceEvent::below_idle_slow:
      log.alarm("A4011", "the power is lower than that of the idling spindle: the feed is S_min",
                tag);
      break;
    case ForceEvent::vibration_lost:
      log.tell("W611", "the vibration sensor gives no value: no oscillation is formed", tag);
      break;
    case ForceEvent::frequency_shifted:
      log.tell("W612", "the frequency would be a multiple of the spindle frequency: it was shifted",
               tag);
      break;
    case ForceEvent::oscillation_limited:
      log.tell("W613",
               "the force cannot oscillate as far as commanded: the feed would come to rest", tag);
      break;
    case ForceEvent::overload_at_feed_min:
      log.tell("W614", "the force is above its setpoint at S_min", tag);
      break;
    case ForceEvent::force_missing:
      log.tell("W615",
               "the tool has moved at feed without the set force for longer than an air cut", tag);
      break;
    case ForceEvent::cut_is_lighter:
      log.tell("W616",
               "the cut is lighter than lighter_max allows, or the sensor has lost gain: the feed "
               "rises no further",
               tag);
      break;
  }
  return SensorLoss::none;
}

}  // namespace stanok::channels
