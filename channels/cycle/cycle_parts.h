// CycleParts: the parts of a channel that its items work on, in the order in which they build on
// each other.
//
// Thread: made before the first cycle, then the real-time cycle. Owner: the channel.
#pragma once

#include <map>
#include <memory>

#include "channels/axes/axis_motion.h"
#include "channels/axes/channel_figures.h"
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
  CycleParts(const motion::MotionConfig& config, const ChannelFigures& channel,
             const std::map<int, std::unique_ptr<const kinematics::Scheme>>& made, int scheme,
             ChannelLink& rings, const CycleBooks& stores)
      : motion_config(config),
        figures(channel),
        link(rings),
        books(stores),
        runs(figures.id, figures.axis_count, *books.reports),
        log(figures.id, runs, link, *books.events, *books.reports),
        schemes(made, scheme),
        axes(figures),
        drives(figures, axes),
        motion(motion_config, figures, schemes, axes, drives),
        run(runs, log, motion, link.resets_wanted),
        spindles(figures, axes, drives, motion),
        process(figures, axes, motion, spindles, log),
        switches(spindles, run),
        marks(link.riders, *books.outputs) {}
  CycleParts(const CycleParts&) = delete;
  CycleParts& operator=(const CycleParts&) = delete;

  motion::MotionConfig motion_config;
  ChannelFigures figures;
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
