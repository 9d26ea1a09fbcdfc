// Block search: the loaded program is interpreted up to a block and nothing of it is executed; then
// the axes approach and it goes on.
#include <algorithm>

#include "channels/preparation/preparation.h"

namespace stanok::channels {
namespace {

Diagnostic no_such_target(const std::string& text) {
  Diagnostic diagnostic;
  diagnostic.code = "E6040";
  diagnostic.message = "`" + text + "` names no block";
  diagnostic.help = {"name a line, 120, or a block number, N40; in another file, sub.nc:120"};
  return diagnostic;
}

// The axis along which a tool comes to the workpiece: Z of mills, X of lathes; -1: none.
int infeed_axis(const std::array<int, 3>& geometry) {
  return geometry[1] >= 0 ? geometry[2] : geometry[0];
}

}  // namespace

void Preparation::search(const Notice& notice) {
  const std::string text(notice.text.view());
  search_.reset();
  reports_.tell_search(config_.id, std::nullopt);
  auto target = lang::search_target(text);
  if (!target) return end_search(no_such_target(text));
  target->passes = static_cast<int>(std::max(1.0, notice.value));
  const auto place = lang::find_place(*program_, *target);
  if (!place) return end_search(place.error());
  search_.emplace();
  search_->place = *place;
  search_->calculates = notice.ok;
  running_ = program_;
  feed_.set_program(running_);
  scheme_ = schemes_.contains(notice.number) ? schemes_.at(notice.number).get() : nullptr;
  feed_.blocks().restart(scheme_, notice.axes_M);
  feed_.blocks().forget_laws();
  if (scheme_ != nullptr) tables_.set_scheme(*scheme_);
  interpreter_.set_block_skip(notice.block_skip);
  task_ = Task::running;
  if (enter_program(ProgramSearch::Stage::look) && !search_->calculates) arrive();
}

// False: the program cannot be entered there, and the search is over.
bool Preparation::enter_program(ProgramSearch::Stage stage) {
  search_->stage = stage;
  search_->collector = {};
  search_->axes_M = feed_.blocks().axes_M();
  search_->scheme = scheme_;
  feed_.forget_threads();
  if (search_->calculates) {
    interpreter_.start_search(running_, feed_.blocks().position_B(), search_->place);
    return true;
  }
  const auto fault = interpreter_.start_at(running_, feed_.blocks().position_B(), search_->place);
  if (fault) end_search(*fault);
  if (fault || stage == ProgramSearch::Stage::look) return !fault;
  search_.reset();
  reports_.tell_search(config_.id, std::nullopt);
  return true;
}

Progress Preparation::search_on() {
  for (int n = 0; n < commands_per_step; ++n) {
    switch (interpreter_.next(command_)) {
      case lang::Step::command:
        if (const auto fault = pass(command_)) {
          end_search(*fault);
          return Progress::worked;
        }
        break;
      case lang::Step::working:
        return Progress::computing;
      case lang::Step::waiting:
        break;  // its request was answered when it came
      case lang::Step::stopped:
        arrive();
        return Progress::worked;
      case lang::Step::ended:
        end_search(lang::ended_before(*running_, search_->place));
        return Progress::worked;
      case lang::Step::failed:
        end_search(interpreter_.error());
        return Progress::worked;
    }
  }
  return Progress::worked;
}

void Preparation::end_search(const Diagnostic& fault) {
  const bool belongs_to_run = search_ && search_->stage == ProgramSearch::Stage::run;
  search_.reset();
  reports_.tell_search(config_.id, std::nullopt);
  if (belongs_to_run) {
    return fail(fault, feed_.tag_at(fault.place.line));
  }
  task_ = Task::idle;
  finish_load("", Unexpected<Diagnostics>({fault}), {});
}

// At the target: an operator is told, or the run begins.
void Preparation::arrive() {
  if (const auto obstacle = obstacle_at_target()) return end_search(*obstacle);
  const motion::Point target = feed_.blocks().position_W();
  feed_.blocks().go_on_from(search_->axes_M);
  if (search_->stage == ProgramSearch::Stage::run) return approach(target);
  search_->stage = ProgramSearch::Stage::found;
  SearchReport report;
  report.file = lang::file_name(*running_, search_->place.file);
  report.line = search_->place.line;
  report.words = config_.words;
  const motion::Point end = feed_.blocks().programmed(target);
  const motion::Point start = feed_.blocks().programmed(feed_.blocks().position_W());
  const auto count = static_cast<std::ptrdiff_t>(config_.words.size());
  if (search_->calculates) report.position.assign(end.begin(), end.begin() + count);
  report.stands_at.assign(start.begin(), start.begin() + count);
  report.state = search_->collector.state();
  reports_.tell_search(config_.id, report);
  task_ = Task::idle;
  finish_load(program_name_, program_, {});
}

std::optional<Diagnostic> Preparation::obstacle_at_target() const {
  Diagnostic diagnostic;
  diagnostic.place.file = lang::file_name(*running_, search_->place.file);
  diagnostic.place.line = static_cast<int>(search_->place.line);
  if (search_->scheme != scheme_) {
    const std::string scheme = std::to_string(search_->scheme->config().id);
    diagnostic.code = "E6043";
    diagnostic.message = "at the target the channel has the kinematic scheme " + scheme +
                         ", now it has " + std::to_string(scheme_->config().id);
    diagnostic.help = {"stanok kinematics select " + scheme +
                       ", then begin behind the switch without calculation, or before it"};
    return diagnostic;
  }
  const auto& converted = search_->collector.state().spindles_as_axes;
  if (!converted.empty()) {
    diagnostic.code = "E6044";
    diagnostic.message =
        "at the target spindle " + std::to_string(*converted.begin()) + " is an axis";
    diagnostic.help = {"begin before its M902, or behind its M903"};
    return diagnostic;
  }
  return std::nullopt;
}

// The position follows the program; nothing becomes a path.
std::optional<Diagnostic> Preparation::pass(const lang::Command& command) {
  SearchSink sink(search_->collector);
  const auto taken = feed_.pass(command, sink);
  if (!taken) return taken.error();
  if (const auto* request = std::get_if<lang::Request>(&command.payload))
    return pass_request(command, *request);
  return std::nullopt;
}

std::optional<Diagnostic> Preparation::pass_request(const lang::Command& command,
                                                    const lang::Request& request) {
  auto answer = answer_of_tables(request);
  if (!answer) answer = search_->collector.answer(request);
  if (!answer) return lang::answer_is_unknown(*running_, command.origin);
  const bool own = request.kind == lang::RequestKind::kinematics && request.channel == config_.id;
  if (own && schemes_.contains(request.number)) {
    search_->scheme = schemes_.at(request.number).get();
    feed_.pass_switch(*search_->scheme);
    tables_.set_scheme(*search_->scheme);
  }
  answer->position_B = feed_.blocks().position_B();
  answer->position_valid = true;
  interpreter_.answer(*answer);
  return std::nullopt;
}

// Tables are read as they are now; nothing: this is no question to them.
std::optional<lang::Answer> Preparation::answer_of_tables(const lang::Request& request) const {
  std::optional<double> value;
  if (request.kind == lang::RequestKind::tool_table_read) {
    value = live_.tool_value(request.number, request.index, request.channel);
  } else if (request.kind == lang::RequestKind::offset_table_read) {
    const int axis = request.index >= 0 ? config_.axes.at(static_cast<std::size_t>(request.index))
                                        : request.index;
    value = live_.offset(request.number, axis);
  }
  if (!value) return std::nullopt;
  lang::Answer answer;
  answer.number = *value;
  return answer;
}

// The state first, then the axes; the program goes on at its target.
void Preparation::approach(const motion::Point& target) {
  const lang::SearchState state = search_->collector.state();
  lang::Command command;
  command.origin = {search_->place.file, search_->place.line};
  command.block = feed_.blocks_executed();
  search_.reset();
  reports_.tell_search(config_.id, std::nullopt);
  feed_.give_transform();
  for (lang::Payload& payload : commands_to_restore(state)) {
    command.payload = std::move(payload);
    entry_.push_back(command);
  }
  motion::Point before = feed_.blocks().position_W();
  for (const motion::Point& point :
       approach_points(before, target, infeed_axis(feed_.blocks().geometry()))) {
    lang::Move move;
    move.stop_at_end = true;
    move.words = axes_apart(before, point);
    const motion::Point end = feed_.blocks().programmed(point);
    std::copy(end.begin(), end.end(), move.end.begin());
    command.payload = move;
    entry_.push_back(command);
    before = point;
  }
}

// The next command of the run: of its entry in the middle first, then of the interpreter.
lang::Step Preparation::next_command() {
  if (entry_.empty()) return interpreter_.next(command_);
  command_ = std::move(entry_.front());
  entry_.pop_front();
  return lang::Step::command;
}

}  // namespace stanok::channels
