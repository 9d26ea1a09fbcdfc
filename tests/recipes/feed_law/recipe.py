"""The alternating feed law: dl at Smin, dl at Smax, and so on."""
from pathlib import Path

from recipe import Recipe, after, before, new_file, replaced, words_replaced

HERE = Path(__file__).parent

RECIPE = Recipe("A feed law", [
    new_file("lang/feed_law/alternating_law.h", HERE / "lang"),
    new_file("lang/feed_law/alternating_law.cc", HERE / "lang"),
    before("lang/feed_law/law_types.cc", '#include "lang/feed_law/feed_law_curve.h"',
           '#include "lang/feed_law/alternating_law.h"'),
    after("lang/feed_law/law_types.cc", "      curve_law,", "      alternating_law,"),
    after("lang/contract/command.h", "    curve,        // feeds over points of the path",
          "    alternating,  // a way dl at Smin, then dl at Smax, and so on"),
    replaced("motion/path/path.h",
             "enum class LawKind : std::uint8_t { none, linear, modulated, interrupted, curve };",
             "enum class LawKind : std::uint8_t { none, linear, modulated, interrupted, curve, alternating };"),
    before("channels/preparation/feed_law_choice.cc", '#include "motion/feed_laws/curve_law.h"',
           '#include "motion/feed_laws/alternating_law.h"'),
    before("channels/preparation/feed_law_choice.cc", """
struct LawRow {
  lang::FeedLaw::Kind kind;
""", """
MadeLaw make_alternating(const lang::FeedLaw& wanted, const LawPlace&) {
  return std::make_unique<const motion::AlternatingLaw>(
      units_of(wanted),
      motion::AlternatingLawParameters{.feed_min = wanted.feed_first,
                                       .feed_max = wanted.feed_last,
                                       .path_step_mm = wanted.path_step_mm});
}

"""),
    after("channels/preparation/feed_law_choice.cc", "    LawRow{lang::FeedLaw::Kind::curve, make_curve},",
          "    LawRow{lang::FeedLaw::Kind::alternating, make_alternating},"),
    after("daemon/report/process_status.cc", '    {motion::LawKind::curve, "curve"},',
          '    {motion::LawKind::alternating, "alternating"},'),
    after("jobs/dry_run/law_fields.cc", '      return "curve";', """
    case motion::LawKind::alternating:
      return "alternating";
"""),
    words_replaced("jobs/log_tables/process_columns.cc", '3 interrupted, 4 curve"',
                   '3 interrupted, 4 curve, 5 alternating"'),
    words_replaced("messages/process_status_t.lcm", "3 interrupted, 4 curve", "3 interrupted, 4 curve, 5 alternating"),
    new_file("motion/feed_laws/alternating_law.h", HERE / "motion"),
    new_file("motion/feed_laws/alternating_law.cc", HERE / "motion"),
    new_file("programs/conformance/laws/alternating.nc", HERE),
    new_file("tests/motion/feed_laws/alternating_law_test.cc", HERE),
    after("tests/lang/feed_law/feed_law_test.cc", '      {"Smin", "Smax", "dS", "dl"},',
          '      {"Smin", "Smax", "dl"},'),
    replaced("tests/lang/feed_law/feed_law_test.cc",
             "  law.kind = static_cast<FeedLaw::Kind>(random() % 5);",
             "  law.kind = static_cast<FeedLaw::Kind>(random() % 6);"),
    before("docs/reference/language.md", """
- interrupted: the tool cuts L_B at F, then the axes stop for the time of L_A, and so on. `L_A=0`
""", """
- alternating: dl at Smin, then dl at Smax, and so on.
"""),
    after("docs/programmer/feed-laws.md",
          "| modulated | Smin + min(m, 2 n_s − m) dS with m = k mod 2 n_s | (k + 1) dl |",
          "| alternating | Smin for even k, Smax for odd k | (k + 1) dl |"),
    words_replaced("docs/reference/command-line.md", "`interrupted`, `curve`)\nand", "`interrupted`, `curve`,\n"
                   "`alternating`) and"),
    words_replaced("docs/operator/replay.md", "3 interrupted, 4 curve |", "3 interrupted, 4 curve, 5 alternating |"),
])
