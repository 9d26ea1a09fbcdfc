#include "lang/run/call_targets.h"

#include <vector>

namespace stanok::lang {
namespace {

std::optional<NumberedProgramPlace> numbered_program_in(const Program& program, std::uint16_t file,
                                                        int number) {
  const auto& programs = program.files[file]->numbered_programs;
  const auto found = programs.find(number);
  if (found == programs.end()) return std::nullopt;
  return NumberedProgramPlace{file, found->second, false};
}

NumberedProgramSearch find_in_texts(const Program& program, std::uint16_t caller, int number) {
  NumberedProgramSearch search;
  search.place = numbered_program_in(program, caller, number);
  if (search.place) return search;
  for (const std::uint16_t candidate : program.files[caller]->includes) {
    const auto found = numbered_program_in(program, candidate, number);
    if (!found || (search.place && search.place->file == candidate)) continue;
    if (search.place) {
      search.rivals = {search.place->file, candidate};
      search.place.reset();
      return search;
    }
    search.place = found;
  }
  return search;
}

}  // namespace

NumberedProgramSearch find_numbered_program(const Program& program, std::uint16_t caller,
                                            int number, SearchedTexts texts) {
  NumberedProgramSearch search;
  if (texts == SearchedTexts::all) search = find_in_texts(program, caller, number);
  if (search.place || search.rivals) return search;
  const auto file = program.file_by_number.find({caller, number});
  if (file == program.file_by_number.end()) return search;
  search.place = numbered_program_in(program, file->second, number);
  if (!search.place) search.place = NumberedProgramPlace{file->second, 0, false};
  search.place->other_file = true;
  return search;
}

std::optional<Callee> find_o_subprogram(const Program& program, std::uint16_t caller,
                                        const std::string& label) {
  std::vector<std::uint16_t> candidates{caller};
  const auto& includes = program.files[caller]->includes;
  candidates.insert(candidates.end(), includes.begin(), includes.end());
  for (const std::uint16_t candidate : candidates) {
    const auto& known = program.files[candidate]->o_subprograms;
    const auto found = known.find(label);
    if (found != known.end()) return Callee{candidate, found->second};
  }
  return std::nullopt;
}

}  // namespace stanok::lang
