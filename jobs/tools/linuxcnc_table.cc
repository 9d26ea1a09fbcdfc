#include "jobs/tools/linuxcnc_table.h"

#include <algorithm>
#include <array>

#include "jobs/tools/foreign_reader.h"
#include "jobs/tools/foreign_text.h"

namespace stanok::jobs {
namespace {

using channels::ToolEdge;

struct TableWord {
  char letter = ' ';
  double value = 0.0;
  std::string_view text;  // of the value
  ForeignPlace place;
};

// Which key a letter fills. D is a diameter, half of which is the radius.
struct TableLetter {
  char letter;
  std::string_view key;
  double factor = 1.0;
};
constexpr std::array table_letters{
    TableLetter{'Z', "length"},      TableLetter{'X', "length_x"},
    TableLetter{'Y', "length_y"},    TableLetter{'D', "radius", 0.5},
    TableLetter{'I', "angle_front"}, TableLetter{'J', "angle_back"},
    TableLetter{'Q', "orientation"},
};
constexpr std::string_view lengths = "XYZUVWD";
constexpr std::string_view not_in_tables = "ABCUVW";

class TableReader {
 public:
  explicit TableReader(const ForeignSource& source)
      : reader_(source), unit_(source.unit.value_or(LengthUnit::mm)) {
    if (source.unit) return;
    reader_.remark(
        "the file does not state its unit: lengths are taken as mm; for a machine in inches give "
        "--unit inch");
  }

  void read_line(const TextLine& line) {
    const std::size_t end = line.text.find(';');
    const std::string_view words = line.text.substr(0, end);
    if (trimmed(words).empty()) return;
    const std::vector<TableWord> read = words_of(line.number, words);
    const auto number = std::ranges::find(read, 'T', &TableWord::letter);
    if (number == read.end()) {
      if (read.empty()) return;  // none of its words can be read
      reader_.fault({line.number, 1},
                    "no T word; each line begins with the number of its tool, as in T3 P3 D6 Z77.1 "
                    ";end mill");
      return;
    }
    const auto whole = whole_number_of_text(number->text);
    if (!whole) {
      reader_.fault(number->place, "T" + shortened(number->text) +
                                       " is not the number of a tool; write a whole number");
      return;
    }
    ForeignTool* tool = reader_.begin(*whole, 1, number->place);
    if (tool == nullptr) return;
    for (const TableWord& word : read) take(*tool, word);
    if (end != std::string_view::npos) take_comment(*tool, line.text.substr(end + 1));
    if (tool->edge.orientation != 0) reader_.give_text(*tool, "kind", "insert");
  }

  [[nodiscard]] ForeignTools finish() { return reader_.finish(); }

 private:
  std::vector<TableWord> words_of(unsigned line, std::string_view text) {
    std::vector<TableWord> words;
    constexpr std::string_view blanks = " \t\r\v\f";
    std::size_t begin = text.find_first_not_of(blanks);
    while (begin != std::string_view::npos) {
      const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
      take_word(line, begin, text.substr(begin, end - begin), words);
      begin = text.find_first_not_of(blanks, end);
    }
    return words;
  }

  void take_word(unsigned line, std::size_t begin, std::string_view text,
                 std::vector<TableWord>& words) {
    const ForeignPlace place{line, static_cast<unsigned>(begin) + 1};
    const char letter = text.front() >= 'a' && text.front() <= 'z'
                            ? static_cast<char>(text.front() - 'a' + 'A')
                            : text.front();
    if (std::string_view("TPXYZABCUVWDIJQ").find(letter) == std::string_view::npos) {
      reader_.fault(place, "'" + shortened(text) +
                               "' is no word of a tool table; the letters are T P X Y Z A B C U V "
                               "W D I J Q, and a comment begins with a semicolon");
      return;
    }
    const auto value = number_of_text(text.substr(1));
    if (!value) {
      reader_.fault(place, "'" + shortened(text) + "' has no number behind " + letter +
                               "; write one, as in " + letter + "1.5");
      return;
    }
    if (std::ranges::find(words, letter, &TableWord::letter) != words.end()) {
      reader_.fault(
          place, std::string("a second ") + letter + " in this line; leave the one that is meant");
      return;
    }
    words.push_back({letter, *value, text.substr(1), place});
  }

  void take(ForeignTool& tool, const TableWord& word) {
    if (word.letter == 'P' && word.value != tool.edge.number) {
      reader_.lose({.tool = tool.edge.number,
                    .field = "P",
                    .value = std::string(word.text),
                    .reason = "the tables have no pockets"});
    }
    if (not_in_tables.find(word.letter) != std::string_view::npos && word.value != 0.0) {
      reader_.lose({.tool = tool.edge.number,
                    .field = std::string(1, word.letter),
                    .value = std::string(word.text),
                    .reason = "a tool has lengths along X, Y and Z only"});
    }
    for (const TableLetter& row : table_letters) {
      if (row.letter != word.letter) continue;
      const bool is_length = lengths.find(word.letter) != std::string_view::npos;
      const double value = is_length ? mm_of(word.value, unit_) : word.value;
      reader_.give(tool, row.key, row.factor * value, word.place);
    }
  }

  void take_comment(ForeignTool& tool, std::string_view comment) {
    const std::string name = in_one_line(comment);
    if (!name.empty()) reader_.give_text(tool, "name", name);
  }

  ForeignReader reader_;
  LengthUnit unit_;
};

std::string line_of(const ToolEdge& tool, LengthUnit unit) {
  const std::string number = std::to_string(tool.number);
  std::string line = "T" + number + " P" + number;
  const auto add = [&](char letter, double value) {
    const std::string text = plain_number(value);
    line += std::string(" ") + letter + (text.starts_with('-') ? "" : "+") + text;
  };
  if (tool.length_x != 0.0) add('X', in_unit(tool.length_x, unit));
  if (tool.length_y != 0.0) add('Y', in_unit(tool.length_y, unit));
  add('Z', in_unit(tool.length, unit));
  add('D', in_unit(2.0 * tool.radius, unit));
  if (tool.angle_front != 0.0) add('I', tool.angle_front);
  if (tool.angle_back != 0.0) add('J', tool.angle_back);
  if (tool.orientation != 0) line += " Q" + std::to_string(tool.orientation);
  const std::string name = in_one_line(tool.name);
  return line + (name.empty() ? "" : " ;" + name) + "\n";
}

}  // namespace

ForeignTools read_linuxcnc_table(const ForeignSource& source) {
  const std::string text = text_of(source);
  TableReader reader(source);
  for (const TextLine& line : lines_of(text)) reader.read_line(line);
  return reader.finish();
}

std::vector<ForeignFile> write_linuxcnc_table(std::span<const ToolEdge> tools,
                                              const WriteChoice& choice) {
  std::string text;
  for (const ToolEdge& tool : tools) text += line_of(tool, choice.unit);
  return {{choice.file, text}};
}

}  // namespace stanok::jobs
