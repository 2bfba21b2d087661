// The program `polhode`.

#include "command_line.hpp"
#include "errors.hpp"
#include "interruption.hpp"
#include "streams.hpp"

int main(int argc, char** argv) {
  using namespace polhode::cli;
  exit_status status = exit_status::bad_input;
  try {
    check_standard_streams();
    handle_interruptions();
    status = run_command_line(argc, argv);
  } catch (...) {
    status = report_current_exception();
  }
  return static_cast<int>(status);
}
