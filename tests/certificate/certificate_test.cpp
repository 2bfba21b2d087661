// Certificates as data: what makes one certified, and what its JSON and its text say.

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace certificate_test {

rational from_dyadic(const json& end) {
  return rational(integer(end.at("mantissa").get<std::string>())) *
         support::power_of_two(end.at("exponent").get<long>());
}

certificate sound_certificate() {
  certificate c;
  c.claim = "example";
  c.statement = "A number is what it is.";
  c.formula = "x = sqrt(2)";
  c.reference = "eq. (1)";
  c.method = "By computing it.";
  c.inputs = {{"a", rational(1265, 100)}, {"b", rational(3)}};
  c.numbers.push_back({"x", sqrt(ball(2, 256)), 50});
  c.facts.push_back({"one is one", true});
  return c;
}

TEST(Certificate, IsCertifiedWhenAllOfItIsProved) {
  certificate c = sound_certificate();
  EXPECT_EQ(c.verdict, status::not_certified) << "before it is concluded";
  c.conclude();
  EXPECT_EQ(c.verdict, status::certified);
  EXPECT_EQ(c.why, reason::none);
}

TEST(Certificate, IsNotCertifiedWhenAFactFails) {
  for (const std::size_t position : {0U, 1U, 2U}) {
    certificate c = sound_certificate();
    c.facts.push_back({"two is two", true});
    c.facts.push_back({"three is three", true});
    c.facts[position].holds = false;
    c.verdict = status::certified;  // it is overwritten
    c.conclude(reason::refuted);
    EXPECT_EQ(c.verdict, status::not_certified);
    EXPECT_EQ(c.why, reason::refuted);
  }
}

TEST(Certificate, IsNotCertifiedWithoutItsDigits) {
  const auto verdict_with = [](const ball& x, long digits) {
    certificate c = sound_certificate();
    c.numbers.insert(c.numbers.begin(), {"y", x, digits});
    c.conclude();
    EXPECT_EQ(c.why == reason::none, c.verdict == status::certified);
    return c.verdict;
  };
  const ball x = sqrt(ball(2, 256));
  const decimal_enclosure about = to_decimal_enclosure(x, 100);
  EXPECT_EQ(verdict_with(x, about.shared), status::certified);
  EXPECT_EQ(verdict_with(x, about.digits + 1), status::not_certified);
  EXPECT_EQ(verdict_with(ball::undefined(64), 1), status::not_certified);
  EXPECT_EQ(verdict_with(ball::entire(64), 1), status::not_certified);
  EXPECT_EQ(verdict_with(hull(ball(-1, 64), ball(1, 64)), 1), status::not_certified);
  // 0.999... and 1.000... share no digit: 1 with its error has some 18.
  const ball about_one = ball(1, 64).enlarged(magnitude::power_of_two(-60));
  EXPECT_EQ(verdict_with(about_one, 1), status::certified);
  EXPECT_EQ(verdict_with(about_one, 17), status::certified);
  EXPECT_EQ(verdict_with(about_one, 20), status::not_certified);
  // Exact numbers have all their digits.
  EXPECT_EQ(verdict_with(ball(rational(1, 4), 64), 100), status::certified);
  EXPECT_EQ(verdict_with(ball(0, 64), 100), status::certified);
  EXPECT_EQ(verdict_with(ball(rational(1, 3), 64), 100), status::not_certified);
}

TEST(Certificate, ThatSaysNothingIsNotCertified) {
  certificate c;
  c.conclude();
  EXPECT_EQ(c.verdict, status::not_certified);
  c.facts.push_back({"one is one", true});
  c.conclude();
  EXPECT_EQ(c.verdict, status::certified);
  // A number without a number of digits is a misuse, and no certificate.
  c.numbers.push_back({"x", ball(rational(1, 3), 64)});
  EXPECT_THROW(c.conclude(), std::invalid_argument);
}

TEST(CertificateJson, ParsesAndNamesItsVersions) {
  certificate c = sound_certificate();
  c.facts.push_back({"a \"quoted\" fact\nin two lines, with é", true});
  c.witness["nodes"] = 217;
  c.conclude();
  const json parsed = json::parse(to_json(c).dump(2));
  EXPECT_EQ(parsed.at("format"), "polhode certificate");
  EXPECT_EQ(parsed.at("version"), 4);
  EXPECT_EQ(parsed.at("claim"), "example");
  EXPECT_EQ(parsed.at("digest").get<std::string>().size(), 7U + 64U);
  EXPECT_EQ(parsed.at("verdict"), "certified");
  EXPECT_FALSE(parsed.contains("reason"));
  for (const char* name : {"polhode", "mpfr", "gmp", "boost"}) {
    const std::string version = parsed.at("software").at(name).get<std::string>();
    EXPECT_EQ(version.find_first_not_of("0123456789.abcdefghijklmnopqrstuvwxyz-"),
              std::string::npos);
    EXPECT_NE(version.find('.'), std::string::npos) << name;
  }
  EXPECT_EQ(parsed.at("inputs").at("a"), "253/20");
  EXPECT_EQ(parsed.at("inputs").at("b"), "3");
  EXPECT_EQ(parsed.at("facts").size(), 2U);
  EXPECT_EQ(parsed.at("facts").at(1).at("statement"), c.facts[1].statement);
  EXPECT_EQ(parsed.at("facts").at(1).at("holds"), true);
  EXPECT_EQ(parsed.at("witness").at("nodes"), 217);
  const json& x = parsed.at("numbers").at("x");
  EXPECT_EQ(x.at("value"), "1.4142135623730950488016887242096980785696718753769");
  EXPECT_EQ(x.at("digits"), 50);
  EXPECT_EQ(x.at("digits_asked"), 50);

  c.facts[0].holds = false;
  c.conclude();
  EXPECT_EQ(to_json(c).at("verdict"), "not certified");
  EXPECT_EQ(to_json(c).at("reason"), "precision limit");
  EXPECT_EQ(to_json(c).at("facts").at(0).at("holds"), false);
}

TEST(CertificateJson, GivesNullForWhatIsNoNumber) {
  for (const ball& x : {ball::undefined(64), ball::entire(64), exp(ball::entire(64))}) {
    const json number = to_json(x, 20);
    EXPECT_TRUE(number.at("value").is_null());
    EXPECT_TRUE(number.at("lower").is_null());
    EXPECT_TRUE(number.at("upper").is_null());
    EXPECT_EQ(number.at("digits"), 0);
    EXPECT_TRUE(to_dyadic_json(x).is_null());
  }
  // No digit in common: a value with its error all the same.
  const json across = to_json(hull(ball(-1, 64), ball(2, 64)), 20);
  EXPECT_EQ(across.at("value"), "0.5");
  EXPECT_EQ(across.at("radius"), "1.5");
  EXPECT_EQ(across.at("rounded"), true);
  EXPECT_EQ(across.at("lower"), "-1");
  EXPECT_EQ(across.at("upper"), "2");
  const json zero = to_json(ball(0, 64), 20);
  EXPECT_EQ(zero.at("value"), "0");
  EXPECT_EQ(zero.at("exact"), true);
}

/// The form has one kind of number, an enclosure: docs/certificate.schema.json.
TEST(CertificateJson, ACertificatesNumberHasTheKeysOfTheForm) {
  certificate c = sound_certificate();
  c.numbers = {{"exactly", ball(3, 64), 10}, {"about", sqrt(ball(3, 100)), 10}};
  const json written = to_json(c);
  for (const auto& [name, number] : written.at("numbers").items()) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : number.items()) keys.push_back(key);
    // What is exact, and what is rounded, says so: tests/arithmetic.
    std::erase(keys, "exact");
    EXPECT_EQ(keys, (std::vector<std::string>{"value", "radius", "lower", "upper", "digits",
                                              "digits_asked", "dyadic"}))
        << name;
  }
}

TEST(CertificateJson, GivesTheExactEnds) {
  const json zero = to_dyadic_json(ball(0, 64));
  EXPECT_EQ(zero.at("lower").at("mantissa"), "0");
  EXPECT_EQ(zero.at("lower").at("exponent"), 0);
  const json dozen = to_dyadic_json(ball(-12, 64));
  EXPECT_EQ(dozen.at("upper").at("mantissa"), "-3");
  EXPECT_EQ(dozen.at("upper").at("exponent"), 2);
  const json quarter = to_dyadic_json(ball(rational(3, 4), 64));
  EXPECT_EQ(quarter.at("lower").at("mantissa"), "3");
  EXPECT_EQ(quarter.at("lower").at("exponent"), -2);
}

TEST(CertificateJson, DyadicsAndDecimalsEncloseTheBall) {
  support::random_source random(12);
  for (support::repeat trial(1500); trial.again();) {
    const ball x = random.any_ball();
    const long digits = random.between(1, 60);
    const json number = json::parse(to_json(x, digits).dump());
    const json dyadic = json::parse(to_dyadic_json(x).dump());
    if (!x.is_bounded()) {
      EXPECT_TRUE(dyadic.is_null());
      continue;
    }
    const support::exact_set set = support::exact(x);
    const rational low = from_dyadic(dyadic.at("lower"));
    const rational high = from_dyadic(dyadic.at("upper"));
    EXPECT_LE(low, *set.lower) << support::described(x);
    EXPECT_GE(high, *set.upper) << support::described(x);
    EXPECT_LE(high - low, set.width() + abs(*set.lower) * support::power_of_two(-60) +
                              abs(*set.upper) * support::power_of_two(-60));
    const rational decimal_low = parse_rational(number.at("lower").get<std::string>());
    const rational decimal_high = parse_rational(number.at("upper").get<std::string>());
    EXPECT_LE(decimal_low, low) << support::described(x);
    EXPECT_GE(decimal_high, high) << support::described(x);
    // No member is further from the value than the radius, nor are the decimal ends.
    const rational value = parse_rational(number.at("value").get<std::string>());
    if (number.contains("exact")) {
      EXPECT_EQ(value, low);
      EXPECT_EQ(value, high);
    } else {
      EXPECT_LE(number.at("digits").get<long>(), digits) << support::described(x);
      const rational radius = parse_rational(number.at("radius").get<std::string>());
      EXPECT_LE(value - radius, decimal_low) << support::described(x);
      EXPECT_GE(value + radius, decimal_high) << support::described(x);
      // Where it is not rounded it is every member's expansion, cut off.
      const bool negative = value < 0;
      if (!number.contains("rounded")) {
        EXPECT_LE(abs(value), negative ? rational(-*set.upper) : *set.lower)
            << support::described(x);
      }
    }
  }
}

TEST(CertificateJson, SaysHowMuchAMachineDecides) {
  certificate c = sound_certificate();
  c.facts = {{"two is two", true, step_kind::exact}};
  c.numbers.clear();
  c.conclude();
  using kinds = std::vector<std::string>;
  EXPECT_EQ(to_json(c).at("rests_on").get<kinds>(), kinds{"decided exactly"});
  EXPECT_EQ(to_json(c).at("tier"), "by machine");
  EXPECT_EQ(to_json(c).at("verdict"), "certified");
  c.numbers.push_back({"x", sqrt(ball(2, 200)), 10});
  c.argument = {{step_kind::cited, "a theorem"}, {step_kind::argued, "a thought"}};
  c.tier = proof_tier::with_words;
  const json written = to_json(c);
  EXPECT_EQ(written.at("rests_on").get<kinds>(),
            (kinds{"decided exactly", "enclosed", "argued in words", "cited"}));
  EXPECT_EQ(written.at("tier"), "by machine, joined in words");
  EXPECT_EQ(written.at("verdict"), "certified");
  EXPECT_EQ(written.at("facts").at(0).at("kind"), "decided exactly");
  EXPECT_EQ(written.at("argument").at(1).at("kind"), "argued in words");
  EXPECT_EQ(written.at("argument").at(1).at("statement"), "a thought");
  EXPECT_NE(to_text(c).find("certified by machine, joined in words"), std::string::npos);
  EXPECT_NE(to_text(c).find("[in words] a thought"), std::string::npos) << to_text(c);
  EXPECT_NE(to_text(c).find("[cited]    a theorem"), std::string::npos) << to_text(c);
  c.tier = proof_tier::by_kernel;
  c.argument = {{step_kind::kernel, "Prop1.proposition_1"}};
  EXPECT_EQ(to_json(c).at("rests_on").get<kinds>(),
            (kinds{"decided exactly", "enclosed", "proved in Coq"}));
  EXPECT_EQ(to_json(c).at("tier"), "by Coq's kernel");
  EXPECT_NE(to_text(c).find("certified by Coq's kernel (not run here"), std::string::npos);
  EXPECT_NE(to_text(c).find("[Coq]      Prop1.proposition_1"), std::string::npos) << to_text(c);
  c.facts[0].holds = false;
  c.conclude();
  EXPECT_EQ(to_json(c).at("verdict"), "not certified");
}

TEST(CertificateText, FitsAHundredColumns) {
  certificate c = sound_certificate();
  for (int i = 0; i < 30; ++i) {
    c.statement += " and it is stated at length";
    c.formula += " + " + std::to_string(i) + " x";
    c.method += " So it goes, on and on.";
    c.reference += ", eq. (" + std::to_string(i) + ")";
  }
  c.facts.push_back({c.statement, false});
  c.facts.push_back({c.method, true});
  c.numbers.push_back({"long", sqrt(ball(3, 4000)), 1000});
  c.numbers.push_back({"nothing", ball::undefined(64), 10});
  c.numbers.push_back({"whole", ball::entire(64), 10});
  c.conclude();
  const std::string text = to_text(c);
  std::istringstream lines(text);
  std::string joined;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 100U) << line;
    EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    joined += line.substr(line.find_first_not_of(' '));
  }
  // Nothing of it is lost on the way.
  const auto without_spaces = [](std::string s) {
    std::erase(s, ' ');
    return s;
  };
  EXPECT_NE(without_spaces(joined).find(without_spaces(c.formula)), std::string::npos);
  EXPECT_NE(without_spaces(joined).find(without_spaces(c.method)), std::string::npos);
  EXPECT_NE(joined.find(to_decimal_enclosure(sqrt(ball(3, 4000)), 1000).value), std::string::npos);
  EXPECT_EQ(text.substr(0, text.find('\n')), "example: not certified (precision limit)");
  EXPECT_NE(text.find("[FAILS]"), std::string::npos);
  EXPECT_NE(text.find("[exact]"), std::string::npos);
  EXPECT_NE(text.find("undefined"), std::string::npos);
  EXPECT_NE(text.find("a = 253/20"), std::string::npos);
}

TEST(CertificateText, KeepsALongWordWhole) {
  certificate c = sound_certificate();
  const std::string word(150, 'w');
  c.statement = "before " + word + " after";
  c.conclude();
  const std::string text = to_text(c);
  EXPECT_NE(text.find("\n  " + word + "\n"), std::string::npos);
  EXPECT_EQ(text.substr(0, text.find('\n')), "example: certified by machine");
}

}  // namespace certificate_test
}  // namespace polhode
