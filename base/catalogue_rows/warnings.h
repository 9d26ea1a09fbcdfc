// Rows of the catalogue: warnings from W500 on, of everything but the language. For
// base/catalogue.cc alone.
#pragma once

#include <array>

#include "base/catalogue.h"

namespace stanok {

// Sorted by code. One line a row: code, title, reaction, remedy, how to go on.
inline constexpr auto further_warnings = std::to_array<CatalogueRow>({
    {"W604", "the sensor of an automatic feed law gives no value", Reaction::warning,
     "check the sensor, its wiring and its bus; process status shows the law",
     "the feed is at its minimum until the law is switched off or on again"},
    {"W611", "a vibration sensor gives no value", Reaction::warning,
     "check the sensor, its wiring and its bus", "no oscillation is formed from the vibration"},
    {"W612", "an oscillation is at a multiple of the spindle frequency", Reaction::warning,
     "the force cannot oscillate at such a frequency; choose another frequency or another spindle "
     "speed",
     "the frequency was shifted; process status shows it"},
    {"W613", "the feed cannot form the oscillation", Reaction::warning,
     "command a smaller amplitude, a lower frequency or a greater mean force",
     "the force oscillates as far as the feed can follow without coming to rest"},
    {"W614", "the force is above its setpoint at the lowest feed", Reaction::warning,
     "check that the depth of cut is right and the tool is sharp",
     "the feed stays at S_min; lower it if the process allows that"},
    {"W615", "the tool moves at feed without reaching the set force", Reaction::warning,
     "check whether the tool is broken and whether there is a workpiece, and check the idle power "
     "and S_max in process status; air_time of [process] is the longest air cut",
     "the feed continues; hold it if the tool may be broken"},
    {"W616", "the feed is limited because the cut became lighter than expected", Reaction::warning,
     "if the cut is meant to become that much lighter, give its depth (#adaptive (depth, t)) or "
     "set "
     "lighter_max of [process]; otherwise check the gain of the power sensor",
     "the feed stays at the value that lighter_max allows"},
    {"W710", "a program is not included", Reaction::warning,
     "#include it so that it is checked when this program is loaded", "no action is needed"},
    {"W720", "a recording is not complete", Reaction::warning,
     "find out what slows the recorder down: a slow disk, or an overloaded computer; log status "
     "counts the losses",
     "motion is not affected; stanok log verify shows which part of the log can be replayed"},
    {"W721", "messages are missing", Reaction::warning,
     "find out what slows the daemon down, for example an overloaded computer",
     "motion is not affected; alarm history has the alarms among them"},
    {"W722", "the history is not complete", Reaction::warning,
     "find out what slows the daemon down, for example an overloaded computer",
     "motion is not affected; the recorded log has every run and alarm"},
    {"W730", "the axes paused in the cut", Reaction::warning,
     "reduce the load on the computer; machine status shows whether the daemon has real-time "
     "rights",
     "the program continues automatically when two seconds of motion are prepared"},
    {"W731", "the axes paused in the cut: the control cycle was too late", Reaction::warning,
     "reduce the load on the computer; machine status shows how many periods were lost and whether "
     "the daemon has real-time rights",
     "the program continues automatically"},
    {"W732", "the run is held: the control stood still", Reaction::warning,
     "find out what stopped the computer: a debugger, sleep mode, or the migration of a virtual "
     "machine",
     "check the positions of the axes, then resume the program"},
    {"W733", "a jog stopped: the probe touched something", Reaction::warning,
     "jog back, away from what the probe touches", "the axes can be jogged again"},
    {"W734", "a tap was left in its hole", Reaction::warning,
     "leave the axes where they are, and do not turn the spindle",
     "reset the channel and switch the machine on, then enter G30 P99 in MDI: the tap comes out "
     "in "
     "step with the spindle"},
    {"W810", "the feed is above what the axes can do", Reaction::warning,
     "the text names the block and the limit; the path runs as fast as the axes can",
     "no action is needed"},
    {"W820", "a program was not checked to its end", Reaction::warning,
     "check the loop in the line shown; a program that runs until it is stopped needs no end",
     "no action is needed"},
    {"W821", "a run was ended at its time limit", Reaction::warning,
     "raise --limit, or find the loop that does not end", "no action is needed"},
    {"W910", "the removal is above the boundary while the wheel plunges in", Reaction::warning,
     "a lower first feed avoids this; it does no harm while the part is far from its size",
     "no action is needed"},
    {"W911", "the removal touches the burn line", Reaction::warning,
     "use a slightly lower feed from the named X on, if the burn line is known that exactly",
     "no action is needed"},
    {"W912", "a step is left in the surface that a spark-out would remove", Reaction::warning,
     "let the wheel spark out, or use a lower last feed; roundness_max is the limit",
     "no action is needed"},
    {"W913", "the grinding process is close to chatter", Reaction::warning,
     "check stiffness, mass and damping before the margin falls below 1; a slower force law or a "
     "larger removal_end is more stable",
     "no action is needed"},
    {"W921", "a rapid traverse goes through material", Reaction::warning,
     "lift the tool first, or program the move at feed",
     "correct the program and simulate it again"},
    {"W922", "the shank of a tool is in the material", Reaction::warning,
     "use a tool with longer flutes, or a smaller depth of cut",
     "correct the program and simulate it again"},
    {"W923", "the holder of a tool is in the material", Reaction::warning,
     "clamp the tool with more overhang, or tilt it", "correct the program and simulate it again"},
    {"W924", "the tool cuts while the spindle is stopped", Reaction::warning,
     "start the spindle before the move at feed", "correct the program and simulate it again"},
    {"W925", "the virtual workpiece does not know the shape of a tool", Reaction::warning,
     "complete its row in the tool table: kind, radius, lengths",
     "the run continues; the tool cuts nothing in the simulation"},
    {"W926", "#workpiece_pos has no blank", Reaction::warning,
     "declare the blank with #workpiece first", "the run continues"},
    {"W927", "a probe meets the part at rapid traverse", Reaction::warning,
     "go there with a probing move (G38.3), or around the part",
     "correct the program and simulate it again"},
    {"W940", "data cannot be saved to disk", Reaction::warning,
     "check the permissions and the free space of the folder that the text names",
     "no action is needed: the daemon tries again"},
    {"W941", "the control ended in the middle of a program", Reaction::warning,
     "check the tool and the workpiece; find out whether the power failed or the daemon was killed",
     "home the axes that need it; start from the line that the text names, or from the beginning"},
});

}  // namespace stanok
