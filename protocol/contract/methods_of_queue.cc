// Rows of the command table: programs that begin one after the other.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr double entries_max = 1e9;
constexpr double places_max = 500.0;

constexpr Parameter queued_program =
    required_text("program", "program file under the program root");

constexpr Parameter entry{.name = "id",
                          .type = ParameterType::integer,
                          .presence = Presence::required,
                          .spelling = Spelling::positional,
                          .minimum = 1,
                          .maximum = entries_max,
                          .help = "number of the entry, as queue.list shows it"};

constexpr Parameter place{.name = "place",
                          .type = ParameterType::integer,
                          .presence = Presence::required,
                          .spelling = Spelling::positional,
                          .minimum = 1,
                          .maximum = places_max,
                          .help = "new position in the queue, from 1"};

constexpr std::array of_add{queued_program, channel};
constexpr std::array of_entry{entry, channel};
constexpr std::array of_move{entry, place, channel};
constexpr std::string_view queues = R"("$queues")";

constexpr auto queue_rows = std::to_array<Method>({
    {.name = "queue.list",
     .parameters = of_channel,
     .help = "list the waiting programs of one channel or of all, and what stopped a queue",
     .result = queues},
    {.name = "queue.add",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_add,
     .help = "add a program to the end of the queue of a channel",
     .result = queues},
    {.name = "queue.remove",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_entry,
     .help = "remove a program from the queue, unless it is in progress",
     .result = queues},
    {.name = "queue.move",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_move,
     .help = "move a program to another position in the queue",
     .result = queues},
    {.name = "queue.start",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .parameters = of_motion,
     .help = "run the programs of the queue one after the other, until one fails, an alarm occurs, "
             "or somebody stops or resets something or takes the channel",
     .result = queues},
    {.name = "queue.stop",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_channel,
     .help = "start no further program of the queue; the one in progress continues",
     .result = queues},
});

}  // namespace

std::span<const Method> queue_methods() {
  return queue_rows;
}

}  // namespace stanok::protocol::rows
