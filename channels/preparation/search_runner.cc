#include "channels/preparation/search_runner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/place.h"
#include "channels/preparation/search_sink.h"

namespace stanok::channels {
namespace {

Diagnostic no_such_target(const std::string& text) {
  Diagnostic diagnostic;
  diagnostic.code = "E6040";
  diagnostic.message = "`" + text + "` names no block";
  diagnostic.help = {"give a line (120) or a block number (N40); in another file: sub.nc:120"};
  return diagnostic;
}

// The axis along which a tool comes to the workpiece: Z of mills, X of lathes; -1: none.
int infeed_axis(const std::array<int, 3>& geometry) {
  return geometry[1] >= 0 ? geometry[2] : geometry[0];
}

// Of the way down: that of the last move at feed.
double plunge_feed(const ProgramSearch& search) {
  constexpr double cautious_mm_min = 100.0;
  return search.feed_mm_min > 0.0 ? search.feed_mm_min : cautious_mm_min;
}

motion::Point straight_out(int infeed) {
  motion::Point way{};
  if (infeed >= 0) way[infeed] = 1.0;
  return way;
}

double distance(const motion::Point& from, const motion::Point& to,
                const std::array<int, 3>& geometry) {
  double square = 0.0;
  for (const int k : geometry)
    if (k >= 0) square += (to[k] - from[k]) * (to[k] - from[k]);
  return std::sqrt(square);
}

}  // namespace

SearchRunner::Result SearchRunner::look(const BlockSearch& search,
                                        std::shared_ptr<const lang::Program> program) {
  const std::string text(search.target.view());
  forget();
  auto target = lang::search_target(text);
  if (!target) return fail(no_such_target(text));
  target->passes = search.passes;
  const auto place = lang::find_place(*program, *target);
  if (!place) return fail(place.error());
  static_cast<void>(parts_.interpreter.take_meanings());  // of a run before
  search_.emplace();
  search_->place = *place;
  situation_ = search.start.stand.situation;
  search_->calculates = search.way == SearchWay::calculated;
  parts_.set_program(std::move(program));
  parts_.restart(search.start.stand);
  parts_.feed.blocks().forget_laws();
  parts_.interpreter.set_block_skip(search.start.block_skip);
  const Result result = enter(ProgramSearch::Stage::look);
  return result == Result::entered ? arrive() : result;
}

SearchRunner::Result SearchRunner::begin_run() {
  const Result result = enter(ProgramSearch::Stage::run);
  if (result == Result::entered) forget();
  return result;
}

SearchRunner::Result SearchRunner::enter(ProgramSearch::Stage stage) {
  const motion::Point position_B = parts_.feed.blocks().position_B();
  search_->stage = stage;
  search_->collector = {};
  search_->height = {};
  search_->feed_mm_min = 0.0;
  search_->axes_M = parts_.feed.blocks().axes_M();
  search_->scheme = parts_.scheme;
  parts_.feed.forget_threads();
  if (search_->calculates) {
    parts_.interpreter.start_search(parts_.program, position_B, search_->place);
    return Result::working;
  }
  if (const auto fault = parts_.interpreter.start_at(parts_.program, position_B, search_->place))
    return fail(*fault);
  return Result::entered;
}

SearchRunner::Result SearchRunner::advance(int commands) {
  for (int n = 0; n < commands; ++n) {
    switch (parts_.interpreter.next(parts_.command)) {
      case lang::Step::command:
        if (const auto fault = pass(parts_.command)) return fail(*fault);
        break;
      case lang::Step::working:
        return Result::computing;
      case lang::Step::waiting:
        break;  // its request was answered when it came
      case lang::Step::stopped:
        return arrive();
      case lang::Step::ended:
        return fail(lang::ended_before(*parts_.program, search_->place));
      case lang::Step::failed:
        return fail(parts_.interpreter.error());
    }
  }
  return Result::working;
}

void SearchRunner::forget() {
  search_.reset();
  parts_.reports.tell_search(parts_.config.id, std::nullopt);
}

SearchRunner::Result SearchRunner::fail(const Diagnostic& fault) {
  const bool belongs_to_run = search_ && search_->stage == ProgramSearch::Stage::run;
  fault_ = fault;
  forget();
  return belongs_to_run ? Result::run_failed : Result::failed;
}

// At the target: an operator is told, or the run begins.
SearchRunner::Result SearchRunner::arrive() {
  if (const auto obstacle = obstacle_at_target()) return fail(*obstacle);
  const motion::Point target = parts_.feed.blocks().position_W();
  parts_.feed.blocks().stand_at(search_->axes_M);
  if (search_->stage == ProgramSearch::Stage::run) {
    approach(target);
    return Result::entered;
  }
  search_->stage = ProgramSearch::Stage::found;
  parts_.reports.tell_search(parts_.config.id, report(target));
  return Result::found;
}

SearchReport SearchRunner::report(const motion::Point& target) {
  SearchReport report;
  report.file = lang::file_name(*parts_.program, search_->place.file);
  report.line = search_->place.line;
  report.words = parts_.config.words;
  report.number = ++searches_;
  report.situation = situation_;
  // The last one is that of the target; its start notes one at least.
  for (lang::MeaningChange& change : parts_.interpreter.take_meanings())
    report.meaning = std::move(change.meaning);
  const auto count = static_cast<std::ptrdiff_t>(report.words.size());
  const auto values_of = [&](const auto& values) {
    return std::vector<double>(values.begin(), values.begin() + count);
  };
  const auto words_of = [&](const motion::Point& point) {
    return values_of(lang::words_at(report.meaning, {point}));
  };
  const motion::Point& now_W = parts_.feed.blocks().position_W();
  report.axes_M = values_of(search_->axes_M);
  report.stands_at = words_of(now_W);
  report.state = search_->collector.state();
  if (!search_->calculates) return report;
  report.position = words_of(target);
  report.point_W = values_of(target);
  report.plunge_feed_mm_min = plunge_feed(*search_);
  const Approach approach = approach_to_target(target);
  motion::Point before = now_W;
  const auto add = [&](SearchReport::Leg::Kind kind, const std::optional<motion::Point>& end) {
    if (!end) return;
    report.approach.push_back(
        {kind, words_of(*end), distance(before, *end, parts_.feed.blocks().geometry())});
    before = *end;
  };
  add(SearchReport::Leg::Kind::lift, approach.lift);
  add(SearchReport::Leg::Kind::lateral, approach.lateral);
  add(SearchReport::Leg::Kind::plunge, approach.plunge);
  return report;
}

std::optional<Diagnostic> SearchRunner::obstacle_at_target() const {
  Diagnostic diagnostic;
  diagnostic.place.file = lang::file_name(*parts_.program, search_->place.file);
  diagnostic.place.line = static_cast<int>(search_->place.line);
  if (search_->scheme != parts_.scheme) {
    const std::string scheme = std::to_string(search_->scheme->config().id);
    diagnostic.code = "E6043";
    diagnostic.message = "at the target the channel has kinematic scheme " + scheme +
                         ", but at present it has " + std::to_string(parts_.scheme->config().id);
    diagnostic.help = {
        "stanok kinematics select " + scheme +
        ", then begin after the switch without calculation; or begin before the switch"};
    return diagnostic;
  }
  const auto& converted = search_->collector.state().spindles_as_axes;
  if (!converted.empty()) {
    diagnostic.code = "E6044";
    diagnostic.message =
        "at the target, spindle " + std::to_string(*converted.begin()) + " is an axis";
    diagnostic.help = {"begin before its M902 or after its M903"};
    return diagnostic;
  }
  return std::nullopt;
}

// The position follows the program; nothing becomes a path.
std::optional<Diagnostic> SearchRunner::pass(const lang::Command& command) {
  SearchSink sink(search_->collector);
  const motion::Point start_W = parts_.feed.blocks().position_W();
  const auto taken = parts_.feed.pass(command, sink);
  if (!taken) return taken.error();
  note_motion(command, start_W);
  if (const auto* request = std::get_if<lang::ProgramRequest>(&command.payload))
    return pass_request(command, *request);
  return std::nullopt;
}

void SearchRunner::note_motion(const lang::Command& command, const motion::Point& start_W) {
  const BlockPreparation& blocks = parts_.feed.blocks();
  const std::array<int, 3> geometry = blocks.geometry();
  const kinematics::Frame& frame = blocks.transform().frame;
  SkippedHeight& height = search_->height;
  if (std::holds_alternative<lang::ToolChange>(command.payload)) return height.forget();
  const auto* move = std::get_if<lang::Move>(&command.payload);
  const auto* spline = std::get_if<lang::SplineMove>(&command.payload);
  if (move != nullptr && move->kind != lang::MoveKind::rapid &&
      move->feed_mode == lang::FeedMode::per_minute)
    search_->feed_mm_min = move->feed;
  if (move != nullptr && move->kind == lang::MoveKind::arc)
    height.pass(*move, start_W, frame, geometry);
  if (spline != nullptr) height.pass(*spline, start_W, frame, geometry);
  if (axes_apart(start_W, blocks.position_W()) != 0) height.pass(blocks.position_B(), geometry);
}

std::optional<Diagnostic> SearchRunner::pass_request(const lang::Command& command,
                                                     const lang::ProgramRequest& request) {
  auto answer = answer_of_tables(request);
  if (!answer) answer = search_->collector.answer(request);
  if (!answer) return lang::answer_is_unknown(*parts_.program, command.origin);
  const bool own =
      request.kind == lang::RequestKind::kinematics && request.channel == parts_.config.id;
  if (own && parts_.schemes.contains(request.number)) {
    search_->scheme = parts_.schemes.at(request.number).get();
    parts_.feed.pass_switch(*search_->scheme);
    parts_.tables.set_scheme(*search_->scheme);
  }
  answer->position_B = parts_.feed.blocks().position_B();
  answer->position_valid = true;
  parts_.interpreter.answer(*answer);
  return std::nullopt;
}

// Tables are read as they were when the search began; nothing: this is no question to them.
std::optional<lang::Answer> SearchRunner::answer_of_tables(
    const lang::ProgramRequest& request) const {
  std::optional<double> value;
  if (request.kind == lang::RequestKind::tool_table_read) {
    value = parts_.tables.view().tool_value(request.number, request.index, request.channel);
  } else if (request.kind == lang::RequestKind::offset_table_read) {
    const int axis =
        request.index >= 0 ? parts_.config.axes.at(checked_size(request.index)) : request.index;
    value = parts_.tables.view().offset(request.number, axis);
  }
  if (!value) return std::nullopt;
  lang::Answer answer;
  answer.number = *value;
  return answer;
}

// From where the axes stand. Where nothing was skipped that tells a height, that of the scheme for
// parking is one, or the end of the axis.
Approach SearchRunner::approach_to_target(const motion::Point& target) const {
  const BlockPreparation& blocks = parts_.feed.blocks();
  const kinematics::Frame& frame = blocks.transform().frame;
  const std::array<int, 3> geometry = blocks.geometry();
  const int infeed = infeed_axis(geometry);
  const motion::Point& start = blocks.position_W();
  auto height = search_->height.along(infeed, frame, geometry);
  if (!height && infeed >= 0) {
    const double end = parts_.motion.axes[infeed].position_max;
    const auto& retract = parts_.scheme->config().retract;
    const auto parking =
        std::ranges::find(retract, infeed, [](const auto& one) { return one.first; });
    const double safe_M = parking == retract.end() ? end : parking->second;
    motion::Point axes_M = search_->axes_M;
    if (std::isfinite(safe_M) && safe_M < motion::unlimited) {
      axes_M[infeed] = std::max(axes_M[infeed], safe_M);
      SkippedHeight top;
      top.pass(blocks.base_of(axes_M), geometry);
      height = top.along(infeed, frame, geometry);
    }
  }
  const double top = height.value_or(start[std::max(infeed, 0)]);
  const WayOut straight{infeed, straight_out(infeed), straight_out(infeed)};
  if (infeed < 0) return approach_to(target, start, straight, top);
  const WayOut along_tool{infeed, out_along_tool(start, infeed), out_along_tool(target, infeed)};
  const Approach approach = approach_to(target, start, along_tool, top);
  const bool fits = is_within_travel(approach.lift) && is_within_travel(approach.lateral);
  return fits ? approach : approach_to(target, start, straight, top);
}

// Where the channel leads the tip of a tool that turns: along the tool, unless it lies too flat to
// come away from the workpiece that way.
motion::Point SearchRunner::out_along_tool(const motion::Point& point_W, int infeed) const {
  constexpr double flattest = 0.17;  // 80 deg from the infeed axis
  const kinematics::Transform& transform = parts_.feed.blocks().transform();
  const motion::Point straight = straight_out(infeed);
  if (transform.mode != kinematics::PointMode::tip || transform.scheme == nullptr) return straight;
  const auto point_B = kinematics::base_from_workpiece(transform.frame, point_W);
  const auto tool_B = transform.scheme->spindle_axes(point_B)[2];
  const Vector3<double> tool_W = transform.frame.rotation.turned_back(tool_B);
  const std::array<double, 3> parts{tool_W.x(), tool_W.y(), tool_W.z()};
  motion::Point way{};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const int axis = transform.frame.geometry[k];
    if (axis >= 0) way[axis] = parts[k];
  }
  const double rise = way[infeed];
  if (rise < flattest) return straight;
  for (double& part : way) part /= rise;
  return way;
}

bool SearchRunner::is_within_travel(const std::optional<motion::Point>& point_W) const {
  constexpr double rounding = 1e-6;  // mm, deg: the end of an axis belongs to its travel
  if (!point_W) return true;
  motion::Point axes_M{};
  kinematics::inverse(parts_.feed.blocks().transform(), *point_W, axes_M);
  for (int k = 0; k < parts_.motion.axis_count; ++k) {
    const motion::AxisLimits& limits = parts_.motion.axes[k];
    if (axes_M[k] < limits.position_min - rounding || axes_M[k] > limits.position_max + rounding)
      return false;
  }
  return true;
}

// Away from the workpiece first; up there the state; then over the target, and at feed to it. The
// program goes on there.
void SearchRunner::approach(const motion::Point& target) {
  const lang::SearchState state = search_->collector.state();
  const Approach way = approach_to_target(target);
  const double feed = plunge_feed(*search_);
  lang::Command command;
  command.origin = {search_->place.file, search_->place.line};
  command.block = parts_.feed.blocks_executed();
  forget();
  parts_.feed.give_transform();
  motion::Point before = parts_.feed.blocks().position_W();
  enter_leg(way.lift, before, command, 0.0);
  for (lang::Payload& payload : commands_to_restore(state)) {
    command.payload = std::move(payload);
    entry_.push_back(command);
  }
  enter_leg(way.lateral, before, command, 0.0);
  enter_leg(way.plunge, before, command, feed);
}

// In rapid where the feed is 0.
void SearchRunner::enter_leg(const std::optional<motion::Point>& end, motion::Point& before,
                             lang::Command command, double feed_mm_min) {
  if (!end) return;
  lang::Move move;
  move.stop_at_end = true;
  move.words = axes_apart(before, *end);
  if (feed_mm_min > 0.0) {
    move.kind = lang::MoveKind::line;
    move.feed = feed_mm_min;
  }
  const motion::Point programmed = parts_.feed.blocks().programmed(*end);
  std::copy(programmed.begin(), programmed.end(), move.end.begin());
  command.payload = move;
  entry_.push_back(command);
  before = *end;
}

bool SearchRunner::next_entry(lang::Command& command) {
  if (entry_.empty()) return false;
  command = std::move(entry_.front());
  entry_.pop_front();
  return true;
}

}  // namespace stanok::channels
