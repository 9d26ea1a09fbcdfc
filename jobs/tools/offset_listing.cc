#include "jobs/tools/offset_listing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/utf8.h"
#include "jobs/tools/foreign_reader.h"
#include "jobs/tools/foreign_text.h"

namespace stanok::jobs {
namespace {

using channels::ToolEdge;

// The number behind L.
struct OffsetRegister {
  int number;
  std::string_view key;
  double ToolEdge::* value;
  enum class Of : std::uint8_t { length, cutter } of;
};
constexpr std::array offset_registers{
    OffsetRegister{10, "length", &ToolEdge::length, OffsetRegister::Of::length},
    OffsetRegister{11, "wear_length", &ToolEdge::wear_length, OffsetRegister::Of::length},
    OffsetRegister{12, "radius", &ToolEdge::radius, OffsetRegister::Of::cutter},
    OffsetRegister{13, "wear_radius", &ToolEdge::wear_radius, OffsetRegister::Of::cutter},
};

struct ListingWord {
  char letter;
  std::string_view text;  // of its number
  ForeignPlace place;
};

double share_of_radius(CutterSize cutter) {
  return cutter == CutterSize::diameter ? 0.5 : 1.0;
}

class ListingReader {
 public:
  ListingReader(const ForeignSource& source, CutterSize usual)
      : reader_(source), unit_(source.unit), cutter_(source.cutter.value_or(usual)) {
    if (source.cutter) return;
    const bool is_radius = usual == CutterSize::radius;
    reader_.remark("the listing does not state what L12 and L13 are: they are taken as " +
                   std::string(is_radius ? "radii" : "diameters") + "; otherwise give --cutter " +
                   (is_radius ? "diameter" : "radius"));
  }

  void read_line(const TextLine& line) {
    words_.clear();
    std::string comment;
    if (!split(line, comment)) return;
    const bool is_offset = has_g(10);
    for (const ListingWord& word : words_) read_word(word);
    if (is_offset) read_offset(line, comment);
  }

  [[nodiscard]] ForeignTools finish() {
    if (!unit_ && has_offsets_) {
      reader_.remark(
          "the listing has no G20 or G21: lengths are taken as mm; for inches give --unit inch");
    }
    return reader_.finish();
  }

 private:
  [[nodiscard]] LengthUnit unit() const { return unit_.value_or(LengthUnit::mm); }

  // Words and comment of a line; false, and a fault, where it is no line of a program.
  bool split(const TextLine& line, std::string& comment) {
    const std::string_view text = line.text;
    std::size_t at = 0;
    while (at < text.size()) {
      const char letter = upper(text[at]);
      const ForeignPlace place{line.number,
                               static_cast<unsigned>(character_count(text.substr(0, at))) + 1};
      if (letter == '(') {
        const std::size_t end = std::min(text.find(')', at), text.size());
        comment = in_one_line(text.substr(at + 1, end - at - 1));
        at = std::min(end + 1, text.size());
      } else if (letter >= 'A' && letter <= 'Z') {
        const std::size_t begin = text.find_first_not_of(" \t", at + 1);
        const std::size_t from = std::min(begin, text.size());
        const std::size_t end =
            std::min(text.find_first_not_of("0123456789+-.", from), text.size());
        words_.push_back({letter, text.substr(from, end - from), place});
        at = end;
      } else if (std::string_view(" \t%;/:").find(letter) != std::string_view::npos) {
        ++at;
      } else if (letter >= '0' && letter <= '9') {
        at = std::min(text.find_first_not_of("0123456789", at), text.size());  // :0001, /2
      } else {
        reader_.fault(place, "'" + shortened(text.substr(at, 20)) +
                                 "' is not part of an offset listing; its lines are as in "
                                 "G10 L10 P1 R77.125");
        return false;
      }
    }
    return true;
  }

  static char upper(char letter) {
    return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  }

  [[nodiscard]] const ListingWord* word(char letter) const {
    const auto found = std::ranges::find(words_, letter, &ListingWord::letter);
    return found == words_.end() ? nullptr : &*found;
  }

  [[nodiscard]] bool has_g(int number) const {
    return std::ranges::any_of(words_, [&](const ListingWord& word) {
      return word.letter == 'G' && number_of_text(word.text) == number;
    });
  }

  void read_word(const ListingWord& word) {
    const auto number = number_of_text(word.text);
    if (word.letter == 'G' && number == 20) unit_ = LengthUnit::inch;
    if (word.letter == 'G' && number == 21) unit_ = LengthUnit::mm;
    if (word.letter == 'G' && number == 91) {
      reader_.fault(word.place,
                    "G91: values that are added to others cannot be imported; punch the offsets "
                    "from the control again");
    }
    const bool is_known = std::string_view("GLPRMNO").find(word.letter) != std::string_view::npos;
    if (!is_known && !has_g(10)) {
      reader_.fault(word.place, std::string(1, word.letter) + std::string(word.text) +
                                    " is not part of an offset listing; this looks like a part "
                                    "program");
    }
  }

  void read_offset(const TextLine& line, const std::string& comment) {
    has_offsets_ = true;
    const ListingWord* l = word('L');
    const ListingWord* p = word('P');
    const ListingWord* r = word('R');
    const auto number = l == nullptr ? std::nullopt : whole_number_of_text(l->text);
    const auto* row =
        std::ranges::find(offset_registers, number.value_or(0), &OffsetRegister::number);
    if (row == offset_registers.end()) {
      reader_.lose({.tool = 0,
                    .field = shortened(line.text),
                    .value = "",
                    .reason = "only L10 to L13 are offsets of tools of a mill"});
      return;
    }
    const auto tool_number = p == nullptr ? std::nullopt : whole_number_of_text(p->text);
    if (!tool_number || r == nullptr) {
      reader_.fault(l->place,
                    "G10 without the number P of an offset or its value R; write both, "
                    "as in G10 L10 P1 R77.125");
      return;
    }
    const auto value = value_of(*r);
    ForeignTool* tool = value ? reader_.tool(*tool_number, p->place) : nullptr;
    if (tool == nullptr) return;
    if (is_given(*tool, row->key)) {
      reader_.fault(p->place, "L" + std::to_string(row->number) + " P" +
                                  std::to_string(*tool_number) +
                                  " appears twice; leave the line that is meant");
      return;
    }
    const double share = row->of == OffsetRegister::Of::cutter ? share_of_radius(cutter_) : 1.0;
    reader_.give(*tool, row->key, share * mm_of(*value, unit()), r->place);
    take_comment(*tool, comment);
  }

  // Without a point, a control reads increments: 1000 may be 1 mm.
  std::optional<double> value_of(const ListingWord& word) {
    const auto value = number_of_text(word.text);
    if (value && (word.text.find('.') != std::string_view::npos || *value == 0.0)) return value;
    reader_.fault(word.place, "R" + shortened(word.text) +
                                  " is not a number with a decimal point; write it with one, as in "
                                  "R77.125 or R6.");
    return std::nullopt;
  }

  void take_comment(ForeignTool& tool, const std::string& comment) {
    if (comment.empty() || comment == tool.edge.name) return;
    if (tool.edge.name.empty()) {
      reader_.give_text(tool, "name", comment);
    } else {
      reader_.lose({.tool = tool.edge.number,
                    .field = "comment",
                    .value = shortened(comment),
                    .reason = "the tool has a name already"});
    }
  }

  ForeignReader reader_;
  std::optional<LengthUnit> unit_;
  CutterSize cutter_;
  bool has_offsets_ = false;
  std::vector<ListingWord> words_;
};

ForeignTools read_listing(const ForeignSource& source, CutterSize usual) {
  const std::string text = text_of(source);
  ListingReader reader(source, usual);
  for (const TextLine& line : lines_of(text)) reader.read_line(line);
  return reader.finish();
}

// What a control shows in a comment: ASCII without parentheses.
std::string comment_of(std::string_view name) {
  std::string comment;
  for (const char letter : in_one_line(name)) {
    if (continues_character(letter)) continue;
    comment += letter == '(' ? '[' : letter == ')' ? ']' : letter < ' ' ? '?' : letter;
  }
  return comment.empty() ? "" : " (" + comment + ")";
}

std::string lines_of_tool(const ToolEdge& tool, LengthUnit unit, CutterSize cutter, int decimals) {
  std::string text;
  for (const OffsetRegister& row : offset_registers) {
    const double share = row.of == OffsetRegister::Of::cutter ? share_of_radius(cutter) : 1.0;
    text += "G10 L" + std::to_string(row.number) + " P" + std::to_string(tool.number) + " R" +
            fixed_number(in_unit(tool.*row.value / share, unit), decimals);
    text += (row.number == offset_registers.front().number ? comment_of(tool.name) : "") + "\n";
  }
  return text;
}

std::vector<ForeignFile> write_listing(std::span<const ToolEdge> tools, const WriteChoice& choice,
                                       CutterSize usual) {
  const CutterSize cutter = choice.cutter.value_or(usual);
  const bool is_mm = choice.unit == LengthUnit::mm;
  std::string text = "%\nO9999 (TOOL OFFSETS, ";
  text += std::string(is_mm ? "MM" : "INCH") + ", CUTTER " +
          (cutter == CutterSize::radius ? "RADIUS" : "DIAMETER") + ")\n";
  text += is_mm ? "G21\nG90\n" : "G20\nG90\n";
  for (const ToolEdge& tool : tools) {
    text += lines_of_tool(tool, choice.unit, cutter, is_mm ? 3 : 4);
  }
  return {{choice.file, text + "M30\n%\n"}};
}

}  // namespace

ForeignTools read_fanuc_offsets(const ForeignSource& source) {
  return read_listing(source, CutterSize::radius);
}

std::vector<ForeignFile> write_fanuc_offsets(std::span<const ToolEdge> tools,
                                             const WriteChoice& choice) {
  return write_listing(tools, choice, CutterSize::radius);
}

ForeignTools read_haas_offsets(const ForeignSource& source) {
  return read_listing(source, CutterSize::diameter);
}

std::vector<ForeignFile> write_haas_offsets(std::span<const ToolEdge> tools,
                                            const WriteChoice& choice) {
  return write_listing(tools, choice, CutterSize::diameter);
}

}  // namespace stanok::jobs
