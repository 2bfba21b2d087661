// Every claim, at every length, and what it must not say.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "polhode/arithmetic/text.hpp"
#include "proofs/claims.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"
#include "support/thousand_digits.hpp"

namespace polhode::proofs {
namespace claims_test {

certificate prove(std::string_view name, long digits) {
  request wanted;
  wanted.digits = digits;
  return find_claim(name)->prove(wanted);
}

::testing::AssertionResult is_certified(const certificate& c) {
  if (c.verdict == status::certified) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << to_text(c);
}

TEST(Claims, AreListed) {
#define POLHODE_NAME(name, subject) #name,
  const std::vector<std::string> names{POLHODE_CLAIMS(POLHODE_NAME)};
#undef POLHODE_NAME
  ASSERT_EQ(all_claims().size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(all_claims()[i].name, names[i]);
    EXPECT_EQ(find_claim(names[i]), &all_claims()[i]) << names[i];
  }
  EXPECT_EQ(find_claim("gamma"), nullptr);
  EXPECT_EQ(find_claim(""), nullptr);
}

TEST(Claims, AreCertifiedAtEveryLength) {
  for (const claim& c : all_claims()) {
    for (const long digits : {1L, 2L, 10L, 50L, 200L, 1000L}) {
      const certificate result = prove(c.name, digits);
      EXPECT_TRUE(is_certified(result)) << digits;
      EXPECT_EQ(result.claim, c.name);
      EXPECT_EQ(result.statement, c.statement);
      EXPECT_EQ(result.reference, c.reference);
      EXPECT_EQ(result.formula, c.formula);
      EXPECT_EQ(result.method, c.method);
      EXPECT_FALSE(result.facts.empty());
      EXPECT_EQ(result.inputs.size(),
                static_cast<std::size_t>(c.subject == claim_subject::none   ? 0
                                         : c.subject == claim_subject::body ? 2
                                                                            : 3));
      for (const enclosed_number& n : result.numbers) {
        EXPECT_EQ(n.digits, digits);
        EXPECT_GE(to_decimal_enclosure(n.enclosure, digits).digits, digits) << c.name << n.name;
      }
      EXPECT_EQ(json::parse(to_json(result).dump()).at("verdict"), "certified");
    }
  }
}

/// The second column of statements.tsv, of which scripts/check-coq asks Coq for each theorem.
std::set<std::string> theorems_in_coq() {
  std::ifstream file(POLHODE_PROOFS_DIR "/coq/paper/statements.tsv");
  std::set<std::string> result;
  for (std::string row; std::getline(file, row);) {
    const std::size_t start = row.find('\t') + 1;
    result.insert(row.substr(start, row.find('\t', start) - start));
  }
  return result;
}

/// A claim is joined in words exactly where something in it is argued in words.
TEST(Claims, SayWhatTheyRestOn) {
  const std::set<std::string> theorems = theorems_in_coq();
  ASSERT_GT(theorems.size(), 60U);
  std::vector<std::string> by_kernel;
  std::vector<std::string> by_machine;
  for (const claim& c : all_claims()) {
    const certificate result = prove(c.name, 10);
    const std::vector<step_kind> kinds = result.rests_on();
    const bool is_argued = std::count(kinds.begin(), kinds.end(), step_kind::argued) > 0;
    EXPECT_EQ(is_argued, result.tier == proof_tier::with_words) << c.name;
    bool is_in_coq = false;
    for (const stated_step& s : result.argument) {
      EXPECT_FALSE(s.statement.empty());
      if (s.kind == step_kind::kernel) {
        is_in_coq = true;
        EXPECT_TRUE(theorems.contains(s.statement)) << s.statement;
      } else {
        EXPECT_TRUE(s.kind == step_kind::argued || s.kind == step_kind::cited) << s.statement;
      }
    }
    if (result.tier == proof_tier::by_kernel) {
      EXPECT_TRUE(is_in_coq) << c.name;
      by_kernel.emplace_back(c.name);
    }
    for (const checked_fact& f : result.facts) {
      EXPECT_TRUE(f.kind == step_kind::exact || f.kind == step_kind::enclosed) << f.statement;
    }
    if (result.tier == proof_tier::by_machine) by_machine.emplace_back(c.name);
  }
  EXPECT_EQ(by_kernel, (std::vector<std::string>{"physical",
                                                 "reduced_system",
                                                 "montgomery_oscillating",
                                                 "montgomery_rotating",
                                                 "first_equation",
                                                 "separatrix_twist",
                                                 "perfect_twist",
                                                 "intersection",
                                                 "crossing",
                                                 "injectivity",
                                                 "count",
                                                 "c0_decreases",
                                                 "epsilon0_decreases",
                                                 "large_a",
                                                 "limit_formula",
                                                 "limit_minimum",
                                                 "beta",
                                                 "sign_dF_du",
                                                 "half_phase_limits",
                                                 "implicit_equations"}));
  EXPECT_EQ(by_machine,
            (std::vector<std::string>{"epsilon0_min", "delta_psi_max", "printed_numbers"}));
}

TEST(Claims, AreNotCertifiedWithoutAnyOneOfTheirParts) {
  for (const claim& c : all_claims()) {
    const certificate result = prove(c.name, 10);
    for (std::size_t i = 0; i < result.facts.size(); ++i) {
      certificate sabotaged = result;
      sabotaged.facts[i].holds = false;
      sabotaged.conclude();
      EXPECT_EQ(sabotaged.verdict, status::not_certified) << c.name << result.facts[i].statement;
    }
    for (std::size_t i = 0; i < result.numbers.size(); ++i) {
      certificate sabotaged = result;
      sabotaged.numbers[i].enclosure = ball::undefined(64);
      sabotaged.conclude();
      EXPECT_EQ(sabotaged.verdict, status::not_certified) << c.name << result.numbers[i].name;
    }
  }
}

/// The lines of proofs/README.md that are rows of its table.
std::vector<std::string> rows_of_readme() {
  std::ifstream file(POLHODE_PROOFS_DIR "/README.md");
  std::vector<std::string> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("| `", 0) == 0) rows.push_back(line);
  }
  return rows;
}

TEST(Claims, AreTheTableOfTheReadme) {
  // All cells but the time are generated from the claims: `polhode certify --format markdown`.
  const std::vector<std::string> rows = rows_of_readme();
  ASSERT_EQ(rows.size(), all_claims().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string expected = table_row(all_claims()[i]);
    EXPECT_EQ(rows[i].substr(0, expected.size()), expected);
    const std::string rest = rows[i].substr(std::min(expected.size(), rows[i].size()));
    // A time, whatever it is, and the verdict.
    const std::size_t after_time = rest.find_first_not_of(" 0123456789.");
    ASSERT_NE(after_time, std::string::npos) << rest;
    EXPECT_GT(after_time, 3U) << rest;
    const std::string tier(all_claims()[i].tier);
    EXPECT_EQ(rest.substr(after_time), "ms | certified " + tier + " |");
  }
}

/// The text of a page with spaces in place of its line breaks and of the marks of quotations.
std::string text_of_page(const std::string& path) {
  std::ifstream file(path);
  std::string text;
  for (std::string line; std::getline(file, line);) {
    text += line.rfind("> ", 0) == 0 ? line.substr(2) : line;
    text += ' ';
  }
  return text;
}

TEST(Claims, HaveAPageEachThatStatesThem) {
  for (const claim& c : all_claims()) {
    const std::string name(c.name);
    const std::string page = text_of_page(POLHODE_PROOFS_DIR "/arguments/" + name + ".md");
    EXPECT_NE(page.find(c.statement), std::string::npos) << name;
    EXPECT_NE(page.find("`polhode certify " + name + '`'), std::string::npos) << name;
  }
}

TEST(Claims, GiveTheNumbersOfMpmath) {
  for (const long digits : {10L, 1000L}) {
    EXPECT_TRUE(support::agrees(prove("beta", digits).numbers[0].enclosure, support::beta_1000,
                                digits - 1));
    EXPECT_TRUE(support::agrees(prove("epsilon0_min", digits).numbers[0].enclosure,
                                support::epsilon0_min_1000, digits - 1));
    EXPECT_TRUE(support::agrees(prove("delta_psi_max", digits).numbers[0].enclosure,
                                support::delta_psi_max_1000, digits - 1));
  }
  // mpmath 1.3.0: Carlson's form of dG/du at a = 12.65, b = 0.0629, u = 1/4.
  EXPECT_TRUE(support::agrees(prove("sign_dF_du", 55).numbers[0].enclosure,
                              "-4.10957116620648290635581535933359655217305123632116739122251",
                              54));
}

TEST(Claims, RefuseBadRequests) {
  for (const claim& c : all_claims()) {
    EXPECT_THROW((void)prove(c.name, 0), input_error) << c.name;
    EXPECT_THROW((void)prove(c.name, -50), input_error) << c.name;
  }
  const auto with = [](rational a, rational b, rational u) {
    request wanted;
    wanted.motion = {std::move(a), std::move(b), std::move(u)};
    (void)find_claim("injectivity")->prove(wanted);
    return find_claim("sign_dF_du")->prove(wanted);
  };
  EXPECT_THROW((void)with(0, rational(1, 2), rational(1, 2)), input_error);
  EXPECT_THROW((void)with(-1, rational(1, 2), rational(1, 2)), input_error);
  EXPECT_THROW((void)with(1, 1, rational(1, 2)), input_error);
  EXPECT_THROW((void)with(1, 0, rational(1, 2)), input_error);
  EXPECT_THROW((void)with(1, rational(1, 2), 0), input_error);
  EXPECT_THROW((void)with(1, rational(1, 2), rational(1001, 1000)), input_error);
}

TEST(Beta, HasASecondRouteAtEveryLength) {
  // A run of 0s or 9s in beta's digits would leave the signs at its last digit undecided.
  for (long digits = 1; digits <= 101; ++digits) {
    const certificate c = prove("beta", digits);
    EXPECT_TRUE(is_certified(c)) << digits;
    EXPECT_EQ(c.facts.size(), 2U) << digits;
    EXPECT_EQ(c.witness.at("newton").at("box").is_null(), false);
    EXPECT_GT(c.witness.at("quadrature").at("below").at("nodes").get<long>(), 0);
  }
}

TEST(SignOfSlope, IsCertifiedForAnyMotion) {
  struct row {
    const char* a;
    const char* b;
    const char* u;
    bool by_quadrature;
  };
  const auto number = [](std::string text) {
    return text.rfind("1-", 0) == 0 ? rational(1 - parse_rational(text.substr(2)))
                                    : parse_rational(text);
  };
  for (const row& r : {row{"12.65", "0.0629", "1/4", true}, row{"1e-40", "1/2", "1/4", true},
                       row{"1e40", "1/2", "1/4", true}, row{"2", "1e-40", "1/4", true},
                       row{"2", "1-1e-40", "1/4", true}, row{"2", "1/2", "1", true},
                       row{"2", "1/2", "1-1e-100", true}, row{"1e-40", "1-1e-40", "1-1e-300", true},
                       row{"2", "1/2", "1e-5", true}, row{"2", "1/2", "1e-15", false},
                       row{"2", "1/2", "3e-30", false}, row{"2", "1/2", "3e-300", false},
                       row{"1e40", "1e-40", "3e-1000", false}}) {
    for (const long digits : {1L, 30L}) {
      request wanted;
      wanted.digits = digits;
      wanted.motion = {number(r.a), number(r.b), number(r.u)};
      const certificate c = find_claim("sign_dF_du")->prove(wanted);
      EXPECT_TRUE(is_certified(c)) << r.a << " " << r.b << " " << r.u;
      EXPECT_TRUE(certainly_negative(c.numbers[0].enclosure));
      // Where the second route is left out the certificate says so.
      EXPECT_EQ(c.facts.size(), r.by_quadrature ? 6U : 5U) << r.a << " " << r.b << " " << r.u;
      EXPECT_EQ(c.witness.at("quadrature").contains("note"), !r.by_quadrature);
      EXPECT_EQ(c.witness.at("quadrature").at("verdict"),
                r.by_quadrature ? "certified" : "not certified");
    }
  }
}

TEST(SignOfSlope, RestsOnAllItsParts) {
  const certificate c = prove("sign_dF_du", 20);
  EXPECT_EQ(c.inputs.size(), 3U);
  EXPECT_EQ(c.witness.at("identity").at("points"), 528);
  EXPECT_EQ(c.witness.at("sweep").at("bound"), "3/4");
  const auto mentions = [&](const char* words) {
    return std::count_if(c.facts.begin(), c.facts.end(), [&](const checked_fact& f) {
      return f.holds && f.statement.find(words) != std::string::npos;
    });
  };
  EXPECT_EQ(mentions("equal in exact rationals at 528 points"), 1);
  EXPECT_EQ(mentions("interval sweep"), 1);
  EXPECT_EQ(mentions("by certified quadrature"), 1);
  EXPECT_EQ(mentions("AGM)"), 1);
  EXPECT_EQ(mentions("its sign is minus"), 1);
  EXPECT_EQ(mentions("holds the value above"), 1);
  // Without any one of them it is not certified.
  for (std::size_t i = 0; i < c.facts.size(); ++i) {
    certificate sabotaged = c;
    sabotaged.facts[i].holds = false;
    sabotaged.conclude();
    EXPECT_EQ(sabotaged.verdict, status::not_certified) << c.facts[i].statement;
  }
}

}  // namespace claims_test
}  // namespace polhode::proofs
