// The program `polhode`.

#include "cli/output/errors.hpp"
#include "cli/output/streams.hpp"
#include "cli/ranks/ranks.hpp"
#include "command_line.hpp"
#include "interruption.hpp"

int main(int argc, char** argv) {
  using namespace polhode::cli;
  exit_status status = exit_status::bad_input;
  try {
    check_standard_streams();
    handle_interruptions();
    status = run_command_line(argc, argv);
    ranks::leave();
  } catch (...) {
    status = report_current_exception();
    ranks::give_up(status);
  }
  return static_cast<int>(status);
}
