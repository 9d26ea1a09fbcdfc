#include "client/offline/workpiece/workpiece_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "base/diagnostic.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/output.h"
#include "simulation/offcuts.h"
#include "simulation/picture/part_picture.h"
#include "simulation/picture/stl_file.h"

namespace stanok::client {
namespace {

using simulation::BlockRemoval;
using simulation::Finding;
using simulation::Workpiece;

constexpr std::size_t findings_shown = 20;
constexpr std::size_t marks_max = 40;
constexpr double mark_distance = 4.0;  // mm

nlohmann::ordered_json array_of(const simulation::Vector& v) {
  return {v.x(), v.y(), v.z()};
}

// In the frame of the program that announced the blank.
simulation::Vector in_program(const Workpiece& workpiece, const simulation::Vector& place_K) {
  return place_K - workpiece.blank().zero;
}

nlohmann::ordered_json finding_json(const Finding& finding, const Workpiece& workpiece,
                                    const FileNames& name_of) {
  return {{"code", simulation::code_of(finding.kind)},
          {"text", simulation::text_of(finding.kind)},
          {"file", name_of(finding.origin)},
          {"line", finding.origin.line},
          {"block", finding.origin.block},
          {"tool", finding.tool},
          {"time_s", finding.time_s},
          {"place", array_of(in_program(workpiece, finding.place_K))},
          {"volume_mm3", finding.volume_mm3}};
}

nlohmann::ordered_json block_json(const BlockRemoval& block, const FileNames& name_of) {
  return {{"file", name_of(block.origin)},
          {"line", block.origin.line},
          {"run", block.origin.run},
          {"block", block.origin.block},
          {"volume_mm3", block.volume_mm3},
          {"time_s", block.time_s},
          {"rate_mm3_per_s", block.rate_mm3_per_s()}};
}

double rate_max(const std::vector<BlockRemoval>& blocks) {
  double rate = 0.0;
  for (const BlockRemoval& block : blocks) rate = std::max(rate, block.rate_mm3_per_s());
  return rate;
}

// Places of findings, one for those that are close together.
std::vector<simulation::Vector> marks_of(const Workpiece& workpiece) {
  std::vector<simulation::Vector> marks;
  for (const Finding& finding : workpiece.report().findings()) {
    const bool is_marked = std::ranges::any_of(marks, [&](const simulation::Vector& mark) {
      return (mark - finding.place_K).norm() < mark_distance;
    });
    if (!is_marked && marks.size() < marks_max) marks.push_back(finding.place_K);
  }
  return marks;
}

simulation::PictureLabels labels_of(const NamedWorkpiece& named,
                                    const simulation::Offcuts& offcuts) {
  const Workpiece& workpiece = *named.workpiece;
  simulation::PictureLabels labels;
  labels.title = named.title;
  labels.facts = {fmt::format("resolution {:g} mm, {} findings", workpiece.blank().resolution,
                              workpiece.report().findings().size()),
                  fmt::format("removed {:.1f} cm³ of {:.1f} cm³", named.removal.volume_mm3 / 1000.0,
                              volume_of(workpiece.blank()) / 1000.0)};
  if (offcuts.count > 0) {
    labels.facts.push_back(fmt::format(
        "{} not shown: {:.1f} cm³",
        offcuts.count == 1 ? "one offcut is" : fmt::format("{} offcuts are", offcuts.count),
        offcuts.volume_mm3 / 1000.0));
  }
  labels.marks = marks_of(workpiece);
  return labels;
}

std::string write_report(const NamedWorkpiece& named, const FileNames& name_of,
                         const std::string& file) {
  nlohmann::ordered_json json = to_json(named, name_of);
  json["blocks"] = nlohmann::ordered_json::array();
  for (const BlockRemoval& block : named.removal.blocks)
    json["blocks"].push_back(block_json(block, name_of));
  std::ofstream stream(file);
  stream << protocol::json_text(json, protocol::JsonLayout::indented) << '\n';
  stream.close();
  return stream ? "" : file + ": cannot be written";
}

}  // namespace

void complain(int channel, const std::string& code, const std::string& text) {
  const std::string place = channel == 0 ? "" : "channel " + std::to_string(channel) + ": ";
  const char* word = code.front() == 'W' ? "warning" : "error";
  write_message(fmt::format("{}[{}]: {}{}\n", word, code, place, text));
}

std::string numbered(const std::string& file, std::size_t number) {
  if (number == 1) return file;
  const std::filesystem::path path(file);
  return path.parent_path() /
         (path.stem().string() + "." + std::to_string(number) + path.extension().string());
}

std::string title_of(const Workpiece& workpiece, const FileNames& name_of, int channel) {
  const std::vector<BlockRemoval> blocks = workpiece.report().blocks();
  std::string title;
  if (!blocks.empty()) {
    simulation::Origin main = blocks.front().origin;
    main.file = 0;
    title = name_of(main);
  }
  return title.empty() ? "channel " + std::to_string(channel) : title;
}

nlohmann::ordered_json to_json(const NamedWorkpiece& named, const FileNames& name_of) {
  const Workpiece& workpiece = *named.workpiece;
  const auto& [removed_mm3, blocks] = named.removal;
  nlohmann::ordered_json json = {{"blank", array_of(workpiece.blank().size)},
                                 {"resolution_mm", workpiece.blank().resolution},
                                 {"blank_mm3", volume_of(workpiece.blank())},
                                 {"removed_mm3", removed_mm3},
                                 {"left_mm3", volume_of(workpiece.blank()) - removed_mm3},
                                 {"blocks_cutting", blocks.size()},
                                 {"rate_max_mm3_per_s", rate_max(blocks)}};
  json["findings"] = nlohmann::ordered_json::array();
  for (const Finding& finding : workpiece.report().findings())
    json["findings"].push_back(finding_json(finding, workpiece, name_of));
  return json;
}

std::vector<std::string> write_files(const std::vector<NamedWorkpiece>& workpieces,
                                     const WorkpieceFiles& files, const FileNames& name_of) {
  std::vector<std::string> failures;
  const auto note = [&](const std::string& failure) {
    if (!failure.empty()) failures.push_back(failure);
  };
  for (std::size_t i = 0; i < workpieces.size(); ++i) {
    const Workpiece& workpiece = *workpieces[i].workpiece;
    if (!files.report.empty())
      note(write_report(workpieces[i], name_of, numbered(files.report, i + 1)));
    if (files.stl.empty() && files.picture.empty()) continue;
    simulation::Mesh mesh = surface_of(workpiece.material());
    const simulation::Offcuts offcuts = take_off_offcuts(mesh);
    if (!files.stl.empty())
      note(write_stl(mesh, numbered(files.stl, i + 1), "stanok " + workpieces[i].title));
    if (!files.picture.empty()) {
      note(draw_part(mesh, workpiece.blank(), workpiece.material().grid(),
                     labels_of(workpieces[i], offcuts), numbered(files.picture, i + 1)));
    }
  }
  return failures;
}

void print_findings(const Workpiece& workpiece, const FileNames& name_of) {
  const std::vector<Finding> findings = workpiece.report().findings();
  for (std::size_t i = 0; i < std::min(findings.size(), findings_shown); ++i) {
    const Finding& finding = findings[i];
    const simulation::Vector place = in_program(workpiece, finding.place_K);
    Diagnostic diagnostic;
    diagnostic.code = simulation::code_of(finding.kind);
    diagnostic.severity = Severity::warning;
    diagnostic.place.file = name_of(finding.origin);
    diagnostic.place.line = static_cast<int>(finding.origin.line);
    diagnostic.message = fmt::format("{}: {:.2f} mm³, tool {} at X {:.2f} Y {:.2f} Z {:.2f}",
                                     simulation::text_of(finding.kind), finding.volume_mm3,
                                     finding.tool, place.x(), place.y(), place.z());
    print(diagnostic);
  }
  if (findings.size() > findings_shown) {
    write_message(fmt::format("{} more findings; --workpiece-report has all of them\n",
                              findings.size() - findings_shown));
  }
}

void print(const std::vector<NamedWorkpiece>& workpieces, const FileNames& name_of) {
  for (const NamedWorkpiece& named : workpieces) {
    const Workpiece& workpiece = *named.workpiece;
    print_findings(workpiece, name_of);
    const auto& [removed_mm3, blocks] = named.removal;
    write_data(
        fmt::format("workpiece of {}: removed {:.2f} of {:.2f} mm³ in {} blocks, at most {:.1f} "
                    "mm³/s, {} findings\n",
                    named.title, removed_mm3, volume_of(workpiece.blank()), blocks.size(),
                    rate_max(blocks), workpiece.report().findings().size()));
  }
}

}  // namespace stanok::client
