#include "client/offline/tools/tool_library_commands.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/offline/library/whole_file.h"
#include "client/offline/tools/tool_library_report.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/noun_command.h"
#include "client/terminal/output.h"
#include "config/files/tables_file.h"
#include "jobs/tools/tables_text.h"
#include "jobs/tools/tool_conversion.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using jobs::ToolFormat;
using nlohmann::ordered_json;

struct ToolLibraryOptions {
  std::string file;
  std::string format;
  std::string unit;
  std::string cutter;
  std::string output;
  std::string into;
  bool replace = false;
  bool offsets_only = false;
  bool force = false;
  bool json = false;
};

std::optional<jobs::LengthUnit> unit_of(const ToolLibraryOptions& options) {
  if (options.unit.empty()) return std::nullopt;
  return options.unit == "inch" ? jobs::LengthUnit::inch : jobs::LengthUnit::mm;
}

std::optional<jobs::CutterSize> cutter_of(const ToolLibraryOptions& options) {
  if (options.cutter.empty()) return std::nullopt;
  return options.cutter == "radius" ? jobs::CutterSize::radius : jobs::CutterSize::diameter;
}

[[noreturn]] void refuse_format(const std::string& text, const std::string& formats) {
  throw CLI::ValidationError("--format", text + "; the formats are " + formats);
}

const ToolFormat& format_of(const ToolLibraryOptions& options, const std::string& file,
                            const std::string& formats) {
  if (!options.format.empty()) {
    const ToolFormat* named = jobs::tool_format_named(options.format);
    if (named == nullptr) refuse_format("there is no format '" + options.format + "'", formats);
    return *named;
  }
  const ToolFormat* found = file.empty() ? nullptr : jobs::tool_format_of(file);
  if (found == nullptr) {
    refuse_format(file.empty() ? "name the format"
                               : "the name of " + file +
                                     " does not tell the "
                                     "format: name it",
                  formats);
  }
  return *found;
}

void refuse_to_overwrite(const ToolLibraryOptions& options, const fs::path& file) {
  std::error_code error;
  if (options.force || !fs::exists(file, error)) return;
  throw std::runtime_error(file.string() + " exists; --force replaces it");
}

void write_file(const fs::path& file, const std::string& bytes) {
  if (!write_whole(file, bytes)) {
    throw std::runtime_error("cannot write " + file.string() + "; check folder and permissions");
  }
}

void print_remarks(const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) write_message("note: " + remark + "\n");
}

// Where the imported tools went, in words.
std::string written_text(const ToolLibraryOptions& options, const jobs::ForeignTools& found,
                         const jobs::MergedTables& merged) {
  const std::string& file = options.into.empty() ? options.output : options.into;
  if (options.into.empty()) {
    return fmt::format("{}: {} tools from {}\n", file, found.tools.size(), options.file);
  }
  return fmt::format("{}: {} tools added, {} replaced, from {}\n", file, merged.added,
                     merged.replaced, options.file);
}

void report_import(const ToolLibraryOptions& options, const ToolFormat& format,
                   const jobs::ForeignTools& found, const jobs::MergedTables& merged) {
  const bool is_printed = options.output.empty() && options.into.empty();
  if (options.json) {
    ordered_json json{{"ok", true}, {"format", format.name}, {"tools", found.tools.size()}};
    json["added"] = merged.added;
    json["replaced"] = merged.replaced;
    if (is_printed) json["tables"] = merged.text;
    if (!is_printed) json["written"] = options.into.empty() ? options.output : options.into;
    json["not_carried"] = to_json(found.not_carried);
    json["remarks"] = found.remarks;
    write_json(json);
    return;
  }
  if (is_printed) write_data(merged.text);
  print_remarks(found.remarks);
  write_message(to_text(found.not_carried));
  if (!is_printed) write_message(written_text(options, found, merged));
}

// What the tables file will be.
jobs::MergedTables tables_of(const ToolLibraryOptions& options, const jobs::ForeignTools& found) {
  std::error_code error;
  if (!options.into.empty() && fs::exists(options.into, error)) {
    return jobs::merged_tables(
        jobs::bytes_of_library(options.into), options.into, found.tools,
        options.replace ? jobs::EqualNumbers::replace : jobs::EqualNumbers::refuse);
  }
  return {.text = jobs::tables_text(found.tools),
          .added = static_cast<int>(found.tools.size()),
          .replaced = 0};
}

void import_library(const ToolLibraryOptions& options) {
  const ToolFormat& format = format_of(options, options.file, jobs::names_of_readable_formats());
  if (!options.output.empty()) refuse_to_overwrite(options, options.output);
  jobs::ForeignTools found = jobs::import_tools({.file = options.file,
                                                 .format = &format,
                                                 .unit = unit_of(options),
                                                 .cutter = cutter_of(options)});
  if (options.offsets_only) jobs::keep_offsets(found.tools);
  const jobs::MergedTables merged = tables_of(options, found);
  if (!options.output.empty()) write_file(options.output, merged.text);
  if (!options.into.empty()) write_file(options.into, merged.text);
  report_import(options, format, found, merged);
}

void write_library(const ToolLibraryOptions& options, const std::vector<jobs::ForeignFile>& files) {
  for (const jobs::ForeignFile& file : files) refuse_to_overwrite(options, file.file);
  for (const jobs::ForeignFile& file : files) write_file(file.file, file.bytes);
}

void report_export(const ToolLibraryOptions& options, const ToolFormat& format,
                   const jobs::ExportedTools& exported) {
  if (options.json) {
    auto written = ordered_json::array();
    if (!options.output.empty()) {
      for (const jobs::ForeignFile& file : exported.files) written.push_back(file.file.string());
    }
    ordered_json json{{"ok", true}, {"format", format.name}, {"tools", exported.tools}};
    if (options.output.empty()) json["text"] = exported.files.front().bytes;
    json["written"] = std::move(written);
    json["not_carried"] = to_json(exported.not_carried);
    write_json(json);
    return;
  }
  if (options.output.empty()) write_data(exported.files.front().bytes);
  write_message(to_text(exported.not_carried));
  if (!options.output.empty()) {
    write_message(
        fmt::format("{}: {} tools from {}\n", options.output, exported.tools, options.file));
  }
}

void export_library(const ToolLibraryOptions& options) {
  const ToolFormat& format = format_of(options, options.output, jobs::names_of_writable_formats());
  if (format.write == nullptr) {
    refuse_format("'" + options.format + "' is only read", jobs::names_of_writable_formats());
  }
  const std::string text = jobs::bytes_of_library(options.file);
  const std::vector<channels::ToolEdge> tools = config::read_tools_text(text, options.file);
  const fs::path output = options.output.empty() ? fs::path(options.file).replace_extension()
                                                 : fs::path(options.output);
  const jobs::ExportedTools exported =
      jobs::export_tools({.tools = tools,
                          .format = &format,
                          .choice = {.file = output,
                                     .unit = unit_of(options).value_or(jobs::LengthUnit::mm),
                                     .cutter = cutter_of(options)}});
  if (options.output.empty() && exported.files.size() > 1) {
    throw CLI::ValidationError("--output", "this format has a file for each tool: name a file");
  }
  if (!options.output.empty()) write_library(options, exported.files);
  report_export(options, format, exported);
}

// Faults of files are the answer with --json, else a message of main.
int answered(const ToolLibraryOptions& options, void (*convert)(const ToolLibraryOptions&)) {
  if (!options.json) {
    convert(options);
    return 0;
  }
  try {
    convert(options);
    return 0;
  } catch (const config::ConfigError& error) {
    write_json(refusal_json(error));
    return exit_failed;
  }
}

using Convert = void (*)(const ToolLibraryOptions&);

CLI::App& add_conversion(CLI::App& app, int& exit_code, const char* verb, const char* help,
                         const std::shared_ptr<ToolLibraryOptions>& options, Convert convert) {
  CLI::App* command = noun_command(app, "tool", "the tool table").add_subcommand(verb, help);
  command->add_option("--unit", options->unit, "unit of lengths in a file that does not state it")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "inch"}));
  command
      ->add_option("--cutter", options->cutter,
                   "what an offset listing of a control has: radius or diameter of the cutter")
      ->type_name("SIZE")
      ->check(CLI::IsMember({"radius", "diameter"}));
  command->add_flag("--force", options->force, "replace the file of --output if it exists");
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, convert, &exit_code] { exit_code = answered(*options, convert); });
  return *command;
}

}  // namespace

void add_tool_library_commands(CLI::App& app, int& exit_code) {
  const auto imported = std::make_shared<ToolLibraryOptions>();
  CLI::App& import_command =
      add_conversion(app, exit_code, "import",
                     "convert a tool library of another program or control to a tables file",
                     imported, &import_library);
  import_command.add_option("LIBRARY", imported->file, "tool library to read")
      ->type_name("FILE")
      ->required();
  import_command
      .add_option("--format", imported->format,
                  "format of the library, if the name of the file does not tell: " +
                      jobs::names_of_readable_formats())
      ->type_name("FORMAT");
  CLI::Option* output =
      import_command.add_option("--output", imported->output, "tables file to write")
          ->type_name("FILE");
  import_command
      .add_option("--into", imported->into,
                  "tables file to which the tools are added; it is created if it does not exist")
      ->type_name("FILE")
      ->excludes(output);
  import_command.add_flag("--replace", imported->replace,
                          "with --into: tools that the tables file has get the imported values");

  import_command.add_flag(
      "--offsets-only", imported->offsets_only,
      "leave out names and shapes, which `tool load` cannot change in a running daemon");

  const auto exported = std::make_shared<ToolLibraryOptions>();
  CLI::App& export_command =
      add_conversion(app, exit_code, "export",
                     "convert a tables file to a tool library of another program or control",
                     exported, &export_library);
  export_command.add_option("TABLES", exported->file, "tables file, as of `tool save`")
      ->type_name("FILE")
      ->required();
  export_command
      .add_option("--format", exported->format,
                  "format of the library, if the name of --output does not tell: " +
                      jobs::names_of_writable_formats())
      ->type_name("FORMAT");
  export_command.add_option("--output", exported->output, "tool library to write")
      ->type_name("FILE");
}

}  // namespace stanok::client
