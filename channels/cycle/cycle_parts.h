// CycleParts: the parts of a channel that its items work on, in the order in which they build on
// each other.
//
// Thread: made before the first cycle, then the real-time cycle. Owner: the channel.
#pragma once

#include <map>
#include <memory>

#include "channels/axes/axis_motion.h"
#include "channels/axes/channel_constants.h"
#include "channels/axes/scheme_table.h"
#include "channels/axes/spindle_group.h"
#include "channels/cycle/channel_log.h"
#include "channels/cycle/channel_terms.h"
#include "channels/cycle/mark_worker.h"
#include "channels/cycle/operator_switches.h"
#include "channels/cycle/process_group.h"
#include "channels/cycle/run_control.h"

namespace stanok::channels {

struct CycleParts {
  // `schemes`, `rings` and what `stores` names outlive the parts.
  CycleParts(const motion::MotionConfig& config, const ChannelConstants& channel,
             const std::map<int, std::unique_ptr<const kinematics::Scheme>>& made, int scheme,
             ChannelLink& rings, const CycleBooks& stores)
      : motion_config(config),
        constants(channel),
        link(rings),
        books(stores),
        runs(constants.id, constants.axis_count, *books.reports),
        log(constants.id, runs, link, *books.events, *books.reports),
        schemes(made, scheme),
        axes(constants),
        drives(constants, axes),
        motion(motion_config, constants, schemes, axes, drives),
        run(runs, log, motion, link.resets_wanted),
        spindles(constants, axes, drives, motion),
        process(constants, axes, motion, spindles, log),
        switches(spindles, run),
        marks(link.riders, *books.outputs) {}
  CycleParts(const CycleParts&) = delete;
  CycleParts& operator=(const CycleParts&) = delete;

  motion::MotionConfig motion_config;
  ChannelConstants constants;
  ChannelLink& link;
  CycleBooks books;
  RunBook runs;
  ChannelLog log;
  SchemeTable schemes;
  AxisGroup axes;
  DriveGuard drives;
  AxisMotion motion;
  RunControl run;
  SpindleGroup spindles;
  ProcessGroup process;
  OperatorSwitches switches;
  MarkWorker marks;
};

}  // namespace stanok::channels
