// What is made of virtual workpieces: STL files, pictures, findings and volumes as text and JSON.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "simulation/removed_volume.h"

namespace stanok::client {

struct WorkpieceFiles {
  std::string stl;      // "": none
  std::string picture;  // PNG
  std::string report;   // JSON with every block

  [[nodiscard]] bool is_wanted() const {
    return !stl.empty() || !picture.empty() || !report.empty();
  }
};

// A workpiece and what people call it by.
struct NamedWorkpiece {
  const simulation::Workpiece* workpiece = nullptr;
  std::string title;
  simulation::Removal removal;
};

// The name of the program file that a motion comes from.
using FileNames = std::function<std::string(const simulation::Origin&)>;

// Writes what is wanted of all of them; those behind the first get a number before the ending:
// part.stl, part.2.stl. What cannot be written stands in the result, one line each.
[[nodiscard]] std::vector<std::string> write_files(const std::vector<NamedWorkpiece>& workpieces,
                                                   const WorkpieceFiles& files,
                                                   const FileNames& name_of);

// The first name, or the one with the number of the piece, from 1.
[[nodiscard]] std::string numbered(const std::string& file, std::size_t number);

// The main program that cuts it, or "channel 1".
[[nodiscard]] std::string title_of(const simulation::Workpiece& workpiece, const FileNames& name_of,
                                   int channel);
[[nodiscard]] nlohmann::ordered_json to_json(const NamedWorkpiece& named, const FileNames& name_of);

// One line to stderr: "error[E9203]: channel 1: ..."; channel 0: none.
void complain(int channel, const std::string& code, const std::string& text);

// The first findings to stderr as warnings, volumes to stdout.
void print(const std::vector<NamedWorkpiece>& workpieces, const FileNames& name_of);
void print_findings(const simulation::Workpiece& workpiece, const FileNames& name_of);

}  // namespace stanok::client
