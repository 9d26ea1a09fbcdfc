#include "lang/program/loader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lang/program/engraving.h"
#include "lang/program/foreign_parameter.h"
#include "lang/text/foreign_control.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"
#include "lang/tree/parser.h"

namespace stanok::lang {
namespace {

// Calls `visit` for every list of statements inside `statement`.
template <class Visit>
void for_each_body(const Statement& statement, Visit visit) {
  if (const auto* compound = std::get_if<Compound>(&statement.kind)) visit(compound->body);
  if (const auto* branch = std::get_if<If>(&statement.kind)) {
    visit(branch->then_body);
    visit(branch->else_body);
  }
  if (const auto* loop = std::get_if<While>(&statement.kind)) visit(loop->body);
  if (const auto* loop = std::get_if<DoWhile>(&statement.kind)) visit(loop->body);
  if (const auto* loop = std::get_if<For>(&statement.kind)) visit(loop->body);
  if (const auto* choice = std::get_if<Switch>(&statement.kind)) {
    for (const SwitchCase& one : choice->cases) visit(one.body);
  }
  if (const auto* function = std::get_if<FunctionDefinition>(&statement.kind)) {
    visit(function->body);
  }
  if (const auto* loop = std::get_if<ORepeat>(&statement.kind)) visit(loop->body);
  if (const auto* subprogram = std::get_if<OSubprogram>(&statement.kind)) visit(subprogram->body);
}

// The program that M98, M198, G65 or G150 of a block names by a plain number.
struct NamedProgram {
  int number = 0;
  SearchedTexts texts = SearchedTexts::all;
};
std::optional<NamedProgram> program_of_block(const IsoBlock& block) {
  std::optional<NamedProgram> program;
  const IsoWord* number = nullptr;
  for (const IsoWord& word : block.words) {
    const bool call = word.name.letter == 'M' && word.name.code == m(98);
    const bool file_call = word.name.letter == 'M' && word.name.code == m(198);
    const bool macro =
        word.name.letter == 'G' &&
        (calls_macro(static_cast<CodeNumber>(word.name.code)) || word.name.code == g(150));
    if (call || file_call || macro)
      program = NamedProgram{0, file_call ? SearchedTexts::files_only : SearchedTexts::all};
    if (word.name.letter == 'P' && word.value.node == Node::number) number = &word;
  }
  if (!program || number == nullptr || !is_integer(number->value.number)) return std::nullopt;
  program->number = static_cast<int>(std::lround(number->value.number));
  return program;
}

Diagnostic foreign_text(const Source& source, const Span& span, const ForeignText& foreign) {
  Diagnostic diagnostic =
      diagnostic_at(source, "E2042", span, "this looks like " + std::string(foreign.what),
                    "words of such a text");
  diagnostic.help.emplace_back(foreign.remedy);
  return diagnostic;
}

std::vector<std::string> file_names_of_number(int number) {
  const std::string digits = std::to_string(number);
  const std::string padded = std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
  return {"O" + padded + ".nc", digits + ".nc", "o" + digits + ".nc"};
}

std::vector<std::string> file_names_of_label(const OLabel& label) {
  std::vector<std::string> names{label.written + ".ngc", label.written + ".nc"};
  if (label.name != label.written) {
    names.push_back(label.name + ".ngc");
    names.push_back(label.name + ".nc");
  }
  return names;
}

}  // namespace

Loader::Loader(const Files& files, const ChannelDescription* channel, Diagnostics& warnings,
               const Interruption& interrupted)
    : files_(files),
      channel_(channel),
      dialect_(channel),
      warnings_(warnings),
      watch_(interrupted),
      rules_(channel != nullptr ? channel->rules : TextRules{}),
      program_(std::make_shared<Program>()) {}

Expected<std::shared_ptr<const Program>, Diagnostics> Loader::load(std::string_view name) {
  auto text = files_.read(name, {});
  if (!text) return tl::unexpected(Diagnostics{text.error()});
  if (auto refusal = refusal_of_file(**text)) return tl::unexpected(Diagnostics{*refusal});
  add_file(std::move(*text));
  find_all_files();
  check_end(0);
  compile_all();
  warn_of_foreign_parameters();
  return result();
}

void Loader::find_all_files() {
  // Files found on the way are appended; each is parsed once. Whether a subprogram needs a file of
  // its own is known when all included files are.
  std::size_t parsed = 0;
  for (std::size_t searched = 0; searched < loaded_.size(); ++searched) {
    for (; parsed < loaded_.size(); ++parsed) {
      const auto index = static_cast<FileIndex>(parsed);
      parse(index);
      follow_includes(index);
      follow_blanks(index, loaded_[parsed].tree);
      follow_calls(index, loaded_[parsed].tree);
    }
    follow_subprograms(static_cast<FileIndex>(searched), loaded_[searched].tree);
  }
}

Loader::FileIndex Loader::add_file(std::shared_ptr<const SourceText> text) {
  const auto known = index_by_path_.find(text->path);
  if (known != index_by_path_.end()) return known->second;
  bytes_ += text->text.size();
  const auto index = static_cast<FileIndex>(loaded_.size());
  index_by_path_.emplace(text->path, index);
  program_->files.push_back(std::make_unique<CompiledFile>(Source(std::move(text), rules_)));
  LoadedFile file;
  file.reporter = std::make_unique<Reporter>(program_->files.back()->source);
  loaded_.push_back(std::move(file));
  return index;
}

std::optional<Loader::FileIndex> Loader::find_file(std::string_view name, FileIndex from) {
  const std::pair key(from, std::string(name));
  const auto known = program_->file_by_name.find(key);
  if (known != program_->file_by_name.end()) return known->second;
  if (failures_.contains(key)) return std::nullopt;
  auto text = files_.read(name, program_->files[from]->source.path());
  if (!text) {
    failures_.emplace(key, text.error());
    return std::nullopt;
  }
  if (auto refusal = refusal_of_file(**text)) {
    failures_.emplace(key, std::move(*refusal));
    return std::nullopt;
  }
  const FileIndex index = add_file(std::move(*text));
  program_->file_by_name.emplace(key, index);
  return index;
}

std::optional<Diagnostic> Loader::refusal_of_file(const SourceText& text) const {
  if (index_by_path_.contains(text.path)) return std::nullopt;
  const std::size_t bytes_max = (channel_ != nullptr ? channel_->bounds : ProgramBounds{}).bytes;
  const std::size_t bytes = bytes_ + text.text.size();
  if (bytes > bytes_max) return too_large(text.name, bytes, bytes_max);
  if (loaded_.size() < limits::files) return std::nullopt;
  Diagnostic diagnostic;
  diagnostic.code = "E8003";
  diagnostic.message = "a program has at most 256 files";
  return diagnostic;
}

void Loader::parse(FileIndex index) {
  const Source& source = program_->files[index]->source;
  Reporter& reporter = *loaded_[index].reporter;
  if (source.lone_frame_mark().length != 0) {
    reporter.warning("W210", source.lone_frame_mark(), "the program has only one line with %",
                     "a second one is missing");
  }
  if (const ForeignText* const foreign = foreign_by_header(source.text())) {
    reporter.tell_only(foreign_text(source, source.words_of_line(1), *foreign));
    return;
  }
  if (!source.dialect_problem().empty()) {
    reporter.error("E2041", source.first_words(), source.dialect_problem(), "names a dialect");
  }
  ParserContext context;
  context.channel = index == 0 ? channel_ : nullptr;
  if (index == 0) context.functions = functions_of_line_;
  context.dialect = &dialect_;
  context.watch = &watch_;
  context.named_parameters = &program_->named_parameters;
  context.included_functions = [this, index](std::string_view name) {
    const auto file = find_file(name, index);
    return file ? defined_functions(program_->files[*file]->source) : std::set<std::string>{};
  };
  Parser parser(source, reporter, std::move(context));
  StatementList tree = parser.parse_program();
  if (source.rules().is_haas()) loaded_[index].includes_engraving = make_engravings(tree, reporter);
  loaded_[index].tree = std::move(tree);
  list_definitions(loaded_[index]);
  tell_foreign_text(index);
}

void Loader::list_definitions(LoadedFile& file) {
  for (const Statement& statement : file.tree) {
    if (const auto* subprogram = std::get_if<OSubprogram>(&statement.kind))
      file.subprograms.insert(subprogram->label.name);
    if (const auto* program = std::get_if<NumberedProgram>(&statement.kind))
      file.programs.insert(program->number);
  }
}

void Loader::tell_foreign_text(FileIndex index) {
  const Source& source = program_->files[index]->source;
  Reporter& reporter = *loaded_[index].reporter;
  const auto is_foreign = [](std::string_view line) { return foreign_by_line(line) != nullptr; };
  const auto line = reporter.find_error_line(is_foreign);
  if (!line) return;
  const Span words = source.words_of_line(*line);
  reporter.tell_only(foreign_text(source, words, *foreign_by_line(source.text(words))));
}

void Loader::follow_includes(FileIndex index) {
  for (const Statement& statement : loaded_[index].tree) {
    if (const auto* include = std::get_if<IncludeDirective>(&statement.kind)) {
      follow_include(index, statement, *include);
    }
  }
}

void Loader::follow_include(FileIndex index, const Statement& statement,
                            const IncludeDirective& directive) {
  const auto file = find_file(directive.file, index);
  if (file) {
    program_->files[index]->includes.push_back(*file);
    Place& place = loaded_[*file].included_at;
    if (place.line == 0) place = program_->files[index]->source.place(statement.span);
    return;
  }
  const Diagnostic& failure = failures_.at({index, directive.file});
  Diagnostic& diagnostic =
      loaded_[index].reporter->error(failure.code, directive.file_span, failure.message,
                                     failure.label.empty() ? "cannot be read" : failure.label);
  diagnostic.notes = failure.notes;
  diagnostic.help = failure.help;
}

// The STL files of blanks: what is wrong with one is known before anything moves.
void Loader::follow_blanks(FileIndex index, const StatementList& list) {
  for (const Statement& statement : list) {
    const auto* const directive = std::get_if<WorkpieceDirective>(&statement.kind);
    if (directive != nullptr && !directive->file.empty()) follow_blank(index, *directive);
    for_each_body(statement, [&](const StatementList& body) { follow_blanks(index, body); });
  }
}

void Loader::follow_blank(FileIndex index, const WorkpieceDirective& directive) {
  Reporter& reporter = *loaded_[index].reporter;
  if (!names_stl_file(directive.file)) {
    reporter.error("E7020", directive.file_span, "the file of a blank must be an STL file",
                   "does not end in .stl");
    return;
  }
  const auto text = files_.read(directive.file, program_->files[index]->source.path());
  if (!text) {
    const Diagnostic& failure = text.error();
    Diagnostic& error = reporter.error(failure.code, directive.file_span, failure.message,
                                       failure.label.empty() ? "cannot be used" : failure.label);
    error.notes = failure.notes;
    error.help = failure.help;
    return;
  }
  const auto file = read_blank_file((*text)->text);
  if (!file) {
    reporter.error("E7020", directive.file_span, directive.file + " is not an STL file",
                   "it cannot be read");
  } else if ((*text)->path.size() > blank_path_max) {
    reporter
        .error("E7002", directive.file_span, "the path of the STL file is too long",
               "its path is too long")
        .help.push_back("move it closer to the program root: its path may have at most " +
                        std::to_string(blank_path_max) + " bytes");
  } else {
    program_->blanks[{index, directive.file}] = {(*text)->path, *file};
  }
}

void Loader::follow_calls(FileIndex index, const StatementList& list) {
  for (const Statement& statement : list) {
    if (const auto* call = std::get_if<CallStatement>(&statement.kind)) follow_call(index, *call);
    for_each_body(statement, [&](const StatementList& body) { follow_calls(index, body); });
  }
}

// call ("name"): the file belongs to the program; when it is missing, that is known only when the
// call is reached.
void Loader::follow_call(FileIndex index, const CallStatement& statement) {
  const Expression& call = statement.call;
  const bool names_file = folded(call.text) == "call" && call.children.size() == 1 &&
                          call.children[0].node == Node::string;
  if (!names_file) return;
  const std::string& name = call.children[0].text;
  if (program_->file_by_name.contains({index, name})) return;
  const auto file = find_file(name, index);
  loaded_[index].reporter->warning("W710", call.children[0].span,
                                   file ? "\"" + name + "\" is called without being included"
                                        : "\"" + name + "\" is not included and was not found",
                                   "not included");
}

// O... call, M98, M198, G65: what neither this file nor an included one holds is a file of its own.
void Loader::follow_subprograms(FileIndex index, const StatementList& list) {
  for (const Statement& statement : list) {
    if (const auto* call = std::get_if<OCall>(&statement.kind)) follow_o_call(index, *call);
    if (const auto* block = std::get_if<IsoBlock>(&statement.kind)) {
      follow_user_codes(index, *block);
      const auto program = program_of_block(*block);
      if (program && !follow_number(index, program->number, program->texts)) {
        follow_number(index, program->number % 10000, program->texts);
      }
    }
    for_each_body(statement, [&](const StatementList& body) { follow_subprograms(index, body); });
  }
}

// The files of the machine file's macros that the block calls.
void Loader::follow_user_codes(FileIndex index, const IsoBlock& block) {
  for (const IsoWord& word : block.words) {
    if (word.name.code < 0) continue;
    const UserCode* const code = dialect_.macro(word.name.letter, word.name.code);
    if (code == nullptr || program_->file_by_macro.contains(code->program)) continue;
    if (const auto file = find_file(code->program, 0)) {
      program_->file_by_macro.emplace(code->program, *file);
      continue;
    }
    const Diagnostic& failure = failures_.at({0, code->program});
    loaded_[index]
        .reporter->error(failure.code, word.span, failure.message, "the macro of this code")
        .notes.push_back(
            {"the machine file names it for " + code_text(word.name.letter, word.name.code), {}});
  }
}

void Loader::follow_o_call(FileIndex index, const OCall& call) {
  const OLabel& label = call.label;
  if (label.computed || program_->file_by_label.contains({index, label.name})) return;
  const auto defines = [&](FileIndex file) {
    return loaded_[file].subprograms.contains(label.name);
  };
  const auto& includes = program_->files[index]->includes;
  if (defines(index) || std::any_of(includes.begin(), includes.end(), defines)) return;
  if (const auto file = first_file_of(file_names_of_label(label), index)) {
    program_->file_by_label.emplace(std::pair(index, label.name), *file);
  }
}

// Whether program `number` is known or was found.
bool Loader::follow_number(FileIndex index, int number, SearchedTexts texts) {
  const auto defines = [&](FileIndex file) { return loaded_[file].programs.contains(number); };
  const auto& includes = program_->files[index]->includes;
  if (texts == SearchedTexts::all &&
      (defines(index) || std::any_of(includes.begin(), includes.end(), defines))) {
    return true;
  }
  if (program_->file_by_number.contains({index, number})) return true;
  const auto file = first_file_of(file_names_of_number(number), index);
  if (file) program_->file_by_number.emplace(std::pair(index, number), *file);
  return file.has_value();
}

std::optional<Loader::FileIndex> Loader::first_file_of(const std::vector<std::string>& names,
                                                       FileIndex from) {
  for (const std::string& name : names) {
    if (const auto file = find_file(name, from)) return file;
  }
  return std::nullopt;
}

void Loader::check_end(FileIndex index) {
  Reporter& reporter = *loaded_[index].reporter;
  const bool ends = reporter.is_soft(std::numeric_limits<std::size_t>::max() - 1);
  const StatementList& tree = loaded_[index].tree;
  if (ends || reporter.error_count() != 0) return;
  const Source& source = program_->files[index]->source;
  const std::size_t offset = tree.empty() ? source.begin() : source.end();
  reporter.warning("W211", {offset, 0, source.line_number(offset)},
                   "the program ends without M2, M30 or M99", "it ends here like M30");
}

void Loader::compile_all() {
  std::vector<FileNames> names(loaded_.size());
  std::vector<std::unique_ptr<Compiler>> compilers;
  for (std::size_t i = 0; i < loaded_.size(); ++i) {
    const ChannelDescription* const channel = i == 0 ? channel_ : nullptr;
    compilers.push_back(
        std::make_unique<Compiler>(CompilerContext{*program_, static_cast<FileIndex>(i), channel,
                                                   dialect_, names, *loaded_[i].reporter, watch_}));
  }
  // Included files stand behind those that include them, and their constants come first.
  for (std::size_t i = loaded_.size(); i-- > 0;) compilers[i]->declare_names(loaded_[i].tree);
  for (std::size_t i = 0; i < loaded_.size(); ++i) {
    compilers[i]->compile(loaded_[i].tree);
    tell_foreign_text(static_cast<FileIndex>(i));
  }
  if (program_->jumps) find_jump_targets();
}

void Loader::warn_of_foreign_parameters() {
  for (ForeignParameter& found : foreign_parameters(*program_)) {
    loaded_[found.file]
        .reporter->warning("W414", found.span, std::move(found.message), std::move(found.label))
        .help = std::move(found.help);
  }
}

void Loader::find_jump_targets() {
  for (std::size_t i = 0; i < loaded_.size(); ++i) {
    CompiledFile& file = *program_->files[i];
    BlockIndex index;
    index.read(file);
    file.block_index = std::move(index);
    for (const ConstantJump& jump : file.jumps) check_jump(static_cast<FileIndex>(i), jump);
  }
}

void Loader::check_jump(FileIndex index, const ConstantJump& jump) {
  const auto found = program_->files[index]->block_index.find(jump.number, jump.position);
  const auto fault = fault_of_jump(jump.number, found);
  if (!fault) return;
  Reporter& reporter = *loaded_[index].reporter;
  // Controls of Fanuc miss a block when they jump, not before: macros end so on wrong arguments.
  const bool when_reached = found.missing == BlockIndex::Missing::unknown &&
                            program_->files[index]->source.rules().is_fanuc();
  if (when_reached) {
    reporter.warning(fault->code, jump.span, fault->message, fault->label);
  } else {
    reporter.error(fault->code, jump.span, fault->message, fault->label);
  }
}

Expected<std::shared_ptr<const Program>, Diagnostics> Loader::result() {
  Diagnostics errors;
  Diagnostics warnings;
  for (LoadedFile& file : loaded_) {
    for (Diagnostic& diagnostic : file.reporter->take()) {
      if (file.included_at.line != 0)
        diagnostic.notes.push_back({"included here", file.included_at});
      const bool error = diagnostic.severity == Severity::error;
      (error ? errors : warnings).push_back(std::move(diagnostic));
    }
  }
  warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return program_;
}

}  // namespace stanok::lang
