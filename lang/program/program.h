// A compiled program: the code of its file and of all files it includes or calls.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lang/contract/blank_file.h"
#include "lang/program/code.h"
#include "lang/program/compile.h"
#include "lang/words/named_parameter.h"

namespace stanok::lang {

// Where numbered programs are looked for; M198 looks for files only.
enum class SearchedTexts { all, files_only };

// The STL file of a blank, and where it was found.
struct FoundBlank {
  std::string path;
  BlankFile file;
};

class Program {
 public:
  std::vector<std::unique_ptr<CompiledFile>> files;  // 0 is the program itself
  // (file that names, name as written) -> file; for includes and `call`
  std::map<std::pair<std::uint16_t, std::string>, std::uint16_t> file_by_name;
  // (file that calls, label of an O-line) -> file found for it
  std::map<std::pair<std::uint16_t, std::string>, std::uint16_t> file_by_label;
  // (file that calls, number of M98, G65, M198) -> file found for it
  std::map<std::pair<std::uint16_t, int>, std::uint16_t> file_by_number;
  // program of a user code, as the machine file names it -> file
  std::map<std::string, std::uint16_t> file_by_macro;
  // (file with #workpiece, name of the STL file as written) -> what was found
  std::map<std::pair<std::uint16_t, std::string>, FoundBlank> blanks;
  NamedParameters named_parameters;
  std::vector<ConstantDispatch> dispatches;
  bool jumps = false;  // some text of it goes to block numbers
};

}  // namespace stanok::lang
