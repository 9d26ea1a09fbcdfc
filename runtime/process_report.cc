#include "runtime/process_report.h"

#include <algorithm>
#include <cmath>

namespace stanok::runtime {
namespace {

constexpr double settled_within = 0.02;
constexpr double same_depth = 0.002;
constexpr double follows_from = 0.98;  // of the feed asked for
constexpr double s_per_min = 60.0;

}  // namespace

void ProcessReport::open(bool is_entry, const plant::Stock::Cut& cut) {
  close();
  section_ = {.is_open = true, .is_entry = is_entry, .cut = cut};
}

void ProcessReport::close() {
  if (!section_.is_open) return;
  section_.is_open = false;
  if (section_.turns < 1.0) return;
  if (section_.error_count > 0) {
    const double mean = section_.error_sum / static_cast<double>(section_.error_count);
    steady_error_max_ = std::max(steady_error_max_, std::abs(mean));
  }
  if (section_.is_entry) return;
  settling_s_.push_back(section_.unsettled_s);
  overshoot_max_ = std::max(overshoot_max_, section_.overshoot);
}

void ProcessReport::finish() {
  close();
}

void ProcessReport::add(const channels::ChannelOutput& channel, double force_n,
                        const plant::Stock::Cut& cut) {
  const motion::ForceStatus& control = channel.process.force;
  const bool is_cutting =
      control.state == motion::ForceState::regulating && control.force_set_n > 0.0;
  if (!is_cutting || cut.depth_mm <= 0.0) return close();
  has_any_ = true;
  Section& section = section_;
  if (!section.is_open) {
    open(true, cut);
  } else if (std::abs(cut.depth_mm - section.cut.depth_mm) > same_depth * section.cut.depth_mm ||
             cut.hardness_hb != section.cut.hardness_hb) {
    open(false, cut);
  }
  if (channel.path_speed < follows_from * channel.feed_override * control.feed_per_s) return;
  section.time_s += cycle_s_;
  section.turns += std::abs(channel.process.spindle_rev_per_min) / s_per_min * cycle_s_;
  const double error = force_n / control.force_set_n - 1.0;
  if (std::abs(error) > settled_within) {
    section.unsettled_s = section.time_s;
    section.error_sum = 0.0;
    section.error_count = 0;
  } else {
    section.error_sum += error;
    ++section.error_count;
  }
  if (section.first_error == 0.0) section.first_error = error;
  if (error * section.first_error < 0.0)
    section.overshoot = std::max(section.overshoot, std::abs(error));
}

}  // namespace stanok::runtime
