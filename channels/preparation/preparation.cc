#include "channels/preparation/preparation.h"

#include <string>
#include <utility>
#include <variant>

namespace stanok::channels {

Preparation::Preparation(const MachineConfig& machine, const ChannelConfig& channel,
                         const SchemeSet& schemes, const lang::Files& files,
                         const PreparationBooks& books, std::function<bool()> gives_up)
    : link_(books.link),
      situations_(books.situations),
      parts_(machine, channel, schemes, files, books),
      shelf_(channel, parts_.description, files, books.shared, books.reports,
             [this, gives_up = std::move(gives_up)] {
               return link_.resets_wanted.load(std::memory_order_relaxed) != resets_obeyed_ ||
                      (gives_up && gives_up());
             }),
      search_(parts_) {}

Progress Preparation::step(RecordedWork* recorded, const std::function<bool()>& may_go_on) {
  try {
    return work({recorded, may_go_on});
  } catch (const std::bad_alloc&) {
    break_off("E8002", "there is not enough memory for the program");
  } catch (const std::exception& fault) {
    break_off("A9001", fault.what());
  }
  return Progress::worked;
}

// What was prepared and not handed over is dropped: its parts may contradict each other.
void Preparation::break_off(std::string_view code, std::string_view reason) {
  forget_path();
  task_ = Task::idle;
  const lang::Origin& origin = parts_.command.origin;
  parts_.feed.give({.tag = parts_.feed.tag_at(static_cast<int>(origin.line), origin.file),
                    .content = BrokenOff{code, reason}});
}

Progress Preparation::work(const Guide& guide) {
  Progress progress = Progress::blocked;
  if (!link_.notices.empty()) {
    obey_notices();
    progress = Progress::worked;
  }
  if (!parts_.queue.flush()) return progress;
  if (question_ && task_ == Task::idle) {
    settle(*std::exchange(question_, std::nullopt));
    progress = Progress::worked;
  }
  if (task_ != Task::running) {
    follow_tables();
    return progress;
  }
  const bool is_far_ahead = guide.recorded == nullptr && parts_.queue.seconds_free() > far_ahead_s;
  if (is_far_ahead) return progress;
  progress = interpret(guide);
  static_cast<void>(parts_.queue.flush());
  return progress;
}

bool Preparation::is_urgent() {
  return task_ == Task::running && parts_.queue.seconds_ahead() < enough_path_s;
}

void Preparation::obey_notices() {
  Notice notice;
  while (link_.notices.pop(notice)) std::visit([this](const auto& told) { obey(told); }, notice);
}

void Preparation::obey(const ProgramLoad& load) {
  shelf_.use(load.load_in_use);
  const LoadDone done = shelf_.load(std::string(load.program.view()), load.number);
  if (done.succeeded) search_.forget();
  parts_.feed.give({.content = done});
}

void Preparation::obey(const LineLoad& load) {
  shelf_.use(load.load_in_use);
  parts_.feed.give({.content = shelf_.load_line(std::string(load.line.view()))});
}

void Preparation::obey(const BlockSearch& search) {
  parts_.tables.advance_to(search.start.stand.tables);
  shelf_.use(search.start.load);
  task_ = Task::running;
  static_cast<void>(use_result(search_.look(search, shelf_.program())));
}

void Preparation::obey(const ProgramStart& notice) {
  shelf_.use(notice.start.load);
  begin_run(notice.start, shelf_.program(), shelf_.name());
  if (stands_elsewhere(notice.start.stand)) return;
  parts_.restart(notice.start.stand);
  parts_.feed.give_transform();
  parts_.feed.blocks().forget_laws();
  if (search_.is_set()) {
    static_cast<void>(use_result(search_.begin_run()));
  } else {
    parts_.interpreter.start(parts_.program, parts_.feed.blocks().position_B());
  }
}

void Preparation::obey(const LineStart& notice) {
  shelf_.use(notice.start.load);
  begin_run(notice.start, shelf_.line(), "MDI");
  if (stands_elsewhere(notice.start.stand)) return;
  parts_.restart(notice.start.stand);
  settle_feed();
  parts_.feed.give_transform();
  parts_.interpreter.start_line(parts_.program, parts_.feed.blocks().position_B());
}

void Preparation::begin_run(const RunStart& start, std::shared_ptr<const lang::Program> program,
                            const std::string& name) {
  run_ = start.run;
  command_ = 0;
  asks_ = false;
  parts_.tables.advance_to(start.stand.tables);
  parts_.tables.begin_run();
  situations_.begin_run(start.run);
  static_cast<void>(parts_.interpreter.take_meanings());  // of a search
  numbered_.clear();
  search_.forget_entry();
  parts_.feed.begin_run(start.run);
  parts_.queue.begin_run();
  parts_.set_program(std::move(program));
  name_files();
  parts_.reports.name_run(parts_.config.id, start.run, name, lang::file_names(*parts_.program));
  parts_.interpreter.set_block_skip(start.block_skip);
  scheme_switched_ = false;
  axes_change_ = false;
  task_ = Task::running;
}

// A run begins where its channel stands: what the cycle shows and what the preparation believes
// have one number. True: they differ, by a fault of our own, and the run is refused.
bool Preparation::stands_elsewhere(const Stand& stand) {
  if (stand.situation == situation_) return false;
  Diagnostic fault;
  fault.code = "A9001";
  fault.message = "the situation shown is " + std::to_string(stand.situation) +
                  ", that of the next block is " + std::to_string(situation_);
  fail(fault, parts_.feed.tag_at(0));
  return true;
}

// Before anything of the run can bear a tag.
void Preparation::name_files() {
  for (std::size_t k = 0; k < link_.file_names.size(); ++k)
    link_.file_names[k] = FileName(lang::file_name(*parts_.program, static_cast<std::uint16_t>(k)));
}

void Preparation::obey(const RequestAnswer& notice) {
  parts_.tables.advance_to(notice.tables);
  if (task_ != Task::waiting_answer) return;
  parts_.interpreter.follow_lengths();
  BlockPreparation& blocks = parts_.feed.blocks();
  const bool is_changed = blocks.take_lengths();
  const ChannelAnswer& told = notice.answer;
  lang::Answer answer;
  answer.ok = told.ok;
  answer.raises = told.raises;
  answer.number = told.value;
  answer.text = std::string(told.code.view());
  if (!answer.text.empty()) answer.text += ' ';
  answer.text += told.text.view();
  if (scheme_switched_ || axes_change_) {
    blocks.change_scheme(parts_.scheme, notice.axes_M);
    if (scheme_switched_) parts_.tables.set_scheme(*parts_.scheme);
    parts_.feed.give_transform();
    scheme_switched_ = false;
    axes_change_ = false;
  }
  answer.probe_B = blocks.base_of(told.probe_M);
  if (told.left_path) blocks.stand_at(notice.axes_M);
  if (told.left_path || is_changed) parts_.feed.give_transform();
  answer.position_B = blocks.position_B();
  answer.position_valid = true;
  task_ = Task::running;
  parts_.interpreter.set_block_skip(notice.block_skip);
  parts_.interpreter.answer(answer);
}

void Preparation::obey(const PathReset& reset) {
  parts_.tables.advance_to(reset.stand.tables);
  task_ = Task::idle;
  search_.forget_entry();
  search_.forget();
  parts_.interpreter.reset({reset.stand.tool.number, reset.stand.tool.edge});
  parts_.feed.blocks().reset_process();
  forget_path();
  if (question_) parts_.interpreter.take_changed_rows(question_->rows);
  question_.reset();
  parts_.stand(reset.stand);
  settle_feed();
  ++resets_obeyed_;
  parts_.feed.give({.content = ResetDone{parts_.feed.rest()}});
}

// A search has interpreter and path for itself. A reset that comes meanwhile answers, too.
void Preparation::obey(const Settle& question) {
  question_ = question;
}

void Preparation::settle(const Settle& question) {
  parts_.tables.advance_to(question.stand.tables);
  parts_.interpreter.take_changed_rows(question.rows);
  parts_.stand(question.stand);
  settle_feed();
  parts_.feed.give({.content = Settled{parts_.feed.rest()}});
}

void Preparation::forget_path() {
  parts_.queue.forget();
  parts_.feed.forget_path();
}

// Numbers what the interpreter has changed.
void Preparation::take_meanings() {
  for (const lang::MeaningChange& change : parts_.interpreter.take_meanings())
    numbered_.push_back({change.block, situations_.enter(change.meaning)});
}

// Commands of a block may come when later ones were read: behind radius compensation.
void Preparation::select_situation(std::uint64_t block) {
  while (numbered_.size() > 1 && numbered_[1].block <= block) numbered_.pop_front();
  if (!numbered_.empty()) parts_.feed.set_situation(numbered_.front().situation);
}

// Nothing runs any more, or not yet: path and display stand in what the next line will be read in.
void Preparation::settle_feed() {
  const lang::Meaning standing = parts_.interpreter.standing();
  static_cast<void>(parts_.interpreter.take_meanings());
  numbered_.clear();
  parts_.feed.settle(*standing.terms);
  situation_ = situations_.enter(standing);
  parts_.feed.set_situation(situation_);
}

Progress Preparation::interpret(const Guide& guide) {
  if (search_.is_under_way()) return use_result(search_.advance(commands_per_step));
  const QueueSink& queue = parts_.queue;
  Progress progress = Progress::computing;
  // No step ends between a request and the wait for its answer, which would come too early then;
  // nor is anything read of the tables there.
  const auto goes_on = [&](int n) {
    const bool is_in_step = n < commands_per_step && !queue.holds_items();
    return task_ == Task::running && (is_in_step || asks_);
  };
  for (int n = 0; goes_on(n); ++n) {
    if (!asks_ && !take_tables(guide)) return n > 0 ? progress : Progress::blocked;
    asks_ = false;
    switch (next_command()) {
      case lang::Step::command:
        asks_ = std::holds_alternative<lang::ProgramRequest>(parts_.command.payload);
        take_meanings();
        if (take(parts_.command)) progress = Progress::worked;
        break;
      case lang::Step::working:
        return progress;
      case lang::Step::waiting:
        task_ = Task::waiting_answer;
        return Progress::worked;
      case lang::Step::stopped:
      case lang::Step::ended:
        take_meanings();
        task_ = Task::idle;
        return Progress::worked;
      case lang::Step::failed: {
        const Diagnostic& error = parts_.interpreter.error();
        fail(error, parts_.feed.tag_at(error.place.line));
        return Progress::worked;
      }
    }
  }
  return queue.holds_items() ? Progress::worked : progress;
}

// What others have written into the tables counts from here on. False: it is not known yet what the
// recorded run took here.
bool Preparation::take_tables(const Guide& guide) {
  if (guide.recorded != nullptr) return repeat_takings(guide);
  ChannelTables& tables = parts_.tables;
  const std::uint64_t newest = tables.newest_version();
  // With a notice to come tables go on anyway, as far as it says.
  if (newest == tables.view().version() || !link_.notices.empty()) return true;
  if (link_.takings.space() == 0) return true;
  tables.advance_to(newest);
  parts_.interpreter.follow_lengths();
  static_cast<void>(link_.takings.push({run_, command_, tables.view().version()}));
  return true;
}

// What is made already must be handed over before it is asked whether more is known to be made.
bool Preparation::repeat_takings(const Guide& guide) {
  if (!parts_.queue.flush() || !guide.may_go_on()) return false;
  while (const TableTaking* taking = guide.recorded->at(run_, command_)) {
    if (taking->version > parts_.tables.newest_version()) return false;
    parts_.tables.advance_to(taking->version);
    parts_.interpreter.follow_lengths();
    guide.recorded->takings.pop_front();
  }
  return true;
}

// While nothing is read: whatever notice comes next is of a later write, or of this one.
void Preparation::follow_tables() {
  const std::uint64_t newest = parts_.tables.newest_version();
  if (link_.notices.empty()) parts_.tables.advance_to(newest);
}

Progress Preparation::use_result(SearchRunner::Result result) {
  switch (result) {
    case SearchRunner::Result::working:
    case SearchRunner::Result::entered:
      return Progress::worked;
    case SearchRunner::Result::computing:
      return Progress::computing;
    case SearchRunner::Result::found:
      task_ = Task::idle;
      parts_.feed.give({.content = shelf_.search_found()});
      break;
    case SearchRunner::Result::failed:
      task_ = Task::idle;
      parts_.feed.give({.content = shelf_.search_failed(search_.fault())});
      break;
    case SearchRunner::Result::run_failed:
      fail(search_.fault(), parts_.feed.tag_at(search_.fault().place.line));
      break;
  }
  return Progress::worked;
}

// Of the entry of a run in the middle first, then of the interpreter.
lang::Step Preparation::next_command() {
  ++command_;
  if (search_.next_entry(parts_.command)) return lang::Step::command;
  return parts_.interpreter.next(parts_.command);
}

// True when the cycle gets something of it.
bool Preparation::take(const lang::Command& command) {
  select_situation(command.block);
  if (std::holds_alternative<lang::ProgramEnd>(command.payload)) settle_feed();
  const auto taken = parts_.feed.take(command);
  if (!taken) {
    fail(taken.error(), parts_.feed.tag_of(command));
    return true;
  }
  if (taken->ends) task_ = Task::idle;
  axes_change_ = axes_change_ || taken->changes_axes;
  if (taken->gives) parts_.interpreter.renew_steps();
  return taken->gives;
}

void Preparation::fail(const Diagnostic& diagnostic, const motion::BlockTag& tag) {
  parts_.reports.explain(parts_.config.id, tag.run, diagnostic);
  parts_.interpreter.break_off();
  settle_feed();
  parts_.feed.give({.tag = tag,
                    .content = RunFailed{.blocks = parts_.feed.blocks_executed(),
                                         .code = std::string_view(diagnostic.code),
                                         .text = std::string_view(diagnostic.message),
                                         .rest = parts_.feed.rest()}});
  task_ = Task::idle;
}

}  // namespace stanok::channels
