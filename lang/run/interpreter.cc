#include "lang/run/interpreter.h"

#include <new>
#include <utility>

#include "lang/program/kept_files.h"
#include "lang/program/loader.h"
#include "lang/run/program_run.h"
#include "lang/text/compile_watch.h"

namespace stanok::lang {

struct Interpreter::State {
  State(const ChannelDescription& of_channel, Tables& tables)
      : channel(of_channel), run(channel, tables) {}

  ChannelDescription channel;
  ProgramRun run;
};

namespace {

using Compiled = Expected<std::shared_ptr<const Program>, Diagnostics>;

// A program for which the memory does not suffice is refused: the channels that run go on. So is
// one whose compilation was ended.
template <class Compile>
Compiled within_memory(std::string_view name, Compile compile) {
  try {
    return compile();
  } catch (const CompileEnd& end) {
    Diagnostic fault = end.reason();
    fault.place.file = name;
    return Unexpected<Diagnostics>({std::move(fault)});
  } catch (const std::bad_alloc&) {
    Diagnostic fault;
    fault.code = "E8002";
    fault.message = "there is not enough memory to load the program";
    fault.place.file = name;
    return Unexpected<Diagnostics>({std::move(fault)});
  }
}

}  // namespace

Expected<std::shared_ptr<const Program>, Diagnostics> compile(std::string_view name,
                                                              const Files& files,
                                                              const ChannelDescription* channel,
                                                              Diagnostics& warnings,
                                                              const Interruption& interrupted) {
  return within_memory(name,
                       [&] { return Loader(files, channel, warnings, interrupted).load(name); });
}

Expected<std::shared_ptr<const Program>, Diagnostics> compile_line(
    std::string_view line, const Program* loaded, const Files& files,
    const ChannelDescription* channel, Diagnostics& warnings, const Interruption& interrupted) {
  return within_memory({}, [&] {
    const KeptFiles kept(loaded, files);
    return Loader(kept, channel, warnings, interrupted).load_line(line, loaded);
  });
}

std::string_view file_name(const Program& program, std::uint16_t file) {
  return file < program.files.size() ? std::string_view(program.files[file]->source.name())
                                     : std::string_view();
}

std::vector<std::string> file_names(const Program& program) {
  std::vector<std::string> names;
  names.reserve(program.files.size());
  for (const auto& file : program.files) names.emplace_back(file->source.name());
  return names;
}

void put_at_block(const Program& program, const Origin& origin, Diagnostic& diagnostic) {
  const Source& source = program.files[origin.file]->source;
  const Span words = source.words_of_line(origin.line);
  diagnostic.place = source.place(words);
  diagnostic.source_line = std::string(source.line_at(words.offset));
}

const std::vector<ConstantDispatch>& constant_dispatches(const Program& program) {
  return program.dispatches;
}

std::vector<SharedVariable> shared_variables(const Program& program) {
  std::vector<SharedVariable> all;
  for (const auto& file : program.files)
    all.insert(all.end(), file->shared.begin(), file->shared.end());
  return all;
}

std::size_t line_count(const Program& program) {
  return program.files[0]->source.line_count();
}

Interpreter::Interpreter(const ChannelDescription& channel, Tables& tables, const Files&)
    : state_(std::make_unique<State>(channel, tables)) {}

Interpreter::~Interpreter() = default;

void Interpreter::start(std::shared_ptr<const Program> program, const AxisValues& position_B) {
  state_->run.start(std::move(program), position_B);
}

void Interpreter::start_line(std::shared_ptr<const Program> line, const AxisValues& position_B) {
  state_->run.start_line(std::move(line), position_B);
}

void Interpreter::start_search(std::shared_ptr<const Program> program, const AxisValues& position_B,
                               const StopPlace& place) {
  state_->run.start(std::move(program), position_B);
  state_->run.stop_before(place);
}

std::optional<Diagnostic> Interpreter::start_at(std::shared_ptr<const Program> program,
                                                const AxisValues& position_B,
                                                const StopPlace& place) {
  return state_->run.start_at(std::move(program), position_B, place);
}

void Interpreter::reset() {
  state_->run.forget_lines();
}

Step Interpreter::next(Command& command) {
  return state_->run.next(command);
}

void Interpreter::answer(const Answer& answer) {
  state_->run.answer(answer);
}

const Diagnostic& Interpreter::error() const {
  return state_->run.error();
}

Passed Interpreter::pass_fault() {
  return state_->run.pass_fault();
}

Origin Interpreter::origin() const {
  return state_->run.origin();
}

std::uint64_t Interpreter::steps() const {
  return state_->run.steps();
}

void Interpreter::renew_steps() {
  state_->run.renew_steps();
}

std::uint64_t Interpreter::blocks() const {
  return state_->run.blocks();
}

std::vector<CodeChange> Interpreter::take_code_changes() {
  return state_->run.take_code_changes();
}

void Interpreter::set_block_skip(std::uint16_t levels) {
  state_->run.set_block_skip(levels);
}

}  // namespace stanok::lang
