#include "runtime/workpiece/live_workpieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "base/batch_thread.h"
#include "simulation/surface_mesh.h"

namespace stanok::runtime {
namespace {

using simulation::Sample;

// Nothing has happened that the material could tell.
bool is_as_before(const Sample& a, const Sample& b) {
  return a.axes_M == b.axes_M && a.scheme == b.scheme && a.tool == b.tool && a.edge == b.edge &&
         a.spindle_turns == b.spindle_turns && a.origin == b.origin;
}

}  // namespace

LiveWorkpieces::LiveWorkpieces(const channels::MachineConfig& machine, ComplaintTaker complain)
    : cycle_s_(machine.cycle_us * 1e-6), complain_(std::move(complain)) {
  for (const channels::ChannelConfig& channel : machine.channels) {
    const auto on_complaint = [this, id = channel.id](const std::string& code,
                                                      const std::string& text) {
      complain_(fmt::format("live workpiece of channel {}: {}: {}", id, code, text));
    };
    if (channel.axes.empty()) continue;
    Seat& seat = seats_.emplace_back();
    seat.channel = channel.id;
    seat.feed = std::make_unique<ChannelFeed>(machine, channel, memory_max, on_complaint);
    seat.feed->take_what_fits();
  }
  thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

LiveWorkpieces::~LiveWorkpieces() {
  end_batch_thread(thread_);
}

// Blocks are not told apart: a machine that runs for ever has ever more of them.
void LiveWorkpieces::observe(const channels::CycleOutput& output) {
  for (std::size_t k = 0; k < seats_.size(); ++k) {
    Seat& seat = seats_[k];
    const channels::ChannelOutput* channel = output.of_channel(seat.channel);
    if (channel == nullptr || channel->workpiece.announcements == 0) continue;
    Step step{k, sample_of(*channel, static_cast<double>(output.cycle) * cycle_s_),
              channel->tool_row, channel->workpiece};
    step.sample.origin = {.channel = seat.channel, .run = channel->tag.run};
    const bool is_news = step.workpiece.announcements != seat.last.workpiece.announcements ||
                         !(step.tool == seat.last.tool);
    if (!is_news && is_as_before(step.sample, seat.last.sample)) continue;
    if (steps_.push(step)) {
      seat.last = step;
    } else {
      left_out_.fetch_add(1, std::memory_order_relaxed);
    }
  }
}

void LiveWorkpieces::work(const std::stop_token& stop) {
  constexpr auto pause = std::chrono::milliseconds(20);
  run_as_batch(stop);
  try {
    while (!stop.stop_requested()) {
      if (!cut_some()) std::this_thread::sleep_for(pause);
    }
  } catch (const std::exception& error) {
    give_up(error.what());
  } catch (...) {
    give_up("an exception without a text");
  }
}

// Memory above all. The machine does without the picture, and where nothing can be told, without a
// word about it.
void LiveWorkpieces::give_up(std::string_view reason) {
  const std::lock_guard lock(mutex_);
  for (Seat& seat : seats_) seat.workpiece = nullptr;
  try {
    complain_("live workpieces have stopped: " + std::string(reason));
  } catch (...) {
    return;
  }
}

// False: there was nothing to do.
bool LiveWorkpieces::cut_some() {
  constexpr int at_once = 256;  // who asks for a page waits that long
  if (steps_.empty()) return false;
  const std::lock_guard lock(mutex_);
  Step step;
  for (int k = 0; k < at_once && steps_.pop(step); ++k) cut(step);
  return true;
}

void LiveWorkpieces::cut(const Step& step) {
  Seat& seat = seats_[step.seat];
  seat.feed->take(step.sample, step.tool, step.workpiece);
  if (seat.shapes == step.workpiece.shapes) return;
  seat.shapes = step.workpiece.shapes;
  seat.workpiece = seat.feed->follower().at_work();
  if (seat.workpiece != nullptr) seat.workpiece->mark_cuts();
  seat.feed->follower().forget_former();
}

std::optional<SurfacePage> LiveWorkpieces::page(int channel, const SurfaceRequest& request) {
  const std::lock_guard lock(mutex_);
  const auto seat = std::ranges::find(seats_, channel, &Seat::channel);
  if (seat == seats_.end() || seat->workpiece == nullptr) return std::nullopt;
  simulation::Workpiece& workpiece = *seat->workpiece;
  simulation::CutMarks& marks = *workpiece.marks();
  simulation::WorkpieceFollower& follower = seat->feed->follower();
  if (request.from == 0) follower.flush();
  SurfacePage page{.workpiece = seat->shapes,
                   .version = marks.close_version(),
                   .scheme = follower.home(),
                   .in_base = follower.program_in_base(),
                   .blank = workpiece.blank(),
                   .bricks = {},
                   .corners = {},
                   .next = {},
                   .cycles_left_out = left_out_.load(std::memory_order_relaxed)};
  const bool is_same = request.workpiece == seat->shapes;
  const std::uint32_t since = is_same ? request.since : 0;
  for (std::size_t brick = is_same ? request.from : 0; brick < marks.bricks(); ++brick) {
    if (marks.changed(brick) <= since) continue;
    if (page.corners.size() >= page_corners) {
      page.next = brick;
      break;
    }
    add_brick(workpiece, brick, page);
    // Who has nothing yet need not be told of nothing.
    if (since == 0 && page.bricks.back().first == page.bricks.back().behind) page.bricks.pop_back();
  }
  return page;
}

void LiveWorkpieces::add_brick(const simulation::Workpiece& workpiece, std::size_t brick,
                               SurfacePage& page) {
  const auto cubes = workpiece.material().marks()->cubes_of(brick);
  const simulation::Patch patch = simulation::patch_of(workpiece.material(), cubes);
  const Eigen::Vector3f zero = workpiece.blank().zero.cast<float>();
  const std::size_t first = page.corners.size();
  for (const auto& triangle : patch.mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      const Eigen::Vector3f at = patch.mesh.points[corner] - zero;
      page.corners.push_back({{at.x(), at.y(), at.z()}, patch.tools[corner]});
    }
  }
  page.bricks.push_back({brick, first, page.corners.size()});
}

}  // namespace stanok::runtime
