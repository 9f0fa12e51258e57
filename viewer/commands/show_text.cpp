#include <ostream>

#include "commands/commands.h"

namespace hsr {

void run(const ShowText& command, std::ostream& out) { out << command.text; }

}  // namespace hsr
