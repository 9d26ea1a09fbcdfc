#include "jobs/cutting/force_forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <variant>

#include "base/place.h"
#include "jobs/cutting/program_text.h"
#include "jobs/dry_run/dry_run.h"
#include "plant/cutting/stock.h"
#include "runtime/program_files.h"

namespace stanok::jobs {
namespace {

constexpr double place_step_mm = 0.02;
constexpr double min_part = 0.05;  // of the programmed feed
constexpr double s_per_min = 60.0;

struct ToolPlace {
  double x_mm = 0.0;
  double z_mm = 0.0;
};

// A straight block at feed.
struct FeedBlock {
  std::uint32_t line = 0;
  ToolPlace begin;
  ToolPlace end;
  double feed_per_rev = 0.0;
  double rev_per_min = 0.0;
  bool is_per_revolution = false;
};

plant::Stock stock_of(const config::CuttingConfig& cutting) {
  if (cutting.stock.empty())
    throw std::runtime_error(
        "the machine file has no workpiece; give [[simulation.cutting.stock]]");
  return plant::Stock(cutting.stock);
}

class ForecastRun {
 public:
  explicit ForecastRun(const ForecastRequest& request)
      : request_(request),
        cutting_(request.job.machine.simulation.cutting),
        stock_(stock_of(cutting_)),
        model_{.coefficient_n = cutting_.specific_force_n, .exponent = cutting_.feed_exponent},
        text_(request.job.text) {}

  ForceForecast run() {
    const ForecastJob& job = request_.job;
    const runtime::ProgramFiles files(job.program_roots,
                                      runtime::program_format(job.machine.machine));
    DryRun dry_run(job.machine.machine, job.channel, job.scheme(), files);
    find_axes(dry_run.channel());
    const auto take = [&](const lang::Command& command, const motion::PathBlock* block) {
      follow(command, block);
    };
    const auto result = dry_run.run(job.program, Reachability::unchecked, take,
                                    [](const lang::ProgramRequest&, const lang::Command&) {},
                                    {.gives_up = job.gives_up});
    for (const Diagnostic& diagnostic : result.diagnostics) job.tell(diagnostic);
    if (has_errors(result.diagnostics)) throw std::runtime_error(job.program + " has errors");
    if (job.gives_up()) throw std::runtime_error(job.program + " was not followed to its end");
    for (const auto& [line, feed] : kept_) forecast_.lines[line] = {{.words = "", .feed = feed}};
    return std::move(forecast_);
  }

 private:
  void find_axes(const channels::ChannelConfig& channel) {
    const auto place = [&](const char* word) {
      const auto found = std::ranges::find(channel.words, word);
      if (found == channel.words.end())
        throw std::runtime_error("the channel has no axis " + std::string(word));
      return checked_size(found - channel.words.begin());
    };
    x_ = place("X");
    z_ = place("Z");
  }

  void follow(const lang::Command& command, const motion::PathBlock* block) {
    if (const auto* const spindle = std::get_if<lang::SpindleCommand>(&command.payload)) {
      if (spindle->spindle == 0) rev_per_min_ = spindle->speed_rev_per_min;
      return;
    }
    const auto* const move = std::get_if<lang::Move>(&command.payload);
    if (move == nullptr || block == nullptr) return;
    const ToolPlace end{.x_mm = block->end[x_], .z_mm = block->end[z_]};
    const bool is_straight = move->kind == lang::MoveKind::line && is_placed_ &&
                             command.origin.file == 0 && rev_per_min_ > 0.0 &&
                             move->feed_mode != lang::FeedMode::inverse_time;
    if (is_straight) {
      const bool is_per_revolution = move->feed_mode == lang::FeedMode::per_revolution;
      feed({.line = command.origin.line,
            .begin = at_,
            .end = end,
            .feed_per_rev = is_per_revolution ? move->feed : move->feed / rev_per_min_,
            .rev_per_min = rev_per_min_,
            .is_per_revolution = is_per_revolution});
    } else {
      static_cast<void>(stock_.move_tool(end.x_mm, end.z_mm));
      keep_feed(command, *move);
    }
    at_ = end;
    is_placed_ = true;
  }

  // F of the program, said in the block itself: what was before it has another one now.
  void keep_feed(const lang::Command& command, const lang::Move& move) {
    const bool has_feed = move.kind != lang::MoveKind::rapid && command.origin.file == 0 &&
                          move.feed_mode != lang::FeedMode::inverse_time;
    if (has_feed) kept_[command.origin.line] = fmt::format("F{:g}", move.feed);
  }

  void feed(const FeedBlock& block) {
    const double length =
        std::hypot(block.end.x_mm - block.begin.x_mm, block.end.z_mm - block.begin.z_mm);
    if (length <= 0.0) return;
    const auto count = std::max<std::size_t>(1, checked_size(std::ceil(length / place_step_mm)));
    std::vector<CutPlace> cuts;
    const std::size_t first = forecast_.places.size();
    if (first + count > request_.job.places_max)
      throw std::runtime_error(request_.job.program + " has a longer path than is followed here");
    for (std::size_t k = 0; k < count; ++k) {
      // What the tool meets up to the end of the step.
      const double part = static_cast<double>(k + 1) / static_cast<double>(count);
      const ToolPlace place{.x_mm = block.begin.x_mm + part * (block.end.x_mm - block.begin.x_mm),
                            .z_mm = block.begin.z_mm + part * (block.end.z_mm - block.begin.z_mm)};
      const plant::Stock::Cut cut = stock_.move_tool(place.x_mm, place.z_mm);
      const double along = length * static_cast<double>(k) / static_cast<double>(count);
      const double factor = cut.hardness_hb > 0.0 ? std::pow(cut.hardness_hb / cutting_.hardness_hb,
                                                             cutting_.hardness_exponent)
                                                  : 1.0;
      cuts.push_back({.distance_mm = along, .depth_mm = cut.depth_mm, .factor = factor});
      forecast_.places.push_back(
          {.line = block.line,
           .path_mm = path_mm_ + along,
           .x_mm = place.x_mm,
           .z_mm = place.z_mm,
           .depth_mm = cut.depth_mm,
           .rev_per_min = block.rev_per_min,
           .feed_programmed = block.feed_per_rev,
           .force_programmed_n = model_.force_n(cut.depth_mm, factor, block.feed_per_rev)});
    }
    path_mm_ += length;
    plan(block, length, cuts, first);
  }

  void plan(const FeedBlock& block, double length, const std::vector<CutPlace>& cuts,
            std::size_t first) {
    constexpr double step_per_rev = 0.001;
    constexpr double step_per_minute = 0.1;
    const FeedLimits limits{
        .min = request_.feed_min > 0.0 ? request_.feed_min : min_part * block.feed_per_rev,
        .max = request_.feed_max > 0.0 ? request_.feed_max : block.feed_per_rev,
        .step = block.is_per_revolution ? step_per_rev : step_per_minute / block.rev_per_min};
    std::vector<FeedStretch> stretches = request_.force_n > 0.0
                                             ? plan_feeds(cuts, model_, request_.force_n, limits)
                                             : std::vector<FeedStretch>{{0.0, block.feed_per_rev}};
    if (stretches.size() > 1 && !is_divisible(block)) {
      const double least = std::ranges::min(stretches, {}, &FeedStretch::feed_per_rev).feed_per_rev;
      stretches = {{0.0, least}};
    }
    if (!planned_.insert(block.line).second)
      kept_[block.line] = feed_word(block, block.feed_per_rev);
    std::vector<FedPoint>& points = forecast_.lines[block.line];
    points.clear();
    const double turns_per_s = block.rev_per_min / s_per_min;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      const double feed = stretches[k].feed_per_rev;
      const bool is_last = k + 1 == stretches.size();
      const double end_mm = is_last ? length : stretches[k + 1].begin_mm;
      forecast_.time_s += (end_mm - stretches[k].begin_mm) / (feed * turns_per_s);
      points.push_back({.words = is_last ? "" : words_at(block, end_mm / length),
                        .feed = feed_word(block, feed)});
    }
    forecast_.time_programmed_s += length / (block.feed_per_rev * turns_per_s);
    std::size_t stretch = 0;
    constexpr double m_per_mm = 1e-3;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      while (stretch + 1 < stretches.size() &&
             stretches[stretch + 1].begin_mm <= cuts[k].distance_mm)
        ++stretch;
      ForcePlace& place = forecast_.places[first + k];
      place.feed = stretches[stretch].feed_per_rev;
      place.force_n = model_.force_n(cuts[k].depth_mm, cuts[k].factor, place.feed);
      place.power_w = place.force_n * 2.0 * std::numbers::pi * turns_per_s * std::abs(place.x_mm) *
                      m_per_mm / cutting_.efficiency;
      if (request_.stiffness_n_per_um > 0.0)
        place.deflection_um = place.force_n / request_.stiffness_n_per_um;
    }
  }

  // A block along Z whose Z is programmed as it is in the frame of the stock can be divided.
  [[nodiscard]] bool is_divisible(const FeedBlock& block) const {
    constexpr double same_mm = 1e-6;
    const std::string* const line = text_.line(block.line);
    if (line == nullptr || block.end.x_mm != block.begin.x_mm) return false;
    const auto z = ProgramText::value(*line, 'Z');
    return z && std::abs(*z - block.end.z_mm) < same_mm;
  }
  static std::string words_at(const FeedBlock& block, double part) {
    return fmt::format("Z{:.4f}", block.begin.z_mm + part * (block.end.z_mm - block.begin.z_mm));
  }
  static std::string feed_word(const FeedBlock& block, double feed_per_rev) {
    return block.is_per_revolution ? fmt::format("F{:.3f}", feed_per_rev)
                                   : fmt::format("F{:.1f}", feed_per_rev * block.rev_per_min);
  }

  const ForecastRequest& request_;
  const config::CuttingConfig& cutting_;
  plant::Stock stock_;
  ForceModel model_;
  std::size_t x_ = 0;
  std::size_t z_ = 0;
  ToolPlace at_;
  bool is_placed_ = false;
  double rev_per_min_ = 0.0;
  double path_mm_ = 0.0;
  ProgramText text_;
  std::set<std::uint32_t> planned_;
  std::map<std::uint32_t, std::string> kept_;  // F of blocks that keep it
  ForceForecast forecast_;
};

}  // namespace

ForceForecast forecast_forces(const ForecastRequest& request) {
  return ForecastRun(request).run();
}

}  // namespace stanok::jobs
