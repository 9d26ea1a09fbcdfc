#include "jobs/tools/tool_conversion.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <set>
#include <utility>

#include "base/place.h"
#include "base/system_error.h"
#include "config/text/config_error.h"
#include "jobs/tools/tool_values.h"

namespace stanok::jobs {
namespace {

namespace fs = std::filesystem;
using channels::ToolEdge;

[[noreturn]] void refuse_file(const fs::path& file, const std::string& text) {
  throw config::ConfigError({{.file = file.string(), .text = text}});
}

std::optional<std::string> bytes_if_readable(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  return bytes_of_library(file);
}

// A format without edges has the first edge of a tool.
std::vector<ToolEdge> tools_of_format(const ExportRequest& request, ExportedTools& exported) {
  std::vector<ToolEdge> tools(request.tools.begin(), request.tools.end());
  std::ranges::stable_sort(tools, {},
                           [](const ToolEdge& tool) { return std::pair(tool.number, tool.edge); });
  if (request.format->numbers == ToolNumbers::number_and_edge) return tools;
  std::set<int> numbers;
  std::vector<ToolEdge> kept;
  for (const ToolEdge& tool : tools) {
    if (numbers.insert(tool.number).second) {
      kept.push_back(tool);
    } else {
      exported.not_carried.push_back({.tool = tool.number,
                                      .edge = tool.edge,
                                      .field = "tool",
                                      .value = tool.name,
                                      .reason = "the format has one edge for each tool"});
    }
  }
  return kept;
}

// The files that were written, instead of those on the disk.
ForeignTools read_back(const ExportRequest& request, const std::vector<ForeignFile>& files) {
  const ForeignFile& library = files.back();
  const auto written = [&files](const fs::path& file) -> std::optional<std::string> {
    const auto found =
        std::ranges::find(files, file.lexically_normal(),
                          [](const ForeignFile& one) { return one.file.lexically_normal(); });
    return found == files.end() ? std::nullopt : std::optional(found->bytes);
  };
  return request.format->read({.file = library.file,
                               .bytes = library.bytes,
                               .unit = request.choice.unit,
                               .cutter = request.choice.cutter,
                               .other_file = written});
}

void compare(const ToolEdge& tool, const ForeignTool* back, std::vector<NotCarried>& not_carried) {
  for (const ToolKey& key : config::tool_keys()) {
    const ToolEdge found = back == nullptr ? ToolEdge{} : back->edge;
    if (key.name == "number" || are_equal(tool, found, key)) continue;
    const std::string text = text_of(found, key);
    const bool is_lost = text == text_of(ToolEdge{}, key);
    not_carried.push_back(
        {.tool = tool.number,
         .edge = tool.edge,
         .field = std::string(key.name),
         .value = text_of(tool, key),
         .reason = is_lost ? "the format does not have it" : "written as " + text});
  }
}

}  // namespace

std::string bytes_of_library(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) {
    refuse_file(file, "cannot read the file: it is a directory; name the file in it");
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open()) {
    refuse_file(file, "cannot read the file: " + system_error_text(errno) + "; check the path");
  }
  std::string bytes(library_bytes_max + 1, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(checked_size(stream.gcount()));
  if (stream.bad()) {
    refuse_file(file, "cannot read the file: " + system_error_text(errno) + "; check the disk");
  }
  if (bytes.size() > library_bytes_max) {
    refuse_file(file, "longer than 64 MiB; a tool library is shorter: check the path");
  }
  return bytes;
}

ForeignTools import_tools(const ImportRequest& request) {
  return request.format->read({.file = request.file,
                               .bytes = bytes_of_library(request.file),
                               .unit = request.unit,
                               .cutter = request.cutter,
                               .other_file = &bytes_if_readable});
}

ExportedTools export_tools(const ExportRequest& request) {
  ExportedTools exported;
  const std::vector<ToolEdge> tools = tools_of_format(request, exported);
  if (tools.empty()) refuse_file(request.choice.file, "there are no tools to export");
  exported.tools = static_cast<int>(tools.size());
  exported.files = request.format->write(tools, request.choice);
  const ForeignTools back = read_back(request, exported.files);
  for (const ToolEdge& tool : tools) {
    const auto found = std::ranges::find_if(back.tools, [&](const ForeignTool& one) {
      return one.edge.number == tool.number &&
             (request.format->numbers == ToolNumbers::number || one.edge.edge == tool.edge);
    });
    compare(tool, found == back.tools.end() ? nullptr : &*found, exported.not_carried);
  }
  return exported;
}

}  // namespace stanok::jobs
