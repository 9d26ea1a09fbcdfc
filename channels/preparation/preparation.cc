#include "channels/preparation/preparation.h"

#include <stdexcept>
#include <string>

#include "channels/contract/channel_description.h"
#include "channels/contract/motion_config.h"
#include "channels/preparation/feed_limit.h"

namespace stanok::channels {
namespace {

std::string first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics) {
    if (d.severity != Severity::error) continue;
    const std::string place = d.place.line > 0 ? d.place.file + ":" + std::to_string(d.place.line) +
                                                     ":" + std::to_string(d.place.column) + ": "
                                               : std::string();
    return d.code + " " + place + d.message;
  }
  return "";
}

}  // namespace

SchemeSet make_schemes(const ChannelConfig& channel) {
  SchemeSet schemes;
  for (const kinematics::SchemeConfig& config : channel.schemes) {
    auto scheme = kinematics::make_scheme(config);
    if (scheme == nullptr) throw std::invalid_argument("unknown scheme type " + config.type);
    schemes.emplace(config.id, std::move(scheme));
  }
  return schemes;
}

Preparation::Preparation(const MachineConfig& machine, const ChannelConfig& channel,
                         const SchemeSet& schemes, const lang::Files& files,
                         const PreparationBooks& books, std::function<bool()> gives_up)
    : config_(channel),
      schemes_(schemes),
      files_(files),
      shared_(books.shared),
      link_(books.link),
      reports_(books.reports),
      block_book_(books.blocks),
      live_(books.tables),
      is_unwanted_([this, gives_up = std::move(gives_up)] {
        return link_.resets_wanted.load(std::memory_order_relaxed) != resets_obeyed_ ||
               (gives_up && gives_up());
      }),
      motion_(motion_config(machine, channel)),
      description_(channel_description(machine, channel)),
      tables_(books.tables, machine, channel),
      interpreter_(description_, tables_, files),
      queue_(motion_, books.link, books.shared, books.blocks),
      feed_(machine, channel, motion_, queue_) {}

Progress Preparation::step() {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    break_off("E8002", "the memory does not hold what the program needs");
  } catch (const std::exception& fault) {
    break_off("A9001", fault.what());
  }
  return Progress::worked;
}

// What was prepared and not handed over is dropped: its parts may contradict each other.
void Preparation::break_off(std::string_view code, std::string_view reason) {
  forget_path();
  task_ = Task::idle;
  const lang::Origin& origin = command_.origin;
  Item item =
      item_of(ItemKind::broken_off, feed_.tag_at(static_cast<int>(origin.line), origin.file));
  item.code = FixedText<8>(code);
  item.text = ShortText(reason);
  feed_.give(item);
}

Progress Preparation::work() {
  Progress progress = Progress::blocked;
  Notice notice;
  while (link_.notices.pop(notice)) {
    obey(notice);
    progress = Progress::worked;
  }
  if (!queue_.flush()) return progress;
  if (task_ != Task::running) return progress;
  progress = interpret();
  static_cast<void>(queue_.flush());
  return progress;
}

void Preparation::obey(const Notice& notice) {
  use_load(notice.load);
  switch (notice.kind) {
    case NoticeKind::load:
      return load(std::string(notice.text.view()), notice.number);
    case NoticeKind::load_line:
      return load_line(std::string(notice.text.view()));
    case NoticeKind::search:
      return search(notice);
    case NoticeKind::start:
    case NoticeKind::start_line:
      return start(notice);
    case NoticeKind::answer:
      return take_answer(notice);
    case NoticeKind::reset:
      return reset();
    case NoticeKind::switch_scheme:
      return switch_scheme(notice);
  }
}

// The cycle may never hear of a load: a reset comes between. The program that it has then is the
// one before.
void Preparation::use_load(std::int32_t number) {
  if (newest_.number != number || newest_.program == nullptr) return;
  program_ = std::move(newest_.program);
  program_name_ = std::move(newest_.name);
  newest_ = {};
}

void Preparation::load(const std::string& name, std::int32_t number) {
  Diagnostics diagnostics;
  auto compiled = lang::compile(name, files_, &description_, diagnostics, is_unwanted_);
  if (compiled) {
    if (auto faults = declare_shared(**compiled); !faults.empty()) {
      compiled = Unexpected<Diagnostics>(std::move(faults));
    }
  }
  if (compiled) {
    newest_ = {number, *compiled, name};
    search_.reset();
    reports_.tell_search(config_.id, std::nullopt);
  }
  finish_load(name, compiled, std::move(diagnostics), number);
}

void Preparation::load_line(const std::string& line) {
  Diagnostics diagnostics;
  const auto compiled =
      lang::compile_line(line, program_.get(), files_, &description_, diagnostics, is_unwanted_);
  if (compiled) line_ = *compiled;
  finish_load(line, compiled, std::move(diagnostics));
}

void Preparation::finish_load(const std::string& name, const LoadResult& compiled,
                              Diagnostics diagnostics, std::int32_t number) {
  Item done = item_of(ItemKind::load_done, {});
  done.number = number;
  if (compiled) {
    done.flag = true;
    done.text = ShortText(name);
  } else {
    diagnostics.insert(diagnostics.end(), compiled.error().begin(), compiled.error().end());
    done.text = ShortText(first_error(compiled.error()));
  }
  reports_.add_diagnostics(config_.id, diagnostics);
  feed_.give(done);
}

Diagnostics Preparation::declare_shared(const lang::Program& program) {
  Diagnostics faults;
  for (const lang::SharedVariable& variable : lang::shared_variables(program)) {
    if (auto fault = shared_.declare(variable)) faults.push_back(std::move(*fault));
  }
  return faults;
}

void Preparation::start(const Notice& notice) {
  block_book_.begin_run(notice.run);
  entry_.clear();
  feed_.begin_run(notice.run);
  queue_.begin_run();
  scheme_ = schemes_.contains(notice.number) ? schemes_.at(notice.number).get() : nullptr;
  feed_.blocks().restart(scheme_, notice.axes_M);
  if (scheme_ != nullptr) tables_.set_scheme(*scheme_);
  feed_.give_transform();
  const bool is_line = notice.kind == NoticeKind::start_line;
  running_ = is_line ? line_ : program_;
  feed_.set_program(running_);
  name_files();
  reports_.name_run(config_.id, notice.run, is_line ? "MDI" : program_name_,
                    lang::file_names(*running_));
  interpreter_.set_block_skip(notice.block_skip);
  if (is_line) {
    interpreter_.start_line(running_, feed_.blocks().position_B());
  }
  scheme_switched_ = false;
  axes_change_ = false;
  task_ = Task::running;
  if (is_line) return;
  feed_.blocks().forget_laws();
  if (search_) {
    static_cast<void>(enter_program(ProgramSearch::Stage::run));
  } else {
    interpreter_.start(running_, feed_.blocks().position_B());
  }
}

// Before anything of the run can bear a tag.
void Preparation::name_files() {
  for (std::size_t k = 0; k < link_.file_names.size(); ++k)
    link_.file_names[k] = FileName(lang::file_name(*running_, static_cast<std::uint16_t>(k)));
}

void Preparation::take_answer(const Notice& notice) {
  if (task_ != Task::waiting_answer) return;
  lang::Answer answer;
  answer.ok = notice.ok;
  answer.raises = notice.raises;
  answer.number = notice.value;
  answer.text = std::string(notice.code.view());
  if (!answer.text.empty()) answer.text += ' ';
  answer.text += notice.text.view();
  if (scheme_switched_ || axes_change_) {
    feed_.blocks().change_scheme(scheme_, notice.axes_M);
    if (scheme_switched_) tables_.set_scheme(*scheme_);
    feed_.give_transform();
    scheme_switched_ = false;
    axes_change_ = false;
  }
  answer.probe_B = feed_.blocks().base_of(notice.probe_M);
  if (notice.left_path) {
    feed_.blocks().go_on_from(notice.axes_M);
    feed_.give_transform();
  }
  answer.position_B = feed_.blocks().position_B();
  answer.position_valid = true;
  task_ = Task::running;
  interpreter_.set_block_skip(notice.block_skip);
  interpreter_.answer(answer);
}

void Preparation::reset() {
  task_ = Task::idle;
  entry_.clear();
  search_.reset();
  reports_.tell_search(config_.id, std::nullopt);
  interpreter_.reset();
  tell_codes();
  block_book_.tell_codes({feed_.blocks_executed(), lang::default_codes(config_.kind)});
  feed_.blocks().reset_process();
  forget_path();
  ++resets_obeyed_;
  feed_.give(item_of(ItemKind::reset_done, {}));
}

void Preparation::forget_path() {
  queue_.forget();
  feed_.forget_path();
}

void Preparation::tell_codes() {
  for (const lang::CodeChange& change : interpreter_.take_code_changes())
    block_book_.tell_codes(change);
}

Progress Preparation::interpret() {
  if (search_ && search_->stage != ProgramSearch::Stage::found) return search_on();
  Progress progress = Progress::computing;
  for (int n = 0; n < commands_per_step && task_ == Task::running && !queue_.holds_items(); ++n) {
    switch (next_command()) {
      case lang::Step::command:
        tell_codes();
        if (take(command_)) progress = Progress::worked;
        break;
      case lang::Step::working:
        return progress;
      case lang::Step::waiting:
        task_ = Task::waiting_answer;
        return Progress::worked;
      case lang::Step::stopped:
      case lang::Step::ended:
        tell_codes();
        task_ = Task::idle;
        return Progress::worked;
      case lang::Step::failed: {
        const Diagnostic& error = interpreter_.error();
        fail(error, feed_.tag_at(error.place.line));
        return Progress::worked;
      }
    }
  }
  return queue_.holds_items() ? Progress::worked : progress;
}

// True when the cycle gets something of it.
bool Preparation::take(const lang::Command& command) {
  const auto taken = feed_.take(command);
  if (!taken) {
    fail(taken.error(), feed_.tag_of(command));
    return true;
  }
  if (taken->ends) task_ = Task::idle;
  axes_change_ = axes_change_ || taken->changes_axes;
  if (taken->gives) interpreter_.renew_steps();
  return taken->gives;
}

void Preparation::fail(const Diagnostic& diagnostic, const motion::BlockTag& tag) {
  reports_.explain(config_.id, feed_.run(), diagnostic);
  Item item = item_of(ItemKind::run_failed, tag);
  item.number = static_cast<std::int64_t>(feed_.blocks_executed());
  item.code = FixedText<8>(diagnostic.code);
  item.text = ShortText(diagnostic.message);
  feed_.give(item);
  task_ = Task::idle;
}

}  // namespace stanok::channels
