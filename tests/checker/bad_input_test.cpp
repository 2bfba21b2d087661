// What is no certificate is refused with the place named, in bounded time and memory.

#include <gtest/gtest.h>

#include <string>

#include "polhode/checker/check.hpp"
#include "proofs/claim.hpp"

namespace polhode::checker {
namespace bad_input_test {

json certificate_of(const char* claim) {
  proofs::request wanted;
  wanted.digits = 20;
  return to_json(proofs::find_claim(claim)->prove(wanted));
}

void expect_malformed(const std::string& text, const std::string& place, const std::string& word) {
  const report r = check(text);
  EXPECT_EQ(r.result, outcome::malformed) << text.substr(0, 200) << r.place << r.message;
  EXPECT_EQ(r.place, place) << r.message;
  EXPECT_NE(r.message.find(word), std::string::npos) << r.message;
}

TEST(BadInput, IsNoJson) {
  expect_malformed("", "", "byte");
  expect_malformed("nonsense", "", "byte");
  expect_malformed("{\"format\": \"\xff\"}", "/format", "byte");
  expect_malformed("[]", "", "must be an object");
  expect_malformed("null", "", "must be an object");
  expect_malformed("{}", "/format", "missing");
  expect_malformed("{\"format\": 1, \"format\": 2}", "/format", "twice");
  expect_malformed(R"({"version": 2.5})", "/version", "whole");
  expect_malformed(R"({"a": [1, 2, 1e5000]})", "/a/2", "number");
}

TEST(BadInput, TruncatedAnywhereIsRefused) {
  const std::string text = certificate_of("physical").dump();
  for (std::size_t length = 0; length < text.size(); length += 7) {
    EXPECT_EQ(check(text.substr(0, length)).result, outcome::malformed) << length;
  }
}

TEST(BadInput, AnotherFormIsRefused) {
  json c = certificate_of("physical");
  c["version"] = 2;
  expect_malformed(c.dump(), "/version", "version 4");
  c = certificate_of("physical");
  c["format"] = "a letter";
  expect_malformed(c.dump(), "/format", "polhode certificate");
  c = certificate_of("physical");
  c["claim"] = "perpetual_motion";
  expect_malformed(c.dump(), "/claim", "perpetual_motion");
  c = certificate_of("physical");
  c["claim"] = std::string(1'000'000, 'x');
  EXPECT_LT(check(c.dump()).message.size(), 300U);
}

TEST(BadInput, DeepNestingIsRefused) {
  for (const char* opening : {"[", "{\"a\":"}) {
    std::string text;
    for (int i = 0; i < 1'000'000; ++i) text += opening;
    const report r = check(text);
    EXPECT_EQ(r.result, outcome::malformed);
    EXPECT_NE(r.message.find("levels"), std::string::npos) << r.message;
  }
}

TEST(BadInput, NumbersOfAMillionDigitsAreRefused) {
  const std::string digits(1'000'000, '7');
  json c = certificate_of("physical");
  c["inputs"]["a"] = digits;
  EXPECT_EQ(check(c.dump()).place, "/inputs/a");
  EXPECT_EQ(check(c.dump()).result, outcome::not_checkable);
  c = certificate_of("physical");
  c["numbers"]["I"]["dyadic"]["lower"]["mantissa"] = digits;
  EXPECT_NE(check(c.dump()).result, outcome::verified);
  c = certificate_of("physical");
  c["numbers"]["I"]["digits"] = 1'000'000;
  EXPECT_EQ(check(c.dump()).place, "/numbers/I/digits");
  c["numbers"]["I"]["digits"] = 1LL << 60U;
  EXPECT_EQ(check(c.dump()).place, "/numbers/I/digits");
  for (const char* exponent :
       {"-4000000", "4000000", "-9223372036854775808", "99999999999999999999"}) {
    std::string text = certificate_of("physical").dump();
    const auto at = text.find("\"exponent\":") + 11;
    text.replace(at, text.find('}', at) - at, exponent);
    EXPECT_NE(check(text).result, outcome::verified) << exponent;
  }
  c = certificate_of("sign_dF_du");
  c["witness"]["quadrature"]["half_width"] = "1/" + digits;
  EXPECT_EQ(check(c.dump()).place, "/witness/quadrature/half_width");
  c = certificate_of("sign_dF_du");
  c["witness"]["quadrature"]["nodes"] = 200'000;
  EXPECT_EQ(check(c.dump()).place, "/witness/quadrature/nodes");
  c = certificate_of("beta");
  c["witness"]["scale"] = digits;
  EXPECT_EQ(check(c.dump()).place, "/witness/below/start/0");
}

TEST(BadInput, WrongTypesAreRefused) {
  const json good = certificate_of("count");
  for (const auto& [key, value] : good.items()) {
    for (const json& wrong : {json(nullptr), json(true), json(7), json("x"), json::array(),
                              json::object(), json::array({json::array()})}) {
      json c = good;
      c[key] = wrong;
      const report r = check(c.dump());
      EXPECT_NE(r.result, outcome::verified) << key << wrong;
      EXPECT_EQ(r.place.rfind('/' + key, 0), 0U) << key << wrong << r.place;
    }
  }
}

}  // namespace bad_input_test
}  // namespace polhode::checker
