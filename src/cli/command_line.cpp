#include "command_line.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmp.h>
#include <mpfr.h>
#include <CLI/CLI.hpp>
#include <boost/version.hpp>

#include "base/nearest_name.hpp"
#include "cli/options/formula.hpp"
#include "cli/output/streams.hpp"
#include "cli/ranks/ranks.hpp"
#include "commands.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/version.hpp"

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

bool has_option(const CLI::App& app, const std::string& name) {
  return name.starts_with("--") && app.get_option_no_throw(name) != nullptr;
}

std::string help_command(const CLI::App& app) {
  return app.get_parent() == nullptr ? "polhode --help" : "polhode " + app.get_name() + " --help";
}

/// Throws usage_error for the first of the arguments that the app did not know.
void refuse_unknown_arguments(const CLI::App& app) {
  std::vector<std::string> unknown = app.remaining();
  std::erase(unknown, "--");  // the mark before arguments that begin with a minus sign
  if (unknown.empty()) return;
  const std::string given = without_margins(unknown.front());
  std::string kind = "option";
  std::vector<std::string> known = option_names(app);
  if (given.empty() || given.front() != '-') {
    kind = "subcommand";
    known.clear();
    for (const CLI::App* sub : app.get_subcommands({})) known.push_back(sub->get_name());
  }
  const std::string name = given.substr(0, given.find('='));
  if (known.empty()) {
    const bool defines = name != given && is_identifier(name) && has_option(app, "--let");
    throw usage_error(fmt::format(
        "{} was not expected; {}see `{}`", in_quotes(given),
        defines ? fmt::format("a name is defined by --let {}; ", given) : "", help_command(app)));
  }
  const std::optional<std::string> near = near_name(name, known);
  throw usage_error(fmt::format("there is no {} {}{} (`{}` shows all)", kind, in_quotes(name),
                                near ? "; the nearest is " + *near : "", help_command(app)));
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

/// Reads the options of a subcommand as the parser will, before it does: throws usage_error for a
/// value that is missing, or given to an option without one, and for an option that is given twice.
/// Marks formulas that begin with a minus sign, which the parser would take for options: a space
/// before it makes it an argument, and the readers of formulas skip it.
void prepare_arguments(const CLI::App& app, std::vector<std::string>& arguments) {
  const std::string& subcommand = app.get_name();
  const bool takes_formulas =
      subcommand == "eval" || subcommand == "integrate" || subcommand == "roots";
  std::set<const CLI::Option*> given;
  const auto refuse = [&](const std::string& why) {
    throw usage_error(fmt::format("{}; see `{}`", why, help_command(app)));
  };
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--") return;
    const bool one_dash = argument.size() >= 2 && argument.front() == '-' && argument[1] != '-';
    if (one_dash && takes_formulas && argument != "-h") {
      arguments[i] = ' ' + argument;
      continue;
    }
    if (!argument.starts_with("--")) continue;
    const std::size_t mark = argument.find('=');
    const std::string name = argument.substr(0, mark);
    const CLI::Option* option = app.get_option_no_throw(name);
    if (option == nullptr) continue;  // said by refuse_unknown_arguments
    const bool takes_value = option->get_items_expected_max() > 0;
    const bool only_once = option->get_expected_max() == 1 &&
                           option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw;
    if (!given.insert(option).second && takes_value && only_once) {
      refuse(name + " is given twice");
    }
    const bool has_value = mark != std::string::npos;
    if (!takes_value && has_value) refuse(name + " takes no value");
    if (!takes_value) continue;
    const bool ends = i + 1 == arguments.size();
    const bool is_missing =
        has_value ? mark + 1 == argument.size()
                  : ends || arguments[i + 1] == "--" || has_option(app, arguments[i + 1]);
    if (is_missing) {
      refuse(fmt::format("{} has no value: write {} {}", name, name, option->get_type_name()));
    }
    if (!has_value) ++i;
  }
}

/// The first argument that the subcommand needs and did not get; empty where there is none.
std::string missing_argument(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    std::string what = option->get_description();
    what = what.substr(0, what.find('\n'));
    return fmt::format("{} is missing ({})", option->get_name(), what);
  }
  return {};
}

/// What is wrong, and where to read more.
std::string parser_message(const CLI::ParseError& error, const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const CLI::App& reader = chosen.empty() ? app : *chosen.front();
  const std::string missing = missing_argument(reader);
  return fmt::format("{}; see `{}`", missing.empty() ? error.what() : missing,
                     help_command(reader));
}

/// `polhode help` and `polhode help SUBCOMMAND`.
exit_status print_help(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.size() == 1) {
    print(app.help());
    return exit_status::all_certified;
  }
  if (arguments.size() > 2) {
    throw usage_error(fmt::format("{} was not expected: write `polhode help SUBCOMMAND`",
                                  in_quotes(arguments[2])));
  }
  std::vector<std::string> known;
  for (const CLI::App* sub : app.get_subcommands({})) {
    known.push_back(sub->get_name());
    if (sub->get_name() != arguments[1]) continue;
    print(sub->help("polhode"));
    return exit_status::all_certified;
  }
  const std::optional<std::string> near = near_name(arguments[1], known);
  throw usage_error(fmt::format("there is no subcommand {}{} (`polhode --help` shows all)",
                                in_quotes(arguments[1]), near ? "; the nearest is " + *near : ""));
}

}  // namespace

exit_status run_command_line(int argc, const char* const* argv) {
  for (const command& c : all_commands()) {
    if (c.runs_on_ranks && argc > 1 && c.name == argv[1]) {
      ranks::join({argv, static_cast<std::size_t>(argc)});
    }
  }
  refuse_brackets(argc, argv);
  CLI::App app(
      "Certified numbers, and the free rotation of rigid bodies: digits before dots are digits of\n"
      "the true value; value ± radius holds it.\n",
      "polhode");
  set_up(app, fmt::format("Examples:\n"
                          "  polhode certify                      prove every claim\n"
                          "  polhode constants beta --digits 1000\n"
                          "  polhode eval \"exp(1) - 2\"\n"
                          "  polhode help certify\n\n{}",
                          exit_statuses));
  app.require_subcommand(0, 1);
  app.set_version_flag("-V,--version", version_text(), "Print the versions and exit");
  std::map<const CLI::App*, std::function<exit_status()>> actions;
  for (const command& c : all_commands()) {
    CLI::App* sub = app.add_subcommand(c.name, c.summary);
    set_up(*sub, fmt::format("Examples:\n{}\n{}", c.examples, exit_statuses));
    actions[sub] = c.declare(*sub);
  }
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && arguments.front() == "help") return print_help(app, arguments);
  for (const auto& [sub, action] : actions) {
    if (arguments.empty() || arguments.front() != sub->get_name()) continue;
    const bool asks_for_help =
        std::any_of(arguments.begin(), std::find(arguments.begin(), arguments.end(), "--"),
                    [](const std::string& a) { return a == "--help" || a == "-h"; });
    if (!asks_for_help) prepare_arguments(*sub, arguments);
  }
  try {
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
