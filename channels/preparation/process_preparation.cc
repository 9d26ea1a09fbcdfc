#include "channels/preparation/process_preparation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "channels/contract/channel_description.h"
#include "channels/preparation/cutting_speed.h"
#include "channels/preparation/feed_law_choice.h"
#include "motion/segments/feed_law_stage.h"

namespace stanok::channels {
namespace {

Diagnostic standing_spindle() {
  Diagnostic d;
  d.code = "E4021";
  d.message = "feed per revolution needs a spindle that turns";
  d.help = {"program S and M3 or M4 first, or use feed per minute (G94)"};
  return d;
}

// A value that a law gives along its path: the feed, or the speed of the spindle.
using LawValue = double motion::LawStretch::*;

const char* unit_of_value(const motion::LawUnits& units, LawValue value) {
  if (value == &motion::LawStretch::feed) return units.per_revolution ? "mm/rev" : "mm/min";
  return units.speed == motion::LawSpeed::m_per_min ? "m/min" : "rev/min";
}

// Where a value of a law falls to zero within the increments of its first `path_mm`.
Diagnostic vanishing_value(const motion::FeedLaw& law, double path_mm, LawValue value) {
  std::uint64_t first = 0;
  std::uint64_t last = law.increments_at(path_mm);
  while (first < last) {
    const std::uint64_t middle = first + (last - first) / 2;
    if (law.stretch(middle).*value <= 0.0) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  const double place = law.stretch(std::max<std::uint64_t>(last, 1) - 1).end_mm;
  const bool is_feed = value == &motion::LawStretch::feed;
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(),
                "the %s reaches %.6g %s after %.6g mm of its path of %.6g mm",
                is_feed ? "feed law" : "speed of the law", law.stretch(last).*value,
                unit_of_value(law.units(), value), place, path_mm);
  Diagnostic d;
  d.code = "E5106";
  d.message = text.data();
  d.help = {is_feed ? "use a smaller `dS` or a longer `dl`, or end the law earlier"
                    : "use a smaller step of the speed or a longer `dl`, or end the law earlier"};
  return d;
}

}  // namespace

ProcessPreparation::ProcessPreparation(const MachineConfig& machine, const ChannelConfig& channel)
    : increment_mm_(channel_description(machine, channel).finest_resolution_mm) {
  for (const SpindleConfig& spindle : machine.spindles) {
    if (channel.spindles.empty() || spindle.id != channel.spindles.front()) continue;
    master_ = spindle.id;
    speed_min_ = spindle.speed_min;
    speed_max_ = spindle.speed_max;
  }
}

void ProcessPreparation::forget_laws() {
  take_law({});
  of_block_.reset();
  laws_.clear();
}

void ProcessPreparation::reset() {
  forget_laws();
  spindle_turns_ = false;
  cutting_speed_ = 0.0;
  speed_limit_ = 0.0;
}

void ProcessPreparation::take_state(const lang::Payload& command, double diameter_mm) {
  if (const auto* law = std::get_if<lang::FeedLawChange>(&command)) return take_law(*law);
  if (const auto* spindle = std::get_if<lang::SpindleCommand>(&command))
    return take_spindle(*spindle);
  const auto* const mode = std::get_if<lang::CuttingSpeedMode>(&command);
  if (mode != nullptr && is_master(mode->spindle)) {
    if (!mode->constant) spindle_rev_per_min_ = rev_per_min(diameter_mm);
    cutting_speed_ = mode->constant ? mode->speed_m_per_min : 0.0;
    speed_limit_ = mode->constant ? mode->limit_rev_per_min : 0.0;
  }
}

void ProcessPreparation::take_spindle(const lang::SpindleCommand& command) {
  if (!is_master(command.spindle)) return;
  using Action = lang::SpindleAction;
  if (command.action != Action::set_speed)
    spindle_turns_ =
        command.action == Action::clockwise || command.action == Action::counter_clockwise;
  spindle_rev_per_min_ = command.speed_rev_per_min;
  cutting_speed_ = command.cutting_speed_m_per_min;
}

void ProcessPreparation::take_law(const lang::FeedLawChange& change) {
  if (change.of_next_block) {
    of_block_ = change.law;
    return;
  }
  modal_ = change.law;
  modal_law_ = nullptr;
  modal_path_ = 0.0;
}

// The law for a block of this length; its pointer is empty where there is none.
Expected<ProcessPreparation::Law, Diagnostic> ProcessPreparation::law_of(double length) {
  const bool is_modal = !of_block_.has_value();
  if (is_modal && (modal_.kind == lang::FeedLaw::Kind::off || modal_law_ != nullptr))
    return Law{modal_law_, modal_path_, true};
  if (!is_modal && of_block_->kind == lang::FeedLaw::Kind::off) {
    of_block_.reset();
    return Law{};
  }
  auto made = make_feed_law(is_modal ? modal_ : *of_block_,
                            {.block_mm = is_modal ? 0.0 : length, .increment_mm = increment_mm_});
  of_block_.reset();
  if (!made) return Unexpected<Diagnostic>(made.error());
  laws_.push_back(std::move(*made));
  if (is_modal) modal_law_ = laws_.back().get();
  return Law{laws_.back().get(), 0.0, is_modal};
}

double ProcessPreparation::rev_per_min(double diameter_mm) const {
  return cutting_speed_ > 0.0 ? rev_per_min(cutting_speed_, diameter_mm) : spindle_rev_per_min_;
}

double ProcessPreparation::rev_per_min(double cutting_speed, double diameter_mm) const {
  return speed_of_cut({speed_min_, speed_max_, speed_limit_}, cutting_speed, diameter_mm);
}

std::optional<Diagnostic> ProcessPreparation::apply(const lang::Move& move, const Travel& travel,
                                                    motion::PathBlock& block) {
  if (block.rapid) return std::nullopt;
  constexpr double s_per_min = 60.0;
  if (move.feed_mode == lang::FeedMode::inverse_time) {
    block.feed_per_s = travel.length * move.feed / s_per_min;
    return std::nullopt;
  }
  const Expected<Law, Diagnostic> law =
      travel.in_mm && !move.is_tap ? law_of(travel.length) : Law{};
  if (!law) return law.error();
  const motion::LawUnits units{.per_revolution = move.feed_mode == lang::FeedMode::per_revolution};
  const bool law_per_revolution = law->law != nullptr && law->law->units().per_revolution;
  if (units.per_revolution || law_per_revolution) {
    block.process.rev_per_min = spindle_turns_ ? rev_per_min(travel.diameter_min_mm) : 0.0;
    if (block.process.rev_per_min <= 0.0) return standing_spindle();
  }
  block.feed_per_s = motion::feed_per_s(move.feed, units, block.process.rev_per_min);
  return law->law == nullptr ? std::nullopt : apply_law(*law, travel, block);
}

std::optional<Diagnostic> ProcessPreparation::apply_law(const Law& law, const Travel& travel,
                                                        motion::PathBlock& block) {
  const double path_stop = law.path_start + travel.length;
  const motion::LawStretch last = law.law->stretch(law.law->increments_at(path_stop));
  const double highest = law.law->highest_feed(path_stop);
  if (highest > 0.0 && last.feed <= 0.0)
    return vanishing_value(*law.law, path_stop, &motion::LawStretch::feed);
  const motion::LawUnits& units = law.law->units();
  if (units.speed != motion::LawSpeed::unchanged && last.speed <= 0.0)
    return vanishing_value(*law.law, path_stop, &motion::LawStretch::speed);
  if (units.speed == motion::LawSpeed::rev_per_min) {
    spindle_rev_per_min_ = last.speed;
    cutting_speed_ = 0.0;
  } else if (units.speed == motion::LawSpeed::m_per_min) {
    const double first = law.law->stretch(law.law->increments_at(law.path_start)).speed;
    cutting_speed_ = last.speed;
    if (block.process.rev_per_min > 0.0)
      block.process.rev_per_min = rev_per_min(std::max(first, last.speed), travel.diameter_min_mm);
  }
  motion::BlockProcess& process = block.process;
  process.law = law.law;
  process.path_start = law.path_start;
  process.path_length = travel.length;
  process.path_end = law.is_modal ? motion::unlimited : path_stop;
  if (highest > 0.0) block.feed_per_s = motion::feed_per_s(highest, units, process.rev_per_min);
  if (law.is_modal) modal_path_ = path_stop;
  return std::nullopt;
}

}  // namespace stanok::channels
