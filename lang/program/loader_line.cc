// One line of an operator as a program of its own that includes the loaded program.
#include <algorithm>

#include "lang/program/loader.h"
#include "lang/tree/parser.h"

namespace stanok::lang {
namespace {

constexpr std::string_view line_name = "MDI";

bool defines_functions(const CompiledFile& file) {
  return !file.functions.empty();
}

// O-lines, also those that the parser makes into ordinary statements.
bool is_o_line(std::string_view line) {
  const std::size_t start = std::min(line.find_first_not_of(" \t"), line.size());
  if (start + 1 >= line.size()) return false;
  if (line[start] == ':') return is_digit(line[start + 1]);
  if (upper_case(line[start]) != 'O') return false;
  return is_digit(line[start + 1]) || line[start + 1] == '<' || line[start + 1] == '[';
}

}  // namespace

Expected<std::shared_ptr<const Program>, Diagnostics> Loader::load_line(std::string_view line,
                                                                        const Program* loaded) {
  add_file(std::make_shared<SourceText>(
      SourceText{std::string(line_name), std::string(), std::string(line)}));
  if (loaded != nullptr) include_loaded(*loaded);
  find_all_files();
  check_line(line);
  compile_all();
  check_calls_of_line();
  forget_warnings_of_loaded();
  return result();
}

// The functions of the loaded program and of what it includes; a program without any is not read
// again.
void Loader::include_loaded(const Program& loaded) {
  const CompiledFile& main = *loaded.files[0];
  const auto offers = [&](std::uint16_t file) { return defines_functions(*loaded.files[file]); };
  if (!offers(0) && std::none_of(main.includes.begin(), main.includes.end(), offers)) return;
  std::vector<std::uint16_t> offering{0};
  offering.insert(offering.end(), main.includes.begin(), main.includes.end());
  for (const std::uint16_t file : offering) {
    const Source& source = loaded.files[file]->source;
    functions_of_line_.merge(defined_functions(source));
    program_->files[0]->includes.push_back(add_file(source.shared_text()));
  }
}

void Loader::check_line(std::string_view line) {
  Reporter& reporter = *loaded_[0].reporter;
  const StatementList& tree = loaded_[0].tree;
  const std::size_t one = loaded_[0].includes_engraving ? 2 : 1;
  const Span whole{0, static_cast<std::uint32_t>(line.size()), 1};
  const bool calls = tree.size() == one && std::holds_alternative<OCall>(tree.back().kind);
  if (is_o_line(line) && !calls) {
    reporter.error("E2092", whole, "`call` is the only O-line that is allowed in a single line",
                   "write a program");
    return;
  }
  if (line.find_first_of("\n\r") != std::string_view::npos || tree.size() > one) {
    reporter.error("E2091", whole, "this is more than one statement",
                   "one complete statement at a time");
    return;
  }
  if (tree.empty()) {
    if (reporter.error_count() == 0)
      reporter.error("E2091", whole, "there is no statement here", "nothing to execute");
    return;
  }
  const Statement& only = tree.back();
  const bool defines = std::holds_alternative<FunctionDefinition>(only.kind);
  if (defines || std::holds_alternative<IncludeDirective>(only.kind)) {
    reporter.error(
        "E2092", only.span,
        std::string(defines ? "a function" : "#include") + " is not allowed in a single line",
        "write it in a program");
  }
}

// They were shown when the program was loaded.
void Loader::forget_warnings_of_loaded() {
  for (std::size_t i = 1; i < loaded_.size(); ++i) {
    for (Diagnostic& diagnostic : loaded_[i].reporter->take()) {
      if (diagnostic.severity == Severity::error) loaded_[i].reporter->add(std::move(diagnostic));
    }
  }
}

// An operator would wait for a channel with his own hands bound.
void Loader::check_calls_of_line() {
  const CompiledFile& file = *program_->files[0];
  for (std::size_t i = 0; i < file.code.size(); ++i) {
    const Instruction& instruction = file.code[i];
    if (instruction.op != Op::request) continue;
    if (builtins()[instruction.operand].request != RequestKind::channel_wait) continue;
    loaded_[0].reporter->error("E2092", file.spans[i],
                               "channel_wait is not allowed in a single line", "write a program");
  }
}

}  // namespace stanok::lang
