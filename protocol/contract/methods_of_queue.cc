// Rows of the command table: programs that begin one after the other.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr double entries_max = 1e9;
constexpr double places_max = 500.0;

constexpr Parameter queued_program =
    required_text("program", "program file beneath the program root");

constexpr Parameter entry{.name = "id",
                          .type = ParameterType::integer,
                          .presence = Presence::required,
                          .spelling = Spelling::positional,
                          .minimum = 1,
                          .maximum = entries_max,
                          .help = "which entry, as queue.list tells it"};

constexpr Parameter place{.name = "place",
                          .type = ParameterType::integer,
                          .presence = Presence::required,
                          .spelling = Spelling::positional,
                          .minimum = 1,
                          .maximum = places_max,
                          .help = "its new place, from 1"};

constexpr std::array of_add{queued_program, channel};
constexpr std::array of_entry{entry, channel};
constexpr std::array of_move{entry, place, channel};
constexpr std::string_view queues = R"("$queues")";

constexpr auto queue_rows = std::to_array<Method>({
    {.name = "queue.list",
     .parameters = of_channel,
     .help = "programs that wait, of one channel or all; what stopped a queue",
     .result = queues},
    {.name = "queue.add",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_add,
     .help = "put a program at the end of the queue of a channel",
     .result = queues},
    {.name = "queue.remove",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_entry,
     .help = "take a program out of the queue, unless it is under way",
     .result = queues},
    {.name = "queue.move",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_move,
     .help = "give a program another place in the queue",
     .result = queues},
    {.name = "queue.start",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .parameters = of_motion,
     .help =
         "run the programs of the queue one after the other, until one fails, somebody stops or "
         "resets something, takes the channel, or an alarm comes",
     .result = queues},
    {.name = "queue.stop",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_channel,
     .help = "begin no further program; the one under way goes on",
     .result = queues},
});

}  // namespace

std::span<const Method> queue_methods() {
  return queue_rows;
}

}  // namespace stanok::protocol::rows
