// polhode certify: proves claims of the paper and writes down their certificates.

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/worker_threads.hpp"
#include "cli/commands.hpp"
#include "cli/options/body_option.hpp"
#include "cli/options/file_option.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/motion_option.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/coq_theory.hpp"
#include "cli/output/layout.hpp"
#include "cli/output/output_directory.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "cli/ranks/ranks.hpp"
#include "polhode/checker/check.hpp"
#include "proofs/claim.hpp"

namespace polhode::cli {
namespace certify_impl {
namespace {

using proofs::claim;
using proofs::request;

struct certify_options {
  std::vector<std::string> names;
  bool list = false;
  bool all = false;
  digits_option digits;
  std::optional<std::string> directory;
  format_option format{{"text", "json", "markdown"}};
  body_option body;
  std::optional<std::string> u;
  file_option coq{"--coq",
                  "Write a theory for Coq that proves the numbers of the body to\nso many digits: "
                  "epsilon0, c0, and where C meets S"};
  memory_limit_option memory_limit;
  time_limit_option time_limit;
};

std::vector<const claim*> selected_claims(const certify_options& options) {
  const std::vector<std::string> all = names_of(proofs::all_claims());
  std::vector<std::string> names =
      known_names(options.names, all, "claim", "polhode certify --list");
  if (names.empty() || options.all) names = all;
  std::vector<const claim*> claims;
  claims.reserve(names.size());
  for (const std::string& name : names) claims.push_back(proofs::find_claim(name));
  return claims;
}

/// Of several bodies: the claims that depend on a body, where none is named; throws usage_error for
/// one that is named and does not.
std::vector<const claim*> claims_about_bodies(const certify_options& options,
                                              std::vector<const claim*> claims) {
  const bool is_named = !options.names.empty() && !options.all;
  std::erase_if(claims, [&](const claim* c) {
    if (c->subject >= proofs::claim_subject::body) return false;
    if (!is_named) return true;
    throw usage_error(fmt::format(
        "--ab: {} does not depend on a body; certify it without several of them", c->name));
  });
  return claims;
}

// ---------------------------------------------------------------------------------------------
// The body and the motion

/// Does it; what cannot be used is then said of that option.
template <class F>
void for_option(std::string_view option, const F& read) {
  try {
    read();
  } catch (const input_error& error) {
    throw usage_error(fmt::format("{}: {}", option, error.what()));
  }
}

constexpr std::size_t most_bodies = 100'000;

/// All bodies of --ab A,B, where A and B are numbers or LO..HI/N.
std::vector<oscillating_motion> motions_of_ranges(const std::string& text, const rational& u) {
  const auto comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos) {
    throw usage_error(
        fmt::format("--ab {}: it must be two numbers A,B such as 12.65,0.0629, or ranges "
                    "LO..HI/N of them",
                    in_quotes(text)));
  }
  const auto values = [&](const std::string& part) {
    const motion_range range = read_motions(part, "--ab");
    if (range.steps || range.low == range.high) return range.values();
    throw usage_error(
        fmt::format("--ab {}: the number of steps is missing; give {}/10", in_quotes(part), part));
  };
  std::vector<rational> all_a;
  std::vector<rational> all_b;
  for_option("--ab", [&] {
    all_a = values(text.substr(0, comma));
    all_b = values(text.substr(comma + 1));
  });
  if (all_a.size() * all_b.size() > most_bodies) {
    throw usage_error(fmt::format("--ab {}: {} bodies; at most {} are possible", in_quotes(text),
                                  all_a.size() * all_b.size(), most_bodies));
  }
  std::vector<oscillating_motion> motions;
  motions.reserve(all_a.size() * all_b.size());
  for (const rational& a : all_a) {
    for (const rational& b : all_b) motions.push_back({a, b, u});
  }
  return motions;
}

/// What is asked of all bodies that are given, and of the motion u of each.
std::vector<request> selected_requests(const certify_options& options) {
  const request usual{options.digits.value(), request{}.motion};
  std::vector<request> requests{usual};
  const std::optional<std::string>& ab = options.body.ab;
  if (ab && ab->find("..") != std::string::npos) {
    body_option others = options.body;
    others.ab.reset();
    if (others.is_given()) (void)options.body.value();  // more than one: throws
    requests.clear();
    for (oscillating_motion& motion : motions_of_ranges(*ab, usual.motion.u)) {
      requests.push_back({usual.digits, std::move(motion)});
    }
  } else if (options.body.is_given()) {
    const body given = options.body.value();
    requests = {{usual.digits, {given.a(), given.b(), usual.motion.u}, given.irrational_tensor()}};
  }
  for_option("--ab", [&] {
    for (const request& one : requests) check(one.motion);
  });
  if (options.u) {
    for_option("--u", [&] {
      const rational u = parse_rational(*options.u);
      for (request& one : requests) {
        one.motion.u = u;
        check(one.motion);
      }
    });
  }
  return requests;
}

/// Throws usage_error where a body or a motion is given and no chosen claim depends on it.
void refuse_idle_motion(const certify_options& options, const std::vector<const claim*>& claims) {
  const auto refuse_unless = [&](const char* option, proofs::claim_subject least) {
    const auto depends = [least](const claim& c) { return c.subject >= least; };
    if (std::any_of(claims.begin(), claims.end(), [&](const claim* c) { return depends(*c); })) {
      return;
    }
    std::vector<std::string> dependent;
    for (const claim& c : proofs::all_claims()) {
      if (depends(c)) dependent.emplace_back(c.name);
    }
    throw usage_error(fmt::format("{}: none of the chosen claims depends on it; these do: {}",
                                  option, fmt::join(dependent, ", ")));
  };
  if (options.body.is_given()) {
    refuse_unless(options.body.name(), proofs::claim_subject::body);
  }
  if (options.u) refuse_unless("--u", proofs::claim_subject::motion);
}

// ---------------------------------------------------------------------------------------------
// What it costs

/// A claim about a constant needs what the constant needs. Where there is no such constant, the
/// most that any of them needs is the guess.
double memory_of_proof(const claim& c, long digits) {
  if (const proofs::constant* same = proofs::find_constant(std::string(c.name)); same != nullptr) {
    return proofs::estimated_memory(*same, digits);
  }
  double most = 0;
  for (const proofs::constant& other : proofs::all_constants()) {
    most = std::max(most, proofs::estimated_memory(other, digits));
  }
  return most;
}

/// The claims about so many bodies. Claims are proved one after another; their certificates are
/// kept.
memory_estimate estimate(const std::vector<const claim*>& claims, std::size_t bodies, long digits) {
  // Measured: its decimals and its exact ends, as data and as text; and all else of one.
  constexpr double bytes_kept_per_digit = 12;
  constexpr double bytes_kept = 20'000;
  double most = 0;
  for (const claim* c : claims) most = std::max(most, memory_of_proof(*c, digits));
  std::string what = fmt::format("{} digits of ", digits);
  what += claims.size() == 1 ? std::string(claims.front()->name)
                             : fmt::format("{} claims", claims.size());
  if (bodies > 1) what += fmt::format(" about {} bodies", bodies);
  const auto certificates = static_cast<double>(claims.size() * bodies);
  return {what, most + (bytes_kept_per_digit * static_cast<double>(digits) +
                        (bodies > 1 ? bytes_kept : 0)) *
                           certificates};
}

// ---------------------------------------------------------------------------------------------
// The work

request with_digits(request wanted, long digits) {
  wanted.digits = digits;
  return wanted;
}

certificate prove(const claim& c, const request& wanted) {
  try {
    return c.prove(wanted);
  } catch (const std::domain_error& error) {
    throw not_certified_error(fmt::format("{} was not certified: {}", c.name, error.what()));
  }
}

struct timed_certificate {
  certificate result;
  double seconds = 0;
};

std::vector<timed_certificate> prove_all(const std::vector<const claim*>& claims,
                                         const request& wanted, const progress& line) {
  using clock = std::chrono::steady_clock;
  std::vector<timed_certificate> result;
  result.reserve(claims.size());
  for (const claim* c : claims) {
    line.show(fmt::format("certifying {} ({}/{})", c->name, result.size() + 1, claims.size()));
    const auto start = clock::now();
    certificate proved = prove(*c, wanted);
    const std::chrono::duration<double> time = clock::now() - start;
    result.push_back({std::move(proved), time.count()});
  }
  return result;
}

std::string file_name(const std::string& claim_name) { return claim_name + ".json"; }

std::string as_json_text(const json& value) { return value.dump(2) + '\n'; }

/// What the checker says of a certificate, before it is written. A refutation is a fault of the
/// program: it ends the run.
void expect_checkable(const certificate& c, const std::string& text) {
  if (c.verdict != status::certified) return;
  checker::limits few;
  few.work = 2'000'000'000;
  const checker::report found = checker::check(text, few);
  if (found.is_verified()) return;
  if (found.result == checker::outcome::not_checkable) {
    print_error(fmt::format(
        "note: polhode check cannot check the certificate of {} within {} steps: at {}: {}\n",
        c.claim, few.work, found.place, found.message));
    return;
  }
  throw std::logic_error(fmt::format("{}: polhode check finds its certificate {}, at {}: {}",
                                     c.claim, to_text(found.result), found.place, found.message));
}

void write_files(output_directory& directory, const std::vector<timed_certificate>& certificates) {
  for (const auto& [c, seconds] : certificates) {
    const std::string text = as_json_text(to_json(c));
    expect_checkable(c, text);
    directory.write(file_name(c.claim), text);
  }
  directory.publish();
}

// ---------------------------------------------------------------------------------------------
// What is printed

/// How many certificates have which verdict.
class tally {
 public:
  void add(std::string_view verdict, std::string_view why) {
    ++all_;
    if (verdict == "certified") ++certified_;
    if (verdict == "not certified") ++(why == to_text(reason::refuted) ? refuted_ : rest_);
  }
  [[nodiscard]] bool all_certified() const { return rest_ + refuted_ == 0; }
  /// "4 claims: 2 certified, 1 not certified, 1 refuted"
  [[nodiscard]] std::string summary() const {
    std::string result =
        fmt::format("{} claim{}: {} certified", all_, all_ == 1 ? "" : "s", certified_);
    if (rest_ > 0) result += fmt::format(", {} not certified", rest_);
    if (refuted_ > 0) result += fmt::format(", {} refuted", refuted_);
    return result + '\n';
  }

 private:
  std::size_t all_ = 0;
  std::size_t certified_ = 0;
  std::size_t refuted_ = 0;
  std::size_t rest_ = 0;
};

tally tally_of(const std::vector<timed_certificate>& certificates) {
  tally result;
  for (const auto& [c, seconds] : certificates) result.add(to_text(c.verdict), to_text(c.why));
  return result;
}

std::string certificates_as_text(const std::vector<timed_certificate>& certificates) {
  std::string result;
  for (const auto& [c, seconds] : certificates) result += to_text(c) + '\n';
  return result + tally_of(certificates).summary();
}

std::string certificates_as_json(const std::vector<timed_certificate>& certificates) {
  json result = json::array();
  for (const auto& [c, seconds] : certificates) result.push_back(to_json(c));
  return as_json_text(result);
}

/// " by machine", of what is certified.
std::string verdict_tail(const certificate& c) {
  if (c.verdict != status::certified) return "";
  return ' ' + to_text(c.tier);
}

/// The table of proofs/README.md.
std::string certificates_as_table(const std::vector<const claim*>& claims,
                                  const std::vector<timed_certificate>& certificates) {
  std::string result = proofs::table_heading();
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const auto& [c, seconds] = certificates[i];
    result += fmt::format("{} {:.1f} ms | {} |\n", proofs::table_row(*claims[i]), 1000 * seconds,
                          to_text(c.verdict) + verdict_tail(c));
  }
  return result;
}

std::string list_as_text(const std::vector<const claim*>& claims) {
  constexpr std::size_t reference_width = 20;
  constexpr std::size_t between = 2;
  std::size_t name_width = 5;
  for (const claim* c : claims) name_width = std::max(name_width, c->name.size());
  const std::size_t rest = terminal_columns - name_width - reference_width - 3 * between;
  std::vector<std::vector<std::string>> rows;
  rows.reserve(claims.size());
  for (const claim* c : claims) {
    rows.push_back({std::string(c->name), std::string(c->reference), std::string(c->statement),
                    std::string(c->technique)});
  }
  return table({{"CLAIM", name_width},
                {"IN THE PAPER", reference_width},
                {"STATEMENT", rest / 2},
                {"METHOD", rest - rest / 2}},
               rows);
}

std::string list_as_json(const std::vector<const claim*>& claims) {
  json result = json::array();
  for (const claim* c : claims) {
    result.push_back(json{{"claim", c->name},
                          {"reference", c->reference},
                          {"statement", c->statement},
                          {"method", c->technique},
                          {"tier", c->tier},
                          {"uses_body", c->subject >= proofs::claim_subject::body},
                          {"uses_motion", c->subject == proofs::claim_subject::motion}});
  }
  return as_json_text(result);
}

/// The theory of the body, in place of claims.
exit_status write_theory(certify_options& options) {
  if (!options.names.empty() || options.all || options.list || options.directory || options.u ||
      options.format.value() != "text") {
    throw usage_error(
        "--coq: it goes with a body and --digits alone; claims have certificates (--out)");
  }
  options.memory_limit.check(
      estimate({proofs::find_claim("separatrix_twist")}, 1, options.digits.value()));
  options.coq.prepare();
  const std::vector<request> requests = selected_requests(options);
  if (requests.size() > 1) throw usage_error("--coq: a theory is of one body");
  if (requests.front().tensor) {
    throw usage_error(
        fmt::format("{}: the body's a and b are irrational; theories are of rational ones: give "
                    "numbers near them by --ab (polhode body prints them)",
                    options.body.name()));
  }
  const body rigid = options.body.is_given()
                         ? options.body.value()
                         : body(requests.front().motion.a, requests.front().motion.b);
  const time_watch watch(options.time_limit.limit());
  const coq_theory theory = coq_theory_of(rigid, options.digits.value());
  options.coq.write(theory.text);
  print(fmt::format(
      "{}: a theory that says whether the body is physical, epsilon0 to {} digits,\n"
      "{}, {}\nscripts/check-coq --theory {} has Coq prove it\n",
      in_quotes(*options.coq.path), theory.defect_digits,
      theory.twist_digits == 0 ? "that there is no perfect twist"
                               : fmt::format("c0 to {}", theory.twist_digits),
      theory.meeting_digits == 0
          ? "and that C does not meet S"
          : fmt::format("and where C meets S to {}{}", theory.meeting_digits,
                        theory.are_meetings_counted ? ""
                                                    : " (how often is left out: more than 100 "
                                                      "times)"),
      *options.coq.path));
  return exit_status::all_certified;
}

// ---------------------------------------------------------------------------------------------
// Several bodies

/// A file of the k-th of so many bodies: injectivity_07.json.
std::string file_name(const std::string& claim_name, std::size_t k, std::size_t bodies) {
  return file_name(fmt::format("{}_{:0{}}", claim_name, k + 1, std::to_string(bodies).size()));
}

/// What is decided of the given body.
std::string as_lines(const json& c) {
  std::string verdict = c.at("verdict").get<std::string>();
  const auto tier = c.at("tier").get<std::string>();
  if (verdict == to_text(status::certified)) verdict += ' ' + tier;
  if (tier == to_text(proof_tier::by_kernel)) verdict += " (not run here)";
  std::string result = fmt::format("  {}: {}\n", c.at("claim").get<std::string>(), verdict);
  for (const json& fact : c.at("facts")) {
    const auto statement = fact.at("statement").get<std::string>();
    if (!statement.starts_with("at the given ")) continue;
    for (const std::string& line : wrapped(statement, terminal_columns - 4)) {
      result += "    " + line + '\n';
    }
  }
  return result;
}

/// Every body's claims, a part of the work each.
exit_status run_over_bodies(const certify_options& options, const std::vector<request>& requests,
                            const std::vector<const claim*>& claims, const std::string& what) {
  if (options.format.value() == "markdown") {
    throw usage_error("--format markdown: of several bodies there are text and json");
  }
  const long digits = options.digits.value();
  std::optional<output_directory> directory;
  if (options.directory && !ranks::is_worker()) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < requests.size(); ++k) {
      for (const claim* c : claims) {
        names.push_back(file_name(std::string(c->name), k, requests.size()));
      }
    }
    directory.emplace(*options.directory, names);
  }
  const progress line;
  detail::worker_threads threads(ranks::threads(0));
  if (!ranks::is_worker()) {
    line.show("estimating");
    std::vector<time_limit_option::work> works;
    works.reserve(claims.size());
    for (const claim* c : claims) {
      works.emplace_back(
          [&, c](long fewer) { (void)prove(*c, with_digits(requests.front(), fewer)); });
    }
    line.expect(options.time_limit.check(
        what, digits, works,
        static_cast<double>(requests.size()) / threads.count() / ranks::count()));
  }
  const time_watch watch(
      options.time_limit.limit(static_cast<double>(claims.size() * requests.size())));
  // A block of bodies is a part: on one rank they are shared out to the threads.
  constexpr std::size_t bodies_of_block = 16;
  const auto certificates_of = [&](const request& wanted) {
    json result = json::array();
    for (const claim* c : claims) {
      const certificate proved = prove(*c, wanted);
      result.push_back(to_json(proved));
      if (options.directory) expect_checkable(proved, as_json_text(result.back()));
    }
    return result;
  };
  const auto part = [&](std::size_t block) {
    const auto from = std::span(requests).subspan(block * bodies_of_block);
    const auto own = from.first(std::min(bodies_of_block, from.size()));
    std::vector<json> results(own.size());
    threads.for_each(static_cast<long>(own.size()), [&](long i) {
      const auto k = static_cast<std::size_t>(i);
      results[k] = certificates_of(own[k]);
    });
    return json(results).dump();
  };
  std::vector<std::size_t> blocks((requests.size() + bodies_of_block - 1) / bodies_of_block);
  std::iota(blocks.begin(), blocks.end(), std::size_t{0});
  std::vector<json> found(blocks.size());
  std::size_t done = 0;
  line.show_part("certifying bodies", done, blocks.size());
  ranks::distribute(blocks, part, [&](std::size_t block, const std::string& text) {
    found[block] = json::parse(text);
    line.show_part("certifying bodies", ++done, blocks.size());
  });
  tally verdicts;
  json all = json::array();
  std::string text;
  for (std::size_t k = 0; k < requests.size(); ++k) {
    json& of_body = found[k / bodies_of_block][k % bodies_of_block];
    text += fmt::format("a = {}, b = {}\n", to_text(requests[k].motion.a),
                        to_text(requests[k].motion.b));
    for (json& c : of_body) {
      const auto verdict = c.at("verdict").get<std::string>();
      verdicts.add(verdict, c.value("reason", ""));
      text += as_lines(c);
      if (directory) {
        directory->write(file_name(c.at("claim").get<std::string>(), k, requests.size()),
                         as_json_text(c));
      }
      if (options.format.value() == "json") all.push_back(std::move(c));
    }
  }
  if (directory) directory->publish();
  print(options.format.value() == "json"
            ? as_json_text(all)
            : text + fmt::format("\n{} bodies, {}", requests.size(), verdicts.summary()));
  return verdicts.all_certified() ? exit_status::all_certified : exit_status::not_certified;
}

exit_status run(certify_options& options) {
  if (options.coq.is_given()) {
    ranks::distribute({}, {}, {});  // rank 0 alone writes
    return write_theory(options);
  }
  const std::vector<request> requests = selected_requests(options);
  const std::vector<const claim*> claims =
      requests.size() == 1 ? selected_claims(options)
                           : claims_about_bodies(options, selected_claims(options));
  const request& wanted = requests.front();
  const bool as_json = options.format.value() == "json";
  const bool as_table = options.format.value() == "markdown";
  refuse_idle_motion(options, claims);
  const memory_estimate memory = estimate(claims, requests.size(), wanted.digits);
  options.memory_limit.check(memory);
  if (options.list) {
    if (as_table) throw usage_error("--format markdown: a list is text or json");
    print(as_json ? list_as_json(claims) : list_as_text(claims));
    return exit_status::all_certified;
  }
  if (requests.size() > 1) return run_over_bodies(options, requests, claims, memory.what);
  ranks::distribute({}, {}, {});  // one body is rank 0's alone

  std::optional<output_directory> directory;
  if (options.directory) {
    std::vector<std::string> names;
    names.reserve(claims.size());
    for (const claim* c : claims) names.push_back(file_name(std::string(c->name)));
    directory.emplace(*options.directory, names);
  }
  const std::vector<timed_certificate> certificates = [&] {
    const progress line;
    line.show("estimating");
    std::vector<time_limit_option::work> works;
    works.reserve(claims.size());
    for (const claim* c : claims) {
      works.emplace_back([&, c](long fewer) { (void)prove(*c, with_digits(wanted, fewer)); });
    }
    line.expect(options.time_limit.check(memory.what, wanted.digits, works));
    const time_watch watch(options.time_limit.limit(static_cast<double>(claims.size())));
    return prove_all(claims, wanted, line);
  }();
  if (directory) write_files(*directory, certificates);
  print(as_table  ? certificates_as_table(claims, certificates)
        : as_json ? certificates_as_json(certificates)
                  : certificates_as_text(certificates));
  return tally_of(certificates).all_certified() ? exit_status::all_certified
                                                : exit_status::not_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<certify_options>();
  const oscillating_motion usual = request{}.motion;
  add_option(app, "CLAIM", options->names, "Claims to prove, by name; without any, every claim")
      .type_name("");
  add_flag(app, "--list", options->list, "Show the claims instead of proving them");
  add_flag(app, "--all", options->all, "Prove every claim, whatever else is named");
  options->digits.declare(app);
  add_option(app, "--out", options->directory,
             "Write each certificate to DIR/<claim>.json as well; DIR is\n"
             "created where it is missing; all files appear, or none")
      .type_name("DIR");
  options->format.declare(app);
  options->body.declare(app, fmt::format("The body by its parameters a > 0 and 0 < b < 1, read\n"
                                         "exactly, or ranges LO..HI/N of them [{},{}]",
                                         to_text(usual.a), to_text(usual.b)));
  add_option(app, "--u", options->u,
             fmt::format("The motion's parameter, 0 < u <= 1, read exactly [{}]", to_text(usual.u)))
      .type_name("U");
  options->coq.declare(app);
  options->memory_limit.declare(app);
  options->time_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace certify_impl

command certify_command() {
  return {
      "certify", "Prove claims of the paper and write their certificates",
      "  polhode certify\n"
      "  polhode certify --list\n"
      "  polhode certify beta --digits 1000 --out certificates\n"
      "  polhode certify injectivity --ab 18.27,0.0629\n"
      "  polhode certify errata\n"
      "  polhode certify injectivity count --ab 1..9/2,0.1..0.5/1\n"
      "  mpirun -n 4 polhode certify count --ab 1..9/9,0.1..0.9/9 --out counts\n"
      "  polhode certify --coq body.v --ab 12.65,0.0629 --digits 50\n"
      "  polhode certify physical --moments 3,2,1\n"
      "  polhode certify count --tensor 2,3,2.5,0.1,0.2,0.1\n"
      "  polhode certify sign_dF_du --ab 12.65,0.0629 --u 1/4 --format json\n\n"
      "Each step says how it is decided: [exact] in rationals or by polynomials, [enclosed] in\n"
      "verified arithmetic, [Coq] by a theorem of proofs/coq, [in words], or [cited].\n"
      "Of several bodies all claims that depend on a body are proved, with what is decided of "
      "each\n"
      "body; files are DIR/<claim>_<number>.json. They are shared out to threads, or to the ranks\n"
      "of mpirun.\n",
      certify_impl::declare, true};
}

}  // namespace polhode::cli
