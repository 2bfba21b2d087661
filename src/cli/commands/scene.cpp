// polhode scene: the effects that scene files ask for, and no others.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/sha256.hpp"
#include "cli/commands.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/gnuplot.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/output_directory.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/scene_report.hpp"
#include "cli/output/streams.hpp"
#include "cli/page/scene_page.hpp"
#include "cli/ranks/ranks.hpp"
#include "polhode/scene/body_file.hpp"
#include "polhode/version.hpp"

namespace polhode::cli {
namespace scene_impl {
namespace {

namespace fs = std::filesystem;

struct scene_options {
  std::vector<std::string> files;
  std::vector<std::string> settings;
  std::optional<std::string> out;
  bool list = false;
  bool page = false;
  std::optional<std::string> plot;
  format_option format{{"text", "json", "csv"}};
  memory_limit_option memory_limit;
  time_limit_option time_limit;
};

constexpr const char* no_file = "settings";  // the name of a scene without a file

/// One point of one scene: all that is computed at once, and kept in one file.
struct job {
  std::string file;
  std::shared_ptr<const std::string> text;  // of all points of a sweep
  std::vector<std::string> settings;        // --set
  std::string stem;                         // of the names of its files
  sweep_point point;
  std::string digest;
};

std::string hexadecimal(const sha256_digest& digest) {
  std::string result;
  for (const std::uint8_t byte : digest) result += fmt::format("{:02x}", byte);
  return result;
}

/// Everything that the results depend on.
std::string digest_of(const scene_options& options, const job& one, const scene& what,
                      text_files& files) {
  std::string all = std::string(POLHODE_VERSION) + '\n' + one.file + '\n' + *one.text + '\n' +
                    options.plot.value_or("") + (options.page ? "page" : "");
  for (const auto& [key, value] : one.point) all += '\n' + key + '=' + to_text(value);
  for (const std::string& setting : one.settings) all += '\n' + setting;
  if (what.body.file) all += '\n' + files[*what.body.file];
  return hexadecimal(sha256(std::as_bytes(std::span(all))));
}

/// What a reader refuses becomes a usage error that begins with the file.
template <class F>
auto reading(const std::string& file, const F& read) {
  try {
    return read();
  } catch (const input_error& error) {
    throw usage_error(fmt::format("{}: {}", in_quotes(file), error.what()));
  }
}

scene scene_of(const job& one, text_files& files) {
  const std::map<std::string, rational> replaced(one.point.begin(), one.point.end());
  return reading(one.file, [&] {
    return read_scene(*one.text, fs::path(one.file).parent_path(), replaced, files, one.settings);
  });
}

/// All points of a sweep, the last key fastest; one without a point where there is no sweep.
std::vector<sweep_point> points_of(const scene& what) {
  std::vector<sweep_point> result(1);
  for (const auto& axis : what.sweep) {
    std::vector<sweep_point> longer;
    longer.reserve(result.size() * axis.values.size());
    for (const sweep_point& point : result) {
      for (const rational& value : axis.values) {
        longer.push_back(point);
        longer.back().emplace_back(axis.key, value);
      }
    }
    result = std::move(longer);
  }
  return result;
}

/// The rows of tables are written to files and stand in JSON; elsewhere they are counted.
table_rows rows_of(const scene_options& options) {
  return options.out || options.format.value() == "json" ? table_rows::kept : table_rows::counted;
}

/// What the reports of all jobs take, which are kept to the end: each number is held as a ball and,
/// where rows are kept, as text, in JSON.
class memory_of_reports {
 public:
  void add(const scene_options& options, const scene& what);

 private:
  double numbers_ = 0;
  double bytes_ = 0;
};

void memory_of_reports::add(const scene_options& options, const scene& what) {
  constexpr double bytes_per_digit = 60;
  const bool kept = rows_of(options) == table_rows::kept;
  const double bytes_per_number = kept ? 1500 : 160;
  const double bytes_per_digit_kept = kept ? 5 : 1;
  const auto digits = static_cast<double>(what.digits);
  double numbers = 40;
  for (const std::string& name : what.want) {
    if (name == "montgomery_curve" || name == "twist_curve")
      numbers += 3 * static_cast<double>(what.points);
    if (name == "intersections") numbers += 6 * static_cast<double>(what.listed);
    if (what.time && (name == "momentum" || name == "attitude"))
      numbers += 7 * static_cast<double>(what.time->samples);
  }
  numbers_ += numbers;
  bytes_ += numbers * (bytes_per_number + bytes_per_digit_kept * digits) + bytes_per_digit * digits;
  options.memory_limit.check({fmt::format("some {} numbers", numbers_), bytes_});
}

/// Reads and checks everything, so that a fault in the last file is found before the first is
/// computed.
std::vector<job> jobs_of(const scene_options& options, text_files& files) {
  std::vector<job> jobs;
  std::set<std::string> stems;
  memory_of_reports memory;
  std::vector<std::string> files_or_none = options.files;
  if (files_or_none.empty()) files_or_none.emplace_back(no_file);
  for (const std::string& file : files_or_none) {
    const auto text = std::make_shared<const std::string>(
        file == no_file ? "" : reading(file, [&] { return read_text_file(file); }));
    const job whole{file, text, options.settings, fs::path(file).stem().string(), {}, ""};
    const auto take_name = [&](const std::string& stem) {
      if (!options.out || stems.insert(stem).second) return;
      throw usage_error(
          fmt::format("{}: two scenes or points named {} would be written to the same files in "
                      "--out; rename one",
                      in_quotes(file), in_quotes(stem)));
    };
    const scene what = scene_of(whole, files);
    const std::vector<sweep_point> points = points_of(what);
    jobs.reserve(jobs.size() + points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      job one = whole;
      one.point = points[k];
      if (!one.point.empty()) one.stem += fmt::format("-{:04}", k + 1);
      take_name(one.stem);
      const scene at_point = one.point.empty() ? what : scene_of(one, files);
      memory.add(options, at_point);
      one.digest = digest_of(options, one, at_point, files);
      jobs.push_back(std::move(one));
    }
  }
  return jobs;
}

/// The report that an earlier run left of the same job; nothing where it left none, or of something
/// else.
std::optional<json> kept_report(const scene_options& options, const job& one) {
  const auto written = [&](const std::string& end) {
    return fs::path(*options.out) / (one.stem + end);
  };
  const fs::path path = written(".json");
  if (!fs::is_regular_file(path)) return std::nullopt;
  try {
    std::ifstream file(path, std::ios::binary);
    json report = json::parse(file);
    const bool is_whole = report.contains("effects") && report.contains("verdict");
    if (!is_whole || report.at("digest") != one.digest) return std::nullopt;
    if (!fs::is_regular_file(written(".txt"))) return std::nullopt;
    if (options.page && !fs::is_regular_file(written(".html"))) return std::nullopt;
    for (const auto& [name, effect] : report.at("effects").items()) {
      if (!effect.contains("table")) continue;
      if (!fs::is_regular_file(written('.' + name + ".csv"))) return std::nullopt;
      if (options.plot && !fs::is_regular_file(written('.' + name + '.' + *options.plot)))
        return std::nullopt;
    }
    (void)scene_text(report);  // all that will be read of it
    (void)results_csv({report});
    return report;
  } catch (const json::exception&) {  // of something else, or damaged
  }
  return std::nullopt;
}

/// Throws usage_error where a scene of this file is estimated to take longer than the limit.
void check_time(const scene_options& options, const std::string& file, const scene& what) {
  (void)options.time_limit.check(fmt::format("{} digits of {}", what.digits, in_quotes(file)),
                                 what.digits, {[&](long fewer) {
                                   scene smaller = what;
                                   smaller.digits = fewer;
                                   (void)compute(smaller);
                                 }});
}

bool is_certified(const json& report) { return report["verdict"] == to_text(status::certified); }

/// What one job has come to: its report, and with --out its files by name.
// NOLINTNEXTLINE(bugprone-exception-escape): its destructor is the library's
struct done_job {
  json report;
  std::vector<std::pair<std::string, std::string>> files;
};

done_job compute_job(const scene_options& options, const job& one, text_files& texts) {
  const scene what = scene_of(one, texts);
  const scene_report results = compute(what);
  done_job done{scene_json(what, results, one.file, one.point, one.digest, rows_of(options)), {}};
  if (!options.out) return done;
  const json& report = done.report;
  auto& files = done.files;
  files.emplace_back(one.stem + ".txt", scene_text(report));
  for (const effect_result& effect : results.effects) {
    if (effect.table)
      files.emplace_back(one.stem + '.' + effect.name + ".csv", table_csv(*effect.table));
    if (effect.table && options.plot) {
      files.emplace_back(
          one.stem + '.' + effect.name + '.' + *options.plot,
          scene_plot((what.title.empty() ? one.stem : what.title) + ": " + effect.name,
                     *effect.table, *options.plot));
    }
  }
  if (options.page) files.emplace_back(one.stem + ".html", scene_page(what, results, report));
  files.emplace_back(one.stem + ".json",
                     json_text(report) + '\n');  // the last: it says that the others are there
  return done;
}

/// Writes the files of a job, which appear together or not at all.
void write_files(const scene_options& options, const done_job& done) {
  std::vector<std::string> names;
  names.reserve(done.files.size());
  for (const auto& [name, contents] : done.files) names.push_back(name);
  output_directory out(*options.out, names);
  for (const auto& [name, contents] : done.files) out.write(name, contents);
  out.publish();
}

// From one rank to another.
std::string packed(const done_job& done) {
  json files = json::array();
  for (const auto& [name, contents] : done.files) {
    files.push_back({name, json::binary({contents.begin(), contents.end()})});
  }
  std::string bytes;
  json::to_cbor(json{{"report", done.report}, {"files", std::move(files)}}, bytes);
  return bytes;
}
done_job unpacked(const std::string& bytes) {
  json all = json::from_cbor(bytes);
  done_job done{std::move(all.at("report")), {}};
  for (const json& file : all.at("files")) {
    const auto& contents = file.at(1).get_binary();
    done.files.emplace_back(file.at(0).get<std::string>(),
                            std::string(contents.begin(), contents.end()));
  }
  return done;
}

std::string printed(const scene_options& options, const std::vector<json>& reports) {
  const std::string& format = options.format.value();
  if (format == "csv") return results_csv(reports);
  if (format == "json") {
    if (reports.size() == 1) return json_text(reports.front()) + '\n';
    return json_text(json(reports)) + '\n';
  }
  std::string result;
  for (const json& report : reports) result += (result.empty() ? "" : "\n") + scene_text(report);
  return result;
}

std::string list_of_effects() {
  std::string result;
  for (const effect_description& one : all_effects())
    result += fmt::format("{:<18}{}\n", one.name, one.summary);
  return result;
}

exit_status run(const scene_options& options) {
  (void)options.format.value();
  if (options.list) {
    print(list_of_effects());
    return exit_status::all_certified;
  }
  if (options.files.empty() && options.settings.empty())
    throw usage_error("there is no scene; give a file, such as scenes/toutatis.toml");
  if (options.plot && *options.plot != "svg" && *options.plot != "png" && *options.plot != "pdf") {
    throw usage_error(
        fmt::format("--plot {}: it must be svg, png or pdf", in_quotes(*options.plot)));
  }
  if ((options.plot || options.page) && !options.out) {
    throw usage_error("--plot and --page write files: give --out DIR, too");
  }
  (void)options.time_limit.limit();
  if (options.page) require_pages();
  text_files files;  // that scenes name
  const std::vector<job> jobs = jobs_of(options, files);
  if (options.plot == "pdf") {
    require_pdf("give --plot svg");
  } else if (options.plot) {
    require_gnuplot("leave out --plot");
  }
  // Before anything is computed: whether the table of results can be written. Until the end, so
  // that another run with this directory waits, and then keeps what this one has computed.
  std::optional<output_directory> reserved;
  const bool writes = options.out && !ranks::is_worker();
  if (writes) reserved.emplace(*options.out, std::vector<std::string>{"results.csv"});
  std::optional<progress> line(std::in_place);
  std::vector<json> reports(jobs.size());
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    auto report = writes ? kept_report(options, jobs[i]) : std::nullopt;
    if (report) {
      reports[i] = std::move(*report);
    } else {
      open.push_back(i);
    }
  }
  const std::size_t kept = jobs.size() - open.size();
  const time_watch watch(options.time_limit.limit(static_cast<double>(jobs.size())));
  std::size_t done = kept;
  // The file whose first scene was the last to be estimated: the points of a sweep take alike.
  std::string estimated;
  const auto begin = [&](std::size_t i) {
    line->show_part("computing " + jobs[i].stem, done, jobs.size());
    if (jobs[i].file != estimated) check_time(options, jobs[i].file, scene_of(jobs[i], files));
    estimated = jobs[i].file;
  };
  const bool is_alone = ranks::count() == 1;
  done_job last;  // alone: what is not sent needs no copy
  if (!is_alone && !ranks::is_worker()) std::ranges::for_each(open, begin);
  // Only rank 0 knows which are open.
  ranks::distribute(
      open,
      [&](std::size_t i) {
        if (!is_alone) return packed(compute_job(options, jobs[i], files));
        begin(i);
        last = compute_job(options, jobs[i], files);
        return std::string();
      },
      [&](std::size_t i, const std::string& bytes) {
        if (!is_alone) last = unpacked(bytes);
        if (options.out) write_files(options, last);
        reports[i] = std::move(last.report);
        line->show_part("computing " + jobs[i].stem, ++done, jobs.size());
      });
  line.reset();
  if (options.out) {
    output_directory out(*options.out, {"results.csv"});
    out.write("results.csv", results_csv(reports));
    out.publish();
    std::string summary;
    for (const json& report : reports) {
      if (!is_certified(report))
        summary += fmt::format("{}: not certified\n", in_quotes(report["file"].get<std::string>()));
    }
    print(summary + fmt::format("{} scenes and points in {}: {} computed, {} kept from before\n",
                                jobs.size(), *options.out, open.size(), kept));
  } else {
    print(printed(options, reports));
  }
  return std::all_of(reports.begin(), reports.end(), is_certified) ? exit_status::all_certified
                                                                   : exit_status::not_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<scene_options>();
  add_option(app, "FILE", options->files, "Scenes, in TOML").type_name("FILE");
  add_option(app, "--set", options->settings,
             "A value in the place of the file's, or of a scene without a file; \"KEY=\" takes the "
             "key away")
      .type_name("KEY=VALUE")
      .one_value_each_time();
  add_option(app, "--out", options->out,
             "Write each scene's files there, and all results in one table, results.csv")
      .type_name("DIR");
  add_flag(app, "--list", options->list, "List the effects, one line each");
  add_option(app, "--plot", options->plot,
             "Have gnuplot draw every curve and series: svg, png or pdf")
      .type_name("FORMAT");
  add_flag(app, "--page", options->page, "Write an HTML page a scene, in which the body turns");
  options->format.declare(app);
  options->memory_limit.declare(app);
  options->time_limit.declare(app, "scene and point");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace scene_impl

command scene_command() {
  return {"scene", "Compute the effects that a scene file asks for, and no others",
          "  polhode scene scenes/toutatis.toml\n"
          "  polhode scene scenes/*.toml --out results --page --plot svg\n"
          "  polhode scene scenes/toutatis.toml --set state.quaternion=[1,2,3,4] --set digits=12\n"
          "  polhode scene --set body.moments=[3,2,1] --set state.c=0.1 --set "
          "'effects.want=[\"period\"]'\n"
          "  polhode scene --list\n\n"
          "A scene is a body, its state, a time and the effects wanted (docs/scenes.md). Its "
          "numbers are\n"
          "read exactly; every number printed is certified. A run with --out that was interrupted "
          "goes on\n"
          "where it stopped: what was computed of the same scene is kept. Under mpirun the scenes "
          "and\n"
          "points are shared out to all ranks (docs/cluster.md).\n",
          scene_impl::declare, true};
}

}  // namespace polhode::cli
