// Loads a program: finds its files, parses and compiles them, and collects what there is to say.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/program/compile.h"
#include "lang/program/compiler.h"
#include "lang/program/program.h"
#include "lang/text/compile_watch.h"
#include "lang/text/reporter.h"
#include "lang/tree/tree.h"

namespace stanok::lang {

class Loader {
 public:
  // All outlive it.
  Loader(const Files& files, const ChannelDescription* channel, Diagnostics& warnings,
         const Interruption& interrupted);

  [[nodiscard]] Expected<std::shared_ptr<const Program>, Diagnostics> load(std::string_view name);
  // One statement; `files` has the texts of `loaded` as they were read.
  [[nodiscard]] Expected<std::shared_ptr<const Program>, Diagnostics> load_line(
      std::string_view line, const Program* loaded);

 private:
  using FileIndex = std::uint16_t;

  // A file while it is loaded; parallel to Program::files.
  struct LoadedFile {
    std::unique_ptr<Reporter> reporter;
    StatementList tree;
    std::set<std::string> subprograms;  // that the tree defines, by label
    std::set<int> programs;             // likewise, by number
    Place included_at;                  // line 0: the program itself
    bool includes_engraving = false;    // first in the tree, though nothing says so
  };

  // Index of the file that `from` calls `name`; reads and registers it. Nothing with `failure_` set
  // when it cannot be read.
  std::optional<FileIndex> find_file(std::string_view name, FileIndex from);
  FileIndex add_file(std::shared_ptr<const SourceText> text);
  // Why the program cannot take one more file of that length; nothing: it can.
  [[nodiscard]] std::optional<Diagnostic> refusal_of_file(const SourceText& text) const;
  void find_all_files();
  void include_loaded(const Program& loaded);
  void check_line(std::string_view line);
  void check_calls_of_line();
  void forget_warnings_of_loaded();
  void parse(FileIndex index);
  static void list_definitions(LoadedFile& file);
  void follow_includes(FileIndex index);
  void follow_include(FileIndex index, const Statement& statement,
                      const IncludeDirective& directive);
  void follow_blanks(FileIndex index, const StatementList& list);
  void follow_blank(FileIndex index, const WorkpieceDirective& directive);
  void follow_calls(FileIndex index, const StatementList& list);
  void follow_call(FileIndex index, const CallStatement& statement);
  void follow_subprograms(FileIndex index, const StatementList& list);
  void follow_user_codes(FileIndex index, const IsoBlock& block);
  void follow_o_call(FileIndex index, const OCall& call);
  bool follow_number(FileIndex index, int number, SearchedTexts texts);
  std::optional<FileIndex> first_file_of(const std::vector<std::string>& names, FileIndex from);
  void check_end(FileIndex index);
  // One error for all where the text is written for a control that is not read here.
  void tell_foreign_text(FileIndex index);
  void compile_all();
  void find_jump_targets();
  void warn_of_foreign_parameters();
  void check_jump(FileIndex index, const ConstantJump& jump);
  Expected<std::shared_ptr<const Program>, Diagnostics> result();

  const Files& files_;
  const ChannelDescription* channel_;
  const ChannelDialect dialect_;
  Diagnostics& warnings_;
  CompileWatch watch_;
  const TextRules rules_;  // of texts that do not say otherwise
  std::shared_ptr<Program> program_;
  std::vector<LoadedFile> loaded_;
  std::size_t bytes_ = 0;                    // of all files
  std::set<std::string> functions_of_line_;  // that an operator's line may call
  std::map<std::string, FileIndex> index_by_path_;
  std::map<std::pair<FileIndex, std::string>, Diagnostic> failures_;
};

}  // namespace stanok::lang
