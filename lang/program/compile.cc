#include "lang/program/compile.h"

#include <new>
#include <utility>

#include "lang/program/kept_files.h"
#include "lang/program/loader.h"

namespace stanok::lang {
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

}  // namespace stanok::lang
