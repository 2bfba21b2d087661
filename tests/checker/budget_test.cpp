// What a check may cost: small certificates that would take minutes or gigabytes are refused, at
// the place where they would; ordinary ones are far from it. All of it is counted, so that no
// outcome here depends on a clock.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "formulas.hpp"
#include "polhode/checker/check.hpp"

namespace polhode::checker {
namespace budget_test {

using test::integral_json;
using test::make_digest_right;
using test::roots_json;

std::string in_tree(const std::string& claim) {
  std::ifstream file(std::string(POLHODE_CERTIFICATES_DIR) + '/' + claim + ".json");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string as_text(json certificate) {
  make_digest_right(certificate);
  return certificate.dump();
}

/// A twentieth of the default budget of work ends the check at that place, or deeper in it.
void expect_ended(const json& certificate, const std::string& place, std::size_t most_bytes) {
  const std::string text = as_text(certificate);
  EXPECT_LE(text.size(), most_bytes) << place;
  limits most;
  most.work /= 20;
  const report r = check(text, most);
  EXPECT_EQ(r.result, outcome::not_checkable) << place << ": at " << r.place << ": " << r.message;
  EXPECT_EQ(r.place.rfind(place, 0), 0U) << place << ": at " << r.place << ": " << r.message;
  EXPECT_NE(r.message.find("--budget"), std::string::npos) << place << ": " << r.message;
  EXPECT_LE(r.work, most.work);
}

json piece(const std::string& end, const char* rho, const char* supremum, long nodes) {
  return {{"end", end}, {"rho", rho}, {"supremum", supremum}, {"nodes", nodes}};
}

/// An integral whose number is between 2^-bits and 2^20: to show that, so many bits are tried
/// first.
json integral_between_far_ends(const std::string& f, const std::string& from, const std::string& to,
                               const json& pieces, long bits) {
  json c = integral_json("1", "0", "1", "1");
  c["inputs"] = {{"integrand", f}, {"variable", "x"}, {"from", from}, {"to", to}};
  c["formula"] = "integral from " + from + " to " + to + " of (" + f + ") dx";
  c["witness"]["pieces"] = pieces;
  c["numbers"]["integral"] = {{"value", "524288"},
                              {"radius", "524288"},
                              {"lower", "0"},
                              {"upper", "1048576"},
                              {"digits", 0},
                              {"rounded", true},
                              {"digits_asked", 1},
                              {"dyadic",
                               {{"lower", {{"mantissa", "1"}, {"exponent", -bits}}},
                                {"upper", {{"mantissa", "1"}, {"exponent", 20}}}}}};
  return c;
}

std::string repeated(const std::string& text, std::size_t length) {
  std::string all;
  while (all.size() + text.size() < length) all += text;
  return all;
}

TEST(Budget, AFunctionCostsAsItsBitsGrow) {
  const json pieces = json::array({piece("1", "2", "1000", 100)});
  const json few = integral_between_far_ends("exp(x)", "0", "1", pieces, 200);
  const report r = check(as_text(few));
  EXPECT_EQ(r.result, outcome::verified) << r.place << r.message;
  expect_ended(integral_between_far_ends("exp(x)", "0", "1", pieces, 78'000), "/witness/pieces/0",
               1500);
}

TEST(Budget, LimitsAreCharged) {
  const json pieces = json::array({piece("1", "2", "1000", 2)});
  const std::string zeros = repeated("+exp(1)-exp(1)", 19'000);
  expect_ended(integral_between_far_ends("1", "0" + zeros, "1" + zeros, pieces, 79'000),
               "/inputs/from", 80'000);
  json c = roots_json("exp(x)", "0", "1", {});
  c["inputs"]["to"] = "1" + repeated("+sin(exp(1))-sin(exp(1))", 19'000);
  c["formula"] = "exp(x) = 0 for 0 <= x <= " + c["inputs"]["to"].get<std::string>();
  EXPECT_EQ(check(as_text(c)).result, outcome::verified) << "once, at few bits, is no harm";
}

TEST(Budget, LimitsAreEvaluatedOnceForAllPieces) {
  json pieces = json::array();
  for (int i = 1; i <= 100; ++i) {
    pieces.push_back(piece(polhode::rational(i, 100).str(), "1000", "2", 4));
  }
  const std::string limit = "1" + repeated("+exp(1)-exp(1)", 700);
  const auto cost = [&](const std::string& to) {
    const report r = check(as_text(integral_between_far_ends("1", "0", to, pieces, 2000)));
    EXPECT_EQ(r.result, outcome::verified) << r.place << r.message;
    return r.work;
  };
  const auto cost_of_one = [&](const std::string& to) {
    return check(as_text(integral_between_far_ends(
                     "1", "0", to, json::array({piece("1", "1000", "2", 4)}), 2000)))
        .work;
  };
  const long of_limit = cost_of_one(limit) - cost_of_one("1");
  EXPECT_LT(cost(limit) - cost("1"), 2 * of_limit);
}

TEST(Budget, ManyPiecesOfLongLimitsAreEnded) {
  json pieces = json::array();
  for (int i = 1; i <= 1000; ++i) {
    pieces.push_back(piece(polhode::rational(i, 1000).str(), "2", "1000", 8));
  }
  const std::string zeros = repeated("+exp(1)-exp(1)", 10'000);
  expect_ended(integral_between_far_ends("exp(x)", "0" + zeros, "1" + zeros, pieces, 79'000), "/",
               120'000);
}

TEST(Budget, PowersOfFractionsAreChargedWhileTheyAreRead) {
  const json pieces = json::array({piece("1", "2", "1000", 2)});
  expect_ended(integral_between_far_ends("0*(3/2)^32767" + repeated("+0*(3/2)^32767", 19'900), "0",
                                         "1", pieces, 100),
               "/inputs/integrand", 45'000);
}

TEST(Budget, ChainsOfLongFractionsAreEnded) {
  json c = json::parse(in_tree("injectivity"));
  const report short_ones = check(as_text(c));
  EXPECT_EQ(short_ones.result, outcome::verified);
  // The same points, moved by 10^-500: their c have 1,000 digits each, and everything that is said
  // of them stays true.
  const polhode::rational little(polhode::integer(1),
                                 polhode::integer("1" + std::string(499, '0') + "7"));
  for (json& point : c["witness"]["chain"]) {
    point["c"] = polhode::rational(parse_rational(point["c"].get<std::string>()) - little).str();
  }
  expect_ended(c, "/witness/chain/", 49'000);
}

/// Every claim's certificate in the tree costs less than a quarter of what it may.
TEST(Budget, CertificatesOfTheTreeAreFarFromIt) {
  for (const auto& entry : std::filesystem::directory_iterator(POLHODE_CERTIFICATES_DIR)) {
    const report r = check(in_tree(entry.path().stem()));
    EXPECT_EQ(r.result, outcome::verified) << entry.path() << r.place << r.message;
    EXPECT_LT(4 * r.work, limits().work) << entry.path();
    EXPECT_LT(4 * r.memory, limits().memory) << entry.path();
    RecordProperty(entry.path().stem(), std::to_string(r.work));
  }
}

/// With what it costs a certificate is verified; with one unit less it is not, and the place is
/// named.
TEST(Budget, IsExact) {
  for (const std::string& text : {in_tree("beta"), in_tree("count"), in_tree("physical"),
                                  as_text(integral_json("4/(1+x^2)", "0", "1", "pi")),
                                  as_text(roots_json("x^2-2", "0", "2", {"sqrt(2)"}))}) {
    const report r = check(text);
    ASSERT_EQ(r.result, outcome::verified);
    limits most;
    most.work = r.work;
    most.memory = r.memory;
    EXPECT_EQ(check(text, most).result, outcome::verified);
    EXPECT_EQ(check(text, most).work, r.work);
    most.work = r.work - 1;
    EXPECT_EQ(check(text, most).result, outcome::not_checkable);
    most.work = r.work / 2;
    const report half = check(text, most);
    EXPECT_EQ(half.result, outcome::not_checkable);
    constexpr long of_reading = 5'000'000;  // the text, which has no place but the top
    if (r.work > of_reading) {
      EXPECT_NE(half.place, "") << half.message;
    }
    EXPECT_TRUE(half.statement.empty());
    most.work = r.work;
    most.memory = r.memory - 1;
    const report less = check(text, most);
    EXPECT_EQ(less.result, outcome::not_checkable);
    EXPECT_NE(less.message.find("--memory"), std::string::npos) << less.message;
  }
}

TEST(Budget, MemoryIsCharged) {
  limits most;
  most.memory = long{16} << 20U;
  // The rule of 8,000 nodes has 24,000 numbers of so many bits.
  const json c = integral_between_far_ends("1", "0", "1",
                                           json::array({piece("1", "2", "1000", 8000)}), 20'000);
  const report r = check(as_text(c), most);
  EXPECT_EQ(r.result, outcome::not_checkable);
  EXPECT_EQ(r.place, "/witness/pieces/0") << r.message;
  EXPECT_NE(r.message.find("--memory"), std::string::npos) << r.message;
  // A document of many small values.
  json many = integral_json("1", "0", "1", "1");
  for (int i = 0; i < 300'000; ++i) many["facts"].push_back(0);
  most.memory = long{8} << 20U;
  const report full = check(many.dump(), most);
  EXPECT_EQ(full.result, outcome::not_checkable);
  EXPECT_EQ(full.place.rfind("/facts/", 0), 0U) << full.place;
  EXPECT_NE(full.message.find("--memory"), std::string::npos) << full.message;
}

}  // namespace budget_test
}  // namespace polhode::checker
