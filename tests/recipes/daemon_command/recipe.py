"""system.clock, which the daemon answers."""
from recipe import Recipe, before

RECIPE = Recipe("A command that the daemon answers itself", [
    before("protocol/contract/methods_of_daemon.cc", '    {.name = "system.shutdown",', """
    {.name = "system.clock",
     .help = "show cycles and time of the machine since the daemon started",
     .result = R"({"cycle":"integer","machine_time_s":"number"})"},
"""),
    before("daemon/desk/dispatch.cc", """
      // NOLINTNEXTLINE(performance-unnecessary-value-param): a handler of this kind answers itself
      {"system.shutdown", [](Dispatch& d, Call call) { d.shut_down(call); }},
""", """
      {"system.clock",
       [](Dispatch& d, const json&) {
         const auto cycle = d.machine_.newest_output().cycle;
         const double cycle_s = d.machine_.file().machine.cycle_us * 1e-6;
         return json{{"cycle", cycle}, {"machine_time_s", static_cast<double>(cycle) * cycle_s}};
       }},
"""),
])
