// Load, run and reset of one channel, as the cycle sees them.
#include "channels/cycle/channel.h"

namespace stanok::channels {

void Channel::begin_load(const ShortText& text, Job job) RT_SAFE {
  load_ = Outcome::pending;
  loading_ = job;
  Notice notice;
  notice.kind = job == Job::line ? NoticeKind::load_line : NoticeKind::load;
  notice.load = program_load_;
  if (job == Job::program) notice.number = ++loads_;
  notice.text = ReasonText(text.view());
  static_cast<void>(link_.notices.push(notice));
}

void Channel::begin_search(const ShortText& target, bool calculates, double pass) RT_SAFE {
  load_ = Outcome::pending;
  loading_ = Job::search;
  Notice notice = notice_of_start(NoticeKind::search);
  notice.text = ReasonText(target.view());
  notice.ok = calculates;
  notice.value = pass;
  static_cast<void>(link_.notices.push(notice));
}

Notice Channel::notice_of_start(NoticeKind kind) const RT_SAFE {
  Notice notice;
  notice.kind = kind;
  notice.run = run_;
  notice.load = program_load_;
  notice.number = scheme_;
  notice.block_skip = block_skip_;
  notice.axes_M = axes_M();
  return notice;
}

void Channel::begin_run(Job job) RT_SAFE {
  ++run_;
  program_ = {};
  run_before_ok_ = run_ok_;
  running_ = true;
  run_ok_ = false;
  was_reset_ = false;
  if (job == Job::program) {
    marks_.clear_marks();
    open_position_loops();
    restart_automatic_feeds();
  }
  state_ = ChannelState::running;
  stepper_.begin(run_);
  control_.hold = false;
  start_cycle_ = cycle_;
  path_mm_ = 0.0;
  lookahead_max_ = 0;
  blocks_ = 0;
  const NoticeKind kind = job == Job::line ? NoticeKind::start_line : NoticeKind::start;
  static_cast<void>(link_.notices.push(notice_of_start(kind)));
  static_cast<void>(books_.reports->run_records().push(run_record()));
}

RunRecord Channel::run_record() const RT_SAFE {
  RunRecord record;
  record.channel = figures_.id;
  record.run = run_;
  record.start_cycle = start_cycle_;
  record.end_cycle = cycle_;
  record.path_mm = path_mm_;
  record.lookahead_max_blocks = lookahead_max_;
  record.blocks = blocks_;
  record.axis_count = figures_.axis_count;
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    record.end_W[k] = path_.point[k].value;
    record.end_M[k] = path_.axes[k].value;
  }
  return record;
}

void Channel::end_run(bool ok, std::uint64_t blocks) RT_SAFE {
  if (!running_) return;
  end_effects();
  close_run(ok, blocks);
}

// What programs and lines brought about is over with a program, and with a reset.
void Channel::end_effects() RT_SAFE {
  take_overrides({});
  interrupt_feed({});
  static_cast<void>(order_force(motion::ForceOrder{}));
  for (Spindle& spindle : spindles_) spindle.stop();
  open_position_loops();
}

// The end of a line leaves spindles and overrides as they are.
void Channel::close_run(bool ok, std::uint64_t blocks) RT_SAFE {
  running_ = false;
  run_ok_ = ok;
  end_cycle_ = cycle_;
  hold_wanted_ = false;
  control_.hold = false;
  state_ = has_program_ ? ChannelState::ready : ChannelState::idle;
  RunRecord record = run_record();
  record.ended = true;
  record.ok = ok;
  record.blocks = blocks;
  record.end_cycle = cycle_;
  static_cast<void>(books_.reports->run_records().push(record));
}

void Channel::begin_reset() RT_SAFE {
  ++generation_;
  alarm_stays_ = false;
  manual_.stop();
  if (resetting_) return;
  resetting_ = true;
  reset_sent_ = false;
  link_.resets_wanted.fetch_add(1, std::memory_order_relaxed);
  control_.hold = true;
  control_.leaves_thread = true;
}

void Channel::begin_stop() RT_SAFE {
  const bool alarm_stood = alarm_stays_ || state_ == ChannelState::alarm;
  begin_reset();
  alarm_stays_ = alarm_stood;
}

// First to rest along the path, then the preparation is told to forget, then what it had pushed is
// dropped.
void Channel::continue_reset() RT_SAFE {
  if (!is_standing()) return;
  if (!reset_sent_) {
    Notice notice;
    notice.kind = NoticeKind::reset;
    reset_sent_ = link_.notices.push(notice);
    activity_ = Activity::none;
    asks_ = false;
    return;
  }
  Item item;
  while (link_.items.pop(item)) {
    if (item.kind != ItemKind::reset_done) continue;
    forget_arrivals();
    probe_ = {};
    end_effects();
    if (running_) close_run(false, blocks_);
    resetting_ = false;
    was_reset_ = true;
    control_.hold = false;
    control_.leaves_thread = false;
    load_ = load_ == Outcome::pending ? Outcome::failed : load_;
    if (is_switching()) end_switch();
    state_ = has_program_ ? ChannelState::ready : ChannelState::idle;
    if (alarm_stays_) state_ = ChannelState::alarm;
    alarm_stays_ = false;
    transform_ = {};
    transform_.scheme = find_scheme(scheme_);
    stand_in_frame();
    return;
  }
}

bool Channel::has_prepared(const Arrivals& recorded) const {
  if (recorded.resets > arrivals_.resets) return true;  // what it saw is counted from there on
  return link_.path.chunks.pushed() - forgotten_.chunks >= recorded.chunks &&
         link_.items.pushed() - forgotten_.items >= recorded.items &&
         link_.riders.pushed() - forgotten_.riders >= recorded.riders &&
         link_.remarks.pushed() - forgotten_.remarks >= recorded.remarks;
}

void Channel::see_arrivals(const Arrivals& recorded) RT_SAFE {
  const bool resets = recorded.resets > arrivals_.resets;
  link_.show({.resets = 0,
              .chunks = forgotten_.chunks + (resets ? Arrivals::everything : recorded.chunks),
              .items = forgotten_.items + (resets ? Arrivals::everything : recorded.items),
              .riders = forgotten_.riders + (resets ? Arrivals::everything : recorded.riders),
              .remarks = forgotten_.remarks + (resets ? Arrivals::everything : recorded.remarks)});
  const Arrivals shown = link_.shown();
  arrivals_.chunks = shown.chunks - forgotten_.chunks;
  arrivals_.items = shown.items - forgotten_.items;
  arrivals_.riders = shown.riders - forgotten_.riders;
  arrivals_.remarks = shown.remarks - forgotten_.remarks;
}

// Behind the item that says that a reset is over the preparation has made nothing but items; all
// else that it made is of before.
void Channel::forget_arrivals() RT_SAFE {
  const std::uint64_t items = link_.items.popped();
  link_.show({.resets = 0,
              .chunks = Arrivals::everything,
              .items = link_.items.shown(),
              .riders = Arrivals::everything,
              .remarks = Arrivals::everything});
  interpolator_.drop_path(link_.path);
  marks_.forget_riders();
  link_.remarks.pop_front(link_.remarks.size());
  forgotten_ = link_.shown();
  forgotten_.items = items;
  arrivals_ = {.resets = arrivals_.resets + 1, .chunks = 0, .items = link_.items.size()};
}

}  // namespace stanok::channels
