#include "uncertain_effects.hpp"

#include <fmt/format.h>

#include "cli/options/time_limit.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/layout.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/scene_report.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::cli {

exit_status print_effects(const uncertain_effects& of, bool as_json) {
  const auto three = [&](const auto& number) {
    return fmt::format("[\"{}\", \"{}\", \"{}\"]\n", to_text(number(of.moments[0])),
                       to_text(number(of.moments[1])), to_text(number(of.moments[2])));
  };
  std::string text = fmt::format("digits = {}\n[body]\nmoments = ", of.digits);
  text += three([](const uncertain_moment& m) { return m.value; });
  text += "sigma = " + three([](const uncertain_moment& m) { return m.sigma; });
  if (of.c) text += fmt::format("[state]\nc = \"{}\"\n", to_text(*of.c));
  text += fmt::format("[effects]\nlisted = {}\nwant = [{}]\n", of.listed, of.want);
  try {
    const scene what = read_scene(text, ".");
    const scene_report results = [&] {
      const progress line;
      line.show("computing the ranges");
      const time_watch watch(of.seconds);
      return compute(what);
    }();
    const json report =
        scene_json(what, results, "moments with uncertainties", {}, "", table_rows::counted);
    print(as_json ? json_text(report) + '\n' : scene_text(report));
    return results.verdict == status::certified ? exit_status::all_certified
                                                : exit_status::not_certified;
  } catch (const input_error& error) {
    throw usage_error(fmt::format("moments with uncertainties: {}", error.what()));
  }
}

}  // namespace polhode::cli
