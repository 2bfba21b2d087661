#include "command_line.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmp.h>
#include <mpfr.h>
#include <boost/version.hpp>

#include "commands.hpp"
#include "polhode/expression/nearest_name.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

constexpr const char* exit_statuses =
    "Exit status: 0 all certified; 1 something was not certified or was refuted; 2 bad usage or\n"
    "bad input (one line on standard error says what was given and what would be right); 3 two\n"
    "proofs contradict each other, which is a fault in Polhode.";

std::string version_text() {
  return fmt::format("polhode {}\nMPFR {}\nGMP {}\nBoost {}.{}.{}", POLHODE_VERSION,
                     mpfr_get_version(), gmp_version, BOOST_VERSION / 100000,
                     BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100);
}

/// Options and arguments nobody knows are left over, so that
/// refuse_unknown_arguments can speak of them.
void set_up(CLI::App& app, const std::string& footer) {
  constexpr std::size_t help_column = 26;
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.get_formatter()->column_width(help_column);
  app.get_formatter()->label("SUBCOMMAND", "SUBCOMMAND ...");
  app.footer(footer);
  app.allow_extras();
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string help_command(const CLI::App& app) {
  return app.get_parent() == nullptr ? "polhode --help" : "polhode " + app.get_name() + " --help";
}

/// Throws usage_error for the first of the arguments that the app did not know.
void refuse_unknown_arguments(const CLI::App& app) {
  std::vector<std::string> unknown = app.remaining();
  std::erase(unknown, "--");  // the mark before arguments that begin with a minus sign
  if (unknown.empty()) return;
  const std::string& given = unknown.front();
  std::string kind = "option";
  std::vector<std::string> known = option_names(app);
  if (given.empty() || given.front() != '-') {
    kind = "subcommand";
    known.clear();
    for (const CLI::App* sub : app.get_subcommands({})) known.push_back(sub->get_name());
  }
  const std::string name = given.substr(0, given.find('='));
  if (known.empty()) {
    throw usage_error(
        fmt::format("{} was not expected; see `{}`", in_quotes(given), help_command(app)));
  }
  throw usage_error(fmt::format("there is no {} {}; the nearest is {} (`{}` shows all)", kind,
                                in_quotes(name), nearest_name(name, known), help_command(app)));
}

/// The parser would read "[x,y]" as two arguments and "[]" as none.
void refuse_brackets(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view given = argv[i];
    if (given.size() >= 2 && given.front() == '[' && given.back() == ']') {
      throw usage_error(fmt::format(
          "{} was not expected: give arguments one by one, without brackets", in_quotes(given)));
    }
  }
}

/// The arguments, in which a formula may begin with a minus sign: the parser would take it for options.
/// A space before it makes it an argument; the readers of formulas skip it.
std::vector<std::string> with_formulas_marked(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool takes_formulas =
      !arguments.empty() && (arguments.front() == "eval" || arguments.front() == "integrate" ||
                             arguments.front() == "roots");
  for (std::size_t i = 1; takes_formulas && i < arguments.size(); ++i) {
    const std::string& before = arguments[i - 1];
    if (before == "--") break;
    const std::string& given = arguments[i];
    const bool one_dash = given.size() >= 2 && given.front() == '-' && given[1] != '-';
    const bool is_value = before.starts_with("--");
    if (one_dash && !is_value && given != "-h") arguments[i] = ' ' + given;
  }
  return arguments;
}

/// What the parser says of an error, without its line breaks, and where to read more.
std::string parser_message(const CLI::ParseError& error, const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return fmt::format("{}; see `{}`", error.what(),
                     help_command(chosen.empty() ? app : *chosen.front()));
}

}  // namespace

exit_status run_command_line(int argc, const char* const* argv) {
  refuse_brackets(argc, argv);
  CLI::App app(
      "Certified numbers, and the free rotation of rigid bodies: every number that is printed\n"
      "is proved to be right in all its digits.\n",
      "polhode");
  set_up(app, fmt::format("Examples:\n"
                          "  polhode certify                      prove every claim\n"
                          "  polhode constants beta --digits 1000\n"
                          "  polhode eval \"exp(1) - 2\"\n"
                          "  polhode certify --help\n\n{}",
                          exit_statuses));
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", version_text(), "Print the versions and exit");
  std::map<const CLI::App*, std::function<exit_status()>> actions;
  for (const command& c : all_commands()) {
    CLI::App* sub = app.add_subcommand(c.name, c.summary);
    set_up(*sub, fmt::format("Examples:\n{}\n{}", c.examples, exit_statuses));
    actions[sub] = c.declare(*sub);
  }
  try {
    std::vector<std::string> arguments = with_formulas_marked(argc, argv);
    std::reverse(arguments.begin(), arguments.end());  // as the parser wants them
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    print(app.help());
    return exit_status::all_certified;
  } catch (const CLI::CallForVersion&) {
    print(version_text() + '\n');
    return exit_status::all_certified;
  } catch (const CLI::ParseError& error) {
    throw usage_error(parser_message(error, app));
  }
  refuse_unknown_arguments(app);
  if (app.get_subcommands().empty()) {
    print_error(app.help());
    return exit_status::bad_input;
  }
  const CLI::App* chosen = app.get_subcommands().front();
  refuse_unknown_arguments(*chosen);
  return actions.at(chosen)();
}

}  // namespace polhode::cli
