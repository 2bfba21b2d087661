// polhode certify: what it prints and the files it writes.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "polhode/version.hpp"
#include "program.hpp"
#include "proofs/claim.hpp"

namespace polhode::test {
namespace certify_test {

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& c : proofs::all_claims()) names.emplace_back(c.name);
  return names;
}

std::vector<std::string> claims_in(const json& certificates) {
  std::vector<std::string> names;
  for (const json& c : certificates) names.push_back(c.at("claim").get<std::string>());
  return names;
}

TEST(Certify, EveryClaimIsCertified) {
  const outcome result = run({"certify"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  for (const proofs::claim& c : proofs::all_claims()) {
    std::string said = ": certified " + std::string(c.tier);
    said += c.tier == statements::by_kernel ? " (not run here: scripts/check-coq runs it)\n" : "\n";
    EXPECT_NE(result.out.find(std::string(c.name) + said), std::string::npos) << c.name;
  }
  const auto lines = lines_of(result.out);
  const auto count = static_cast<int>(all_names().size());
  EXPECT_EQ(lines.back(),
            std::to_string(count) + " claims: " + std::to_string(count) + " certified");
  for (const std::string& line : lines) EXPECT_LE(line.size(), 100U) << line;
}

TEST(Certify, JsonIsAnArrayOfCertificatesWithConsistentEnclosures) {
  const outcome result = run({"certify", "--format", "json", "--digits", "30"});
  EXPECT_EQ(result.status, 0);
  const json certificates = json::parse(result.out);
  EXPECT_EQ(claims_in(certificates), all_names());
  for (const json& c : certificates) {
    EXPECT_EQ(c.at("verdict"), "certified");
    EXPECT_FALSE(c.at("rests_on").empty());
    for (const json& number : c.at("numbers")) expect_enclosure(number, 30);
  }
}

TEST(Certify, MarkdownIsATableWithARowAClaim) {
  const outcome result = run({"certify", "beta", "errata", "--format", "markdown"});
  EXPECT_EQ(result.status, 0);
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0] + '\n' + lines[1] + '\n', proofs::table_heading());
  EXPECT_EQ(lines[2].rfind(proofs::table_row(*proofs::find_claim("beta")), 0), 0U);
  EXPECT_NE(lines[3].find(" ms | certified by machine, joined in words |"), std::string::npos);
  const outcome list = run({"certify", "--list", "--format", "markdown"});
  EXPECT_EQ(list.status, 2);
  EXPECT_NE(list.err.find("text or json"), std::string::npos);
}

TEST(Certify, ABodyIsForTheClaimsAboutBodies) {
  const outcome result =
      run({"certify", "injectivity", "count", "--ab", "18.27,0.0629", "--format", "json"});
  EXPECT_EQ(result.status, 0) << result.err;
  for (const json& c : json::parse(result.out)) EXPECT_EQ(c.at("inputs").at("a"), "1827/100");
  EXPECT_EQ(run({"certify", "errata", "--ab", "18.27,0.0629"}).status, 2);
  EXPECT_EQ(run({"certify", "injectivity", "--u", "1/4"}).status, 2);
}

TEST(Certify, NamesRunOnceInTheOrderGiven) {
  const outcome result = run({"certify", "beta", "epsilon0_min", "beta", "--format", "json"});
  EXPECT_EQ(claims_in(json::parse(result.out)), (std::vector<std::string>{"beta", "epsilon0_min"}));
  const outcome all = run({"certify", "beta", "--all", "--format", "json"});
  EXPECT_EQ(claims_in(json::parse(all.out)), all_names());
  EXPECT_EQ(lines_of(run({"certify", "beta"}).out).back(), "1 claim: 1 certified");
}

TEST(Certify, TheMotionIsReadExactly) {
  const outcome result =
      run({"certify", "sign_dF_du", "--ab", "1.5,1e-1", "--u", "1/3", "--format", "json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const json inputs = json::parse(result.out).at(0).at("inputs");
  EXPECT_EQ(inputs.at("a"), "3/2");
  EXPECT_EQ(inputs.at("b"), "1/10");
  EXPECT_EQ(inputs.at("u"), "1/3");
}

TEST(Certify, FilesAreTheCertificatesThatAreForStandardOutput) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("new/and/below/");
  const outcome result = run({"certify", "--out", directory, "--format", "json"});
  EXPECT_EQ(result.status, 0) << result.err;
  std::vector<std::string> expected;
  for (const json& c : json::parse(result.out)) {
    const std::string name = c.at("claim").get<std::string>() + ".json";
    EXPECT_EQ(json::parse(contents(directory + name)), c);
    expected.push_back(name);
  }
  std::vector<std::string> names = names_in(directory);
  std::sort(names.begin(), names.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(names, expected);
}

TEST(Certify, AnOldFileIsReplacedOnlyByAWholeOne) {
  const scratch_directory scratch;
  const std::string file = scratch.path("beta.json");
  std::ofstream(file) << "old";
  const outcome refused =
      run_script("ulimit -f 1; exec polhode certify beta --out . > /dev/null", scratch.path());
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(contents(file), "old");
  EXPECT_EQ(run({"certify", "beta", "--out", scratch.path()}).status, 0);
  EXPECT_EQ(json::parse(contents(file)).at("claim"), "beta");
  EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{"beta.json"});
}

TEST(Certify, ABodyWithIrrationalMomentsHasEveryCertificate) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("tensor");
  const outcome all = run({"certify", "--all", "--tensor", "2,3,2.5,0.1,0.2,0.1", "--digits", "20",
                           "--out", directory});
  EXPECT_EQ(all.status, 0) << all.err;
  EXPECT_NE(all.out.find("xy = 1/10"), std::string::npos);
  EXPECT_NE(all.out.find("24 claims: 24 certified"), std::string::npos);
  const outcome checked = run({"check", directory});
  EXPECT_EQ(checked.status, 0) << checked.out;
  EXPECT_NE(checked.out.find("a = 0.316345689959..., b = 0.165391237819..."), std::string::npos);
  // Principal axes that are not the tensor's, and rational moments: a and b, as ever.
  const outcome turned = run({"certify", "physical", "--tensor", "2.5,2.5,2,0.5,0,0"});
  EXPECT_EQ(turned.status, 2);
  EXPECT_NE(turned.err.find("two"), std::string::npos) << turned.err;
  const outcome rational = run({"certify", "physical", "--tensor", "2.5,2.5,2.5,0.5,0,0"});
  EXPECT_EQ(rational.status, 0) << rational.err;
  EXPECT_NE(rational.out.find("a = 1/4"), std::string::npos) << rational.out;
}

TEST(Certify, ATheoryForCoqSaysWhatIsKnownOfTheBody) {
  const scratch_directory scratch;
  const std::string path = scratch.path("body.v");
  const outcome written = run({"certify", "--coq", path, "--ab", "12.65,0.0629", "--digits", "30"});
  EXPECT_EQ(written.status, 0) << written.err;
  const std::string theory = contents(path);
  // As `polhode racket --ab 12.65,0.0629` prints them: 0.11359438234143338362950275435...,
  // 0.003129226665067...
  for (const char* part :
       {"Definition a : R := (253 / 20).", "Definition b : R := (629 / 10000).",
        "Theorem body_is_physical : physical_parameters a b.",
        "(113594382341433383629502754355 / 10^30) <", "(113594382341433383629502754356 / 10^30)",
        "(312922666506775996218395280966 / 10^32) <", "(312922666506775996218395280967 / 10^32)",
        "(twist_is_above ", "(meeting_is_below ",
        "Theorem meetings_with_S : has_exactly 1 (meeting a b).",
        "Theorem u1 : exists x, meeting_at a b 1 x /\\"}) {
    EXPECT_NE(theory.find(part), std::string::npos) << part << '\n' << theory;
  }
  ASSERT_EQ(run({"certify", "--coq", path, "--ab", "1/10,9/10", "--digits", "5"}).status, 0);
  const std::string other = contents(path);
  EXPECT_NE(other.find("Theorem body_is_not_physical : ~ physical_parameters a b."),
            std::string::npos);
  EXPECT_NE(other.find("Theorem no_c0 : forall c, ~ perfect_twist a b c."), std::string::npos);
  EXPECT_EQ(other.find("Theorem c0"), std::string::npos);
  EXPECT_NE(other.find("has_exactly 9 (meeting a b)"), std::string::npos);
  EXPECT_NE(other.find("Theorem u3"), std::string::npos);
  EXPECT_EQ(other.find("Theorem u4"), std::string::npos);
  // The moments are in the theory; brackets of few digits stay within the range, c0 < a.
  ASSERT_EQ(run({"certify", "--coq", path, "--moments", "1,2.6,2", "--digits", "1"}).status, 0);
  const std::string by_moments = contents(path);
  for (const char* part :
       {"Definition Ix : R := (13 / 5).", "Definition Iz : R := (1 / 1).",
        "Theorem parameters_of_the_moments : a = Iy / Iz - 1 /\\ b = 1 - Iy / Ix."}) {
    EXPECT_NE(by_moments.find(part), std::string::npos) << part << '\n' << by_moments;
  }
  const outcome irrational =
      run({"certify", "--coq", path, "--tensor", "2,3,4,0.1,0,-0.2", "--digits", "5"});
  EXPECT_EQ(irrational.status, 2);
  EXPECT_NE(irrational.err.find("a and b are irrational"), std::string::npos) << irrational.err;
  ASSERT_EQ(run({"certify", "--coq", path, "--ab", "1/10,1/100", "--digits", "5"}).status, 0);
  const std::string none = contents(path);
  EXPECT_NE(none.find("forall c, ~ meeting a b c"), std::string::npos);

  for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
           {"beta"}, {"--all"}, {"--list"}, {"--u", "1/4"}, {"--format", "json"}}) {
    std::vector<std::string> arguments{"certify", "--coq", path};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(run(arguments).status, 2) << wrong.front();
  }
  EXPECT_EQ(run({"certify", "--coq", scratch.path("none/body.v")}).status, 2);
  EXPECT_EQ(contents(path), none);
}

TEST(Certify, TheListFitsTheTerminal) {
  const outcome result = run({"certify", "--list"});
  EXPECT_EQ(result.status, 0);
  for (const std::string& line : lines_of(result.out)) EXPECT_LE(line.size(), 100U) << line;
  for (const std::string& name : all_names()) {
    EXPECT_NE(result.out.find('\n' + name + ' '), std::string::npos) << name;
  }
  const json list = json::parse(run({"certify", "--list", "--format", "json"}).out);
  EXPECT_EQ(claims_in(list), all_names());
  for (const json& entry : list) {
    for (const char* key : {"reference", "statement", "method"}) EXPECT_NE(entry.at(key), "");
  }
}

TEST(Help, FitsTheTerminalAndEndsWithExamples) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"--help"}, {"certify", "--help"}, {"constants", "--help"}, {"certify", "-h"}}) {
    const outcome result = run(arguments);
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    const auto examples = result.out.find("\nExamples:\n  polhode ");
    EXPECT_NE(examples, std::string::npos);
    EXPECT_EQ(result.out.find("Options:", examples), std::string::npos);
    for (const std::string& line : lines_of(result.out)) EXPECT_LE(line.size(), 100U) << line;
  }
}

TEST(Version, NamesTheLibraries) {
  const auto lines = lines_of(run({"--version"}).out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "polhode " POLHODE_VERSION);
  EXPECT_EQ(lines[1].rfind("MPFR ", 0), 0U);
  EXPECT_EQ(lines[2].rfind("GMP ", 0), 0U);
  EXPECT_EQ(lines[3].rfind("Boost ", 0), 0U);
}

TEST(Certify, ProvesTheClaimsOfManyBodies) {
  const std::vector<std::string> bodies{"certify", "--ab", "1..9/2,0.1..0.5/1", "--digits", "5"};
  const outcome all = run(bodies);
  EXPECT_EQ(all.status, 0) << all.err;
  EXPECT_NE(all.out.find("a = 5, b = 1/10\n"), std::string::npos);
  EXPECT_NE(all.out.find("at the given a, b, exactly: I < 2/(2k-1) for k = 1 ... 2"),
            std::string::npos);
  EXPECT_EQ(all.out.find("epsilon0_min: "), std::string::npos);  // is of no body
  std::size_t dependent = 0;
  for (const proofs::claim& c : proofs::all_claims()) {
    if (c.subject >= proofs::claim_subject::body) ++dependent;
  }
  EXPECT_NE(all.out.find(fmt::format("6 bodies, {} claims: ", 6 * dependent)), std::string::npos);
  std::vector<std::string> as_json = bodies;
  as_json.insert(as_json.end(), {"count", "injectivity", "--format", "json"});
  const json certificates = json::parse(run(as_json).out);
  ASSERT_EQ(certificates.size(), 12U);
  // Each is that of the body alone.
  EXPECT_EQ(
      certificates.at(7),
      json::parse(
          run({"certify", "injectivity", "--ab", "5,1/2", "--digits", "5", "--format", "json"}).out)
          .at(0));
}

TEST(Certify, WritesTheCertificatesOfManyBodies) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("bodies");
  const outcome o =
      run({"certify", "count", "physical", "--ab", "1..10/9,0.3", "--out", directory});
  EXPECT_EQ(o.status, 0) << o.err;
  const std::vector<std::string> names = names_in(directory);
  EXPECT_EQ(names.size(), 20U);
  EXPECT_TRUE(std::ranges::count(names, "count_01.json") == 1 &&
              std::ranges::count(names, "physical_10.json") == 1);
  EXPECT_EQ(run({"check", directory}).status, 0);
}

TEST(Certify, RefusesWhatIsNotOfManyBodies) {
  const auto refused = [](const std::vector<std::string>& command, const char* message) {
    const outcome o = run(command);
    EXPECT_EQ(o.status, 2) << o.out;
    EXPECT_NE(o.err.find(message), std::string::npos) << o.err;
  };
  refused({"certify", "beta", "--ab", "1..2/1,0.1"}, "beta does not depend on a body");
  refused({"certify", "--ab", "1..2,0.1"}, "the number of steps is missing");
  refused({"certify", "--ab", "2..1/3,0.1"}, "--ab");
  refused({"certify", "--ab", "0..1/3,0.1"}, "--ab: a = 0");
  refused({"certify", "--ab", "1..2/3,0.5..1/2"}, "--ab");
  refused({"certify", "--ab", "1..2/1000,0.1..0.5/1000"}, "at most 100000");
  refused({"certify", "count", "--ab", "1..2/1,0.1", "--format", "markdown"}, "text and json");
  refused({"certify", "--ab", "1..2/1,0.1", "--coq", "x.v"}, "of one body");
  refused({"certify", "--ab", "1..2/1,0.1", "--moments", "3,2,1"}, "give one of them");
  refused({"certify", "beta", "--moments", "3,2,1"}, "--moments: none of the chosen claims");
}

}  // namespace certify_test
}  // namespace polhode::test
