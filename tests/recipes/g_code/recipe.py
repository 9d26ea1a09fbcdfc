"""G26: the highest speed of the spindle with G96."""
from pathlib import Path

from recipe import Recipe, after, before, new_file, replaced

HERE = Path(__file__).parent

RECIPE = Recipe("A G code", [
    before("lang/words/code_table.cc",
           '    g(270, none, P::settings, needs_axes, "", not_master, check_reference_point,', """
    g(260, none, P::settings, no_axes, "S", not_master, limit_spindle_speed,
      "highest spindle speed with G96"),
"""),
    before("lang/words/code_actions.def", "CODE_ACTION(check_reference_point)   // G27",
           "CODE_ACTION(limit_spindle_speed)     // G26"),
    before("lang/actions/actions_spindle.cc", "// G50 S and G92 S on a lathe channel: the limit of G96.", """
// G26 S: the limit of G96 on every channel.
void limit_spindle_speed(ActiveBlock& block, CodeNumber code) {
  if (!block.has('S')) {
    block.fail("E4007", {'G', code, {}}, "`G26` needs S, the highest speed", "no S");
  } else if (block.value('S') == 0.0) {
    block.fail("E4058", {'S', -1, {}}, "`G26 S0` would be no limit", "a limit of 0")
        .help.push_back("give 1/min, e.g. `G26 S2500`");
  } else {
    limit_speed(block);
  }
}

"""),
    after("base/catalogue_rows/language.h", """
      {"E4057", "M902 names a spindle that cannot become an axis", end,
       "name another spindle with H1=, or give it an axis in the machine file",
       "correct the program and start it again"},
""", """
      {"E4058", "the spindle limit of G26 is 0", end, "give S in 1/min, above 0",
       "correct the program and start it again"},
"""),
    new_file("programs/conformance/milling/spindle_limit.nc", HERE),
    new_file("programs/conformance/milling/fault_spindle_limit.nc", HERE),
    new_file("programs/conformance/milling/fault_spindle_limit_words.nc", HERE),
    replaced("docs/reference/language.md", """
1/min. S of later blocks is a cutting speed too, until `G97`. On a lathe channel `G92 S2500` or
`G50 S2500` sets the same limit. Elsewhere G50 and G92 with S are refused (E4016).
""", """
1/min. S of later blocks is a cutting speed too, until `G97`. `G26 S2500` sets the same limit; 0 is
refused (E4058). On a lathe channel `G92 S2500` or `G50 S2500` does the same. Elsewhere G50 and G92
with S are refused (E4016).
"""),
    after("docs/reference/language.md", "G96 S180 D2500", "G26 S2000"),
])
